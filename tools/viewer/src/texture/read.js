// SPDX-License-Identifier: GPL-2.0-or-later
// The data of a page of textures: two panes, a surface and its image in a domain.
import { demand, readData, unpack } from '../unpack.js';

function readLines(lines, where) {
  const points = unpack(lines.points, Float32Array, `${where}: points`);
  const count = lines.starts.length - 1;
  demand(
    3 * lines.starts[count] === points.length &&
      (lines.numbers.length === count || lines.numbers.length === 0) &&
      lines.colours.length === count,
    `${where}: the polylines differ in number.`,
  );
  return { ...lines, points };
}

function readField(field, where) {
  return field && { name: field.name, values: unpack(field.values, Float32Array, `${where}: the field`) };
}

function readPatches(patches, where) {
  return patches && { list: patches.list, of: unpack(patches.of, Int32Array, `${where}: patches`) };
}

/// A pane has the triangles, the texture coordinates, the field and the patches of the one before it, where it
/// has none of its own; null says that there are none.
function readPane(pane, before, where) {
  const read = {
    name: pane.name,
    flat: pane.flat,
    points: unpack(pane.points, Float32Array, `${where}: points`),
    triangles: pane.triangles
      ? unpack(pane.triangles, Uint32Array, `${where}: triangles`)
      : before.triangles,
    textures: pane.textures
      ? unpack(pane.textures, Float32Array, `${where}: texture coordinates`)
      : before.textures,
    field: pane.field === undefined ? before.field : readField(pane.field, where),
    patches: pane.patches === undefined ? before.patches : readPatches(pane.patches, where),
    lines: pane.lines.map((lines, i) => readLines(lines, `${where}, lines ${i}`)),
  };
  const count = read.points.length / 3;
  demand(
    count > 0 && read.textures.length === 2 * count,
    `${where}: points and texture coordinates differ in number.`,
  );
  demand(
    read.triangles.every((index) => index < count),
    `${where}: a triangle names a point that is not there.`,
  );
  demand(
    (read.field?.values.length ?? count) === count &&
      (read.patches?.of.length ?? read.triangles.length / 3) === read.triangles.length / 3,
    `${where}: the field or the patches are not as many as the points and triangles.`,
  );
  return read;
}

/// The scene in the text, or a SceneError.
export function readScene(text) {
  return readData(text, 'tetrarch texture', 'tetrarch', (data) => {
    const panes = [];
    for (const pane of data.panes) panes.push(readPane(pane, panes.at(-1), `pane ${panes.length}`));
    demand(panes.length > 0, 'The scene is empty.');
    return { panes, vByU: data.v_by_u, linesName: data.lines };
  });
}
