// SPDX-License-Identifier: GPL-2.0-or-later
// How a surface that comes without normals stands and is lit.

/// A surface that looks to one side with this share of its area, the areas that look to opposite sides having
/// been set against each other, is seen from there.
const ONE_SIDED = 0.5;
/// Seen a little from the side and from above, so that its relief shows.
const ASIDE = [0.22, 0, 0.1];

/// Twice the sum of the triangles' area vectors, and twice the area; `add(corner, vector)` is called for each
/// corner too.
function areas({ points, triangles }, add = () => {}) {
  const sum = [0, 0, 0];
  let total = 0;
  const side = (a, b, k) => points[3 * b + k] - points[3 * a + k];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
    const [x, y, z] = [side(a, b, 0), side(a, b, 1), side(a, b, 2)];
    const [u, v, w] = [side(a, c, 0), side(a, c, 1), side(a, c, 2)];
    const n = [y * w - z * v, z * u - x * w, x * v - y * u];
    for (let k = 0; k < 3; ++k) sum[k] += n[k];
    total += Math.hypot(...n);
    for (const corner of [a, b, c]) add(corner, n);
  }
  return { sum, total };
}

/// The direction from which a one-sided surface, as a scanned face is, shall be seen, or null for another. One
/// that looks along z was scanned with y upwards; it is turned, since here z is.
export function standing(pane) {
  const { sum, total } = areas(pane);
  const size = Math.hypot(...sum);
  if (!(size > ONE_SIDED * total)) return null;
  if (Math.abs(sum[2]) < 0.7 * size) return sum.map((x, i) => x / size + ASIDE[i]);
  for (const points of [pane.points, ...pane.lines.map((lines) => lines.points)])
    for (let i = 0; i < points.length; i += 3) [points[i + 1], points[i + 2]] = [-points[i + 2], points[i + 1]];
  return [sum[0], -sum[2], sum[1]].map((x, i) => x / size + ASIDE[i]);
}

/// The pane with points doubled where patches meet, and `patchOf` of each point.
export function splitByPatch(pane) {
  const { triangles, patches } = pane;
  const split = new Map();
  const from = [];
  const patchOf = [];
  const corners = triangles.map((corner, i) => {
    const patch = patches.of[Math.floor(i / 3)];
    const key = corner * 0x10000 + patch;
    if (!split.has(key)) {
      split.set(key, from.length);
      from.push(corner);
      patchOf.push(patch);
    }
    return split.get(key);
  });
  const picked = (list, size) => {
    const out = new Float32Array(size * from.length);
    from.forEach((old, i) => out.set(list.subarray(size * old, size * (old + 1)), size * i));
    return out;
  };
  return {
    ...pane,
    triangles: corners,
    points: picked(pane.points, 3),
    textures: picked(pane.textures, 2),
    field: pane.field && { ...pane.field, values: picked(pane.field.values, 1) },
    patchOf,
  };
}

/// A normal of any length for each point, the mean over its triangles by area. Points at the same place, as on
/// a seam of the texture coordinates, have the same: the seam is no crease. But where patches meet there may be
/// one, and if there is none, the means over both sides differ little.
export function normals(pane) {
  const { points, patchOf } = pane;
  const first = new Map();
  const same = new Uint32Array(points.length / 3);
  for (let i = 0; i < same.length; ++i) {
    // One number for a place: a text would take longer than all the rest. Places that share it by chance are
    // so few that nobody will see a wrong normal there.
    const key =
      points[3 * i] + Math.SQRT2 * points[3 * i + 1] + Math.PI * points[3 * i + 2] + 7 * (patchOf?.[i] ?? 0);
    if (!first.has(key)) first.set(key, i);
    same[i] = first.get(key);
  }
  const list = new Float32Array(points.length);
  areas(pane, (corner, n) => {
    for (let k = 0; k < 3; ++k) list[3 * same[corner] + k] += n[k];
  });
  same.forEach((i, j) => list.copyWithin(3 * j, 3 * i, 3 * i + 3));
  return list;
}

/// The lowest and the highest of many numbers.
export function range(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const x of values) {
    low = Math.min(low, x);
    high = Math.max(high, x);
  }
  return [low, high];
}
