// SPDX-License-Identifier: GPL-2.0-or-later
// The scene that `tetrarch view` wrote into the page: read, unpacked and checked.

export class SceneError extends Error {}

const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

/// Arrays come as base64 of little-endian numbers, which is how every graphics card's machine stores them
/// too.
function unpack(text, Type, what) {
  let bytes;
  try {
    bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  } catch {
    throw new SceneError(`${what} is not base64.`);
  }
  if (bytes.length % Type.BYTES_PER_ELEMENT) throw new SceneError(`${what} ends in the middle of a number.`);
  return new Type(bytes.buffer);
}

function demand(condition, message) {
  if (!condition) throw new SceneError(message);
}

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

/// The scene in the text, or a SceneError whose message can be shown to a person.
export function readScene(text) {
  let data;
  try {
    data = JSON.parse(text);
  } catch {
    throw new SceneError('This page holds no scene: it is the empty template.');
  }
  demand(data.format === 'tetrarch view', 'The data in this page are not a scene of Tetrarch.');
  demand(
    data.version === 1,
    `The data in this page are of version ${data.version}; this page shows version 1. Write it again with \`tetrarch view\`.`,
  );
  demand(data.bodies?.length > 0, 'The scene is empty.');
  try {
    return { title: data.title, tables: data.tables ?? [], bodies: data.bodies.map(readBody) };
  } catch (error) {
    if (error instanceof SceneError) throw error;
    throw new SceneError(`The scene lacks something: ${error.message}.`);
  }
}
