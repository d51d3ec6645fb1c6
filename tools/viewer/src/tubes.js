// SPDX-License-Identifier: GPL-2.0-or-later
// Tubes about the edges: rings of vertices around each point of a curve, spanned in the tangent space of
// hyperbolic space. The shader chooses the radius (shaders.js); here stand the directions only.
import { distance, dot } from './models.js';

/// How a solid's edges look from near and from afar; those of a tiling are flat ribbons in its plane. `step`
/// skips points.
export const ROUND = { corners: 8, capped: true, step: 1 };
export const PRISM = { corners: 3, capped: false, step: 1 };
export const RIBBON = { corners: 2, capped: false, step: 1 };

/// The sides of boundary triangles are thinner than the edges of tetrahedra.
const THICKNESS = { edge: 1, side: 0.6 };

const sum = (V, W, factor) => V.map((x, i) => x + factor * W[i]);
const unit = (V) => V.map((x) => x / Math.sqrt(Math.max(dot(V, V), 1e-30)));
/// V made orthogonal to the point X, <X, X> = -1, or to the unit vector W.
const acrossPoint = (V, X) => sum(V, X, dot(V, X));
const acrossUnit = (V, W) => sum(V, W, -dot(V, W));

/// Unit tangent vectors at X across the direction T; the first is as near to `previous` as can be, so that
/// rings do not twist.
function frame(X, T, previous) {
  const axes = [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
  ].map((axis) => acrossUnit(acrossPoint(axis, X), T));
  axes.sort((V, W) => dot(W, W) - dot(V, V));
  const first = unit(previous ? acrossUnit(acrossPoint(previous, X), T) : axes[0]);
  axes.sort(
    (V, W) => Math.abs(dot(V, first)) / Math.sqrt(dot(V, V)) - Math.abs(dot(W, first)) / Math.sqrt(dot(W, W)),
  );
  return [first, unit(acrossUnit(axes[0], first))];
}

function pointAt(points, i) {
  const X = Array.from(points.subarray(4 * i, 4 * i + 4));
  X[3] = Math.sqrt(1 + X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
  return X;
}

/// The rings of one curve: those across it, and at its ends, where a tube is capped, directions along the
/// curve.
function rings(points, first, last, { corners, capped, step }, normalAt) {
  const list = [];
  let previous = null;
  for (let i = first; i < last; i = i + 1 === last ? last : Math.min(i + step, last - 1)) {
    const X = pointAt(points, i);
    const ahead = sum(
      pointAt(points, Math.min(i + 1, last - 1)),
      pointAt(points, Math.max(i - 1, first)),
      -1,
    );
    const T = unit(acrossPoint(ahead, X));
    const normal = normalAt && unit(acrossUnit(acrossPoint(normalAt(X), X), T));
    const [U, V] = normal ? frame(X, T, normal).reverse() : frame(X, T, previous);
    previous = U;
    const ring = Array.from({ length: corners }, (_, k) => {
      const angle = (2 * Math.PI * k) / corners;
      return sum(
        U.map((x) => x * Math.cos(angle)),
        V,
        Math.sin(angle),
      );
    });
    if (capped && i === first) list.push({ X, ring: ring.map(() => T.map((x) => -x)) });
    list.push({ X, ring });
    if (capped && i === last - 1) list.push({ X, ring: ring.map(() => T) });
  }
  return list;
}

/// The arrays of all tubes of a body: point, across, tetrahedron, label, thickness per vertex, and the
/// triangles. Ribbons lie in a plane or horosphere whose normal vector at X is normalAt(X).
export function tubeArrays(tubes, shape, normalAt) {
  const arrays = { point: [], across: [], tetrahedron: [], label: [], thickness: [], triangles: [] };
  const { corners } = shape;
  for (let line = 0; line + 1 < tubes.starts.length; ++line) {
    if (tubes.starts[line + 1] - tubes.starts[line] < 2) continue;
    const list = rings(tubes.points, tubes.starts[line], tubes.starts[line + 1], shape, normalAt);
    list.forEach(({ X, ring }, r) => {
      const base = arrays.tetrahedron.length;
      ring.forEach((W, k) => {
        arrays.point.push(...X);
        arrays.across.push(...W);
        arrays.tetrahedron.push(tubes.tetrahedron[line]);
        arrays.label.push(tubes.class[line]);
        arrays.thickness.push(THICKNESS[tubes.kind[line]] ?? 1);
        if (r + 1 === list.length || (corners === 2 && k === 1)) return;
        const [a, b] = [base + k, base + ((k + 1) % corners)];
        arrays.triangles.push(a, b, a + corners, b, b + corners, a + corners);
      });
    });
  }
  return arrays;
}

/// The mean hyperbolic length of the curves: what a tube's radius is measured against.
export function meanLength(tubes) {
  let total = 0;
  for (let line = 0; line + 1 < tubes.starts.length; ++line)
    for (let i = tubes.starts[line]; i + 1 < tubes.starts[line + 1]; ++i)
      total += distance(pointAt(tubes.points, i), pointAt(tubes.points, i + 1));
  return total / Math.max(1, tubes.starts.length - 1);
}
