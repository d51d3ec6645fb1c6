// SPDX-License-Identifier: GPL-2.0-or-later
// Where a camera must stand to see points as large as can be.
import { cross, dot, unit } from './linear.js';

/// Room left around what is seen, as a factor of the distance.
const MARGIN = 1.1;
/// Moving the middle changes the distance and the other way round; it settles quickly.
const ROUNDS = 4;

/// The camera's right, up and backward direction, for one that looks from `direction` and holds z upwards.
function axesOf(direction) {
  const back = unit(direction);
  const right = unit(Math.hypot(back[0], back[1]) > 1e-6 ? cross([0, 0, 1], back) : [1, 0, 0]);
  return [right, cross(back, right), back];
}

/// The target and distance of a camera in perspective that sees all points (an array for each coordinate)
/// from a direction. tangents: of half the field of view, to the right and upwards.
export function fitPoints(points, direction, tangents) {
  const axes = axesOf(direction);
  const count = points[0].length;
  const seen = axes.map((axis) =>
    Float64Array.from({ length: count }, (_, i) => dot(axis, [points[0][i], points[1][i], points[2][i]])),
  );
  const middle = seen.map((values) => extent(values, (x) => x)).map(([low, high]) => (low + high) / 2);
  let distance = 0;
  for (let round = 0; round < ROUNDS; ++round) {
    distance = 1e-9;
    for (const side of [0, 1])
      for (let i = 0; i < count; ++i)
        distance = Math.max(
          distance,
          Math.abs(seen[side][i] - middle[side]) / tangents[side] + seen[2][i] - middle[2],
        );
    for (const side of [0, 1]) {
      const [low, high] = extent(
        seen[side],
        (x, i) => (x - middle[side]) / (distance - seen[2][i] + middle[2]),
      );
      middle[side] += (distance * (low + high)) / 2;
    }
  }
  const target = [0, 1, 2].map((i) => axes.reduce((sum, axis, k) => sum + axis[i] * middle[k], 0));
  return { target, distance: MARGIN * distance };
}

function extent(values, measure) {
  let [low, high] = [Infinity, -Infinity];
  values.forEach((value, i) => {
    const x = measure(value, i);
    low = Math.min(low, x);
    high = Math.max(high, x);
  });
  return [low, high];
}
