// SPDX-License-Identifier: GPL-2.0-or-later
// The scene that `tetrarch view` wrote into the page.
import { demand, readData, unpack } from './unpack.js';

const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

function readSurface(surface, where) {
  const read = {
    kind: surface.kind,
    points: unpack(surface.points, Float32Array, `${where}: points`),
    normals: unpack(surface.normals, Float32Array, `${where}: normals`),
    triangles: unpack(surface.triangles, Uint32Array, `${where}: triangles`),
    tetrahedron: unpack(surface.tetrahedron, Int32Array, `${where}: tetrahedron`),
    class: unpack(surface.class, Int32Array, `${where}: class`),
  };
  const count = read.points.length / 4;
  demand(
    read.normals.length === 4 * count && read.tetrahedron.length === count && read.class.length === count,
    `${where}: points, normals, tetrahedron and class differ in length.`,
  );
  demand(
    read.triangles.every((index) => index < count),
    `${where}: a triangle names a point that is not there.`,
  );
  return read;
}

function readTubes(tubes, where) {
  if (!tubes) return { points: new Float32Array(0), starts: [0], tetrahedron: [], class: [], kind: [] };
  const points = unpack(tubes.points, Float32Array, `${where}: points`);
  const lines = tubes.starts.length - 1;
  demand(
    4 * tubes.starts[lines] === points.length &&
      tubes.tetrahedron.length === lines &&
      tubes.class.length === lines &&
      tubes.kind.length === lines,
    `${where}: the polylines differ in number.`,
  );
  return { ...tubes, points };
}

function readShape(shape, where) {
  return {
    surfaces: shape.surfaces.map((surface, i) => readSurface(surface, `${where}, surface ${i}`)),
    tubes: readTubes(shape.tubes, `${where}, tubes`),
  };
}

function readBody(body, index) {
  const where = `body ${index}`;
  demand(
    ['space', 'vertical', 'horizontal'].includes(body.view),
    `${where}: the view "${body.view}" is not known.`,
  );
  const matrices = unpack(body.copies.matrices, Float32Array, `${where}: matrices`);
  const length = unpack(body.copies.length, Int32Array, `${where}: word lengths`);
  demand(
    length.length > 0 && matrices.length === 16 * length.length,
    `${where}: matrices and word lengths differ in number.`,
  );
  demand(body.tetrahedra.length > 0, `${where}: there is no tetrahedron.`);
  const frame = body.half_space_frame
    ? unpack(body.half_space_frame, Float32Array, `${where}: half space frame`)
    : IDENTITY;
  demand(frame.length === 16, `${where}: the half space frame is not a matrix.`);
  return {
    name: body.name,
    view: body.view,
    shown: body.shown,
    frame,
    tetrahedra: body.tetrahedra,
    ...readShape(body, where),
    coarse: body.coarse && readShape(body.coarse, `${where}, coarse`),
    copies: { matrices, length, count: length.length },
  };
}

/// The scene in the text, or a SceneError.
export function readScene(text) {
  return readData(text, 'tetrarch view', 'tetrarch view', (data) => {
    demand(data.bodies?.length > 0, 'The scene is empty.');
    return { bodies: data.bodies.map(readBody) };
  });
}
