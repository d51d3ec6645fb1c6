// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors of three numbers, and matrices of sixteen, column after column as WebGL wants them.

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const plus = (a, b) => a.map((x, i) => x + b[i]);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const times = (a, factor) => a.map((x) => x * factor);
export const unit = (a) => times(a, 1 / Math.hypot(...a));

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/// Stretches by three factors, then moves by an offset.
export function stretched([a, b, c], [x, y, z]) {
  return [a, 0, 0, 0, 0, b, 0, 0, 0, 0, c, 0, x, y, z, 1];
}

/// From the world to the eye of a camera at `position`, whose axes are the world's unit vectors `right`, `up`
/// and `back`.
export function toEye(position, right, up, back) {
  const rows = [right, up, back];
  const columns = [0, 1, 2].flatMap((i) => [...rows.map((row) => row[i]), 0]);
  return [...columns, ...rows.map((row) => -dot(row, position)), 1];
}

/// What a camera in perspective shows: half of its field of view has the tangent `upward`.
export function perspective(upward, aspect, near, far) {
  const depth = far - near;
  const [x, y] = [1 / (upward * aspect), 1 / upward];
  return [x, 0, 0, 0, 0, y, 0, 0, 0, 0, -(far + near) / depth, -1, 0, 0, (-2 * far * near) / depth, 0];
}

/// What a camera of parallel rays shows: as far to each side as `width`, upwards and downwards as `height`.
export function parallel(width, height, near, far) {
  const depth = far - near;
  return [1 / width, 0, 0, 0, 0, 1 / height, 0, 0, 0, 0, -2 / depth, 0, 0, 0, -(far + near) / depth, 1];
}
