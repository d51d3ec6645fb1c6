// SPDX-License-Identifier: GPL-2.0-or-later
// Hyperbolic space on the processor: what fitting the camera needs. The pictures themselves are computed by
// the graphics card from the same formulas (shaders.js).
//
// A point is X = (x, y, z, t) with xx + yy + zz - tt = -1, t > 0; a motion is a Lorentz matrix, stored column
// after column.

/// The models by their name in the page's address, in the order of the shader's numbers.
export const MODELS = ['half', 'ball', 'klein'];

/// t - z without the cancellation that a point high up in the half space would suffer.
function below(X) {
  return X[2] > 0 ? (1 + X[0] * X[0] + X[1] * X[1]) / (X[3] + X[2]) : X[3] - X[2];
}

/// The point X in the model.
function project(model, X) {
  if (model === 'half') {
    const s = below(X);
    return [X[0] / s, X[1] / s, 1 / s];
  }
  const s = model === 'ball' ? 1 + X[3] : X[3];
  return [X[0] / s, X[1] / s, X[2] / s];
}

/// The image of X under the motion that starts at matrices[16 * copy].
function moved(matrices, copy, X) {
  const Y = [0, 0, 0, 0];
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row) Y[row] += matrices[16 * copy + 4 * column + row] * X[column];
  return Y;
}

/// Where the model shows the point X of a copy of the body. A body may be turned before it is seen in the
/// half space.
export function placed(body, model, copy, X) {
  const Y = moved(body.copies.matrices, copy, X);
  return project(model, model === 'half' ? moved(body.frame, 0, Y) : Y);
}

/// <X, Y> in R^{3,1}.
export function dot(X, Y) {
  return X[0] * Y[0] + X[1] * Y[1] + X[2] * Y[2] - X[3] * Y[3];
}

/// The hyperbolic distance of two points.
export function distance(X, Y) {
  return Math.acosh(Math.max(1, -dot(X, Y)));
}

/// What stays in place when the tetrahedra move apart. In the half space it is the foot of the first centre
/// on the plane at infinity, not the centre itself: seen from there every piece moves up and out, and none
/// sinks below the plane.
export function anchor(body, model) {
  const p = placed(body, model, 0, body.tetrahedra[0].centre);
  return model === 'half' ? [p[0], p[1], 0] : p;
}
