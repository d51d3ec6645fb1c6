// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// R^{3,1} and its isometries.
///
/// A vector is (x, y, z, t) with <v,w> = xx' + yy' + zz' - tt'. Hyperbolic space is the sheet <v,v> = -1,
/// t > 0; its base point is (0,0,0,1). A vector n with <n,n> = 1 stands for the plane <x,n> = 0 and for the
/// half-space <x,n> <= 0, whose outward normal it is; a vector v of the light cone with t > 0 for the
/// horosphere -<x,v> = 1. An isometry is a matrix M with M^T J M = J, J = diag(1,1,1,-1), that keeps the
/// sheet; it acts on points, planes and horospheres alike by v -> M v. Law: det M = -1 exactly if it reverses
/// orientation.
///
/// Templates over the scalar: only the field operations, square roots, and inverse hyperbolic functions where
/// a length is asked for.

#include "tetrarch/numeric/matrix4.hpp"

#include <array>
#include <cmath>

namespace tetrarch::embed {

using numeric::Matrix4;

template <class Scalar>
using Vector4 = std::array<Scalar, 4>;

template <class Scalar>
inline const Vector4<Scalar> base_point{Scalar(0), Scalar(0), Scalar(0), Scalar(1)};

template <class Scalar>
Scalar inner(const Vector4<Scalar>& v, const Vector4<Scalar>& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2] - v[3] * w[3];
}

/// a v + b w.
template <class Scalar>
Vector4<Scalar> combination(const Scalar& a, const Vector4<Scalar>& v, const Scalar& b,
                            const Vector4<Scalar>& w) {
  return {a * v[0] + b * w[0], a * v[1] + b * w[1], a * v[2] + b * w[2], a * v[3] + b * w[3]};
}

template <class Scalar>
Vector4<Scalar> scaled(const Scalar& a, const Vector4<Scalar>& v) {
  return {a * v[0], a * v[1], a * v[2], a * v[3]};
}

/// v / sqrt(|<v,v>|): the point of hyperbolic space on the ray of a time-like v, the unit normal of a
/// space-like one.
template <class Scalar>
Vector4<Scalar> normalized(const Vector4<Scalar>& v) {
  using std::abs;
  using std::sqrt;
  return scaled(Scalar(1 / sqrt(Scalar(abs(inner(v, v))))), v);
}

/// The point in the middle of points, in the sense of the centroid in R^{3,1}. Law: isometries keep it.
template <class Points>
auto centroid(const Points& points) {
  using Vector = typename Points::value_type;
  Vector sum{};
  for (const Vector& p : points)
    for (int k = 0; k < 4; ++k) sum[k] += p[k];
  return normalized(sum);
}

/// Where the line from x to the center of v's horosphere meets that horosphere; `norm` is <x,x>: -1, 0 or 1.
template <class Scalar>
Vector4<Scalar> onto_horosphere(const Vector4<Scalar>& x, const Vector4<Scalar>& v, int norm = -1) {
  const Scalar w = inner(x, v); // <result, v> = -1 and <result, result> = -1
  return combination(Scalar((1 + norm / (w * w)) / 2), v, Scalar(-1 / w), x);
}

/// The vector with <result, x> = det(u, v, w, x): perpendicular to the three.
template <class Scalar>
Vector4<Scalar> cross(const Vector4<Scalar>& u, const Vector4<Scalar>& v, const Vector4<Scalar>& w) {
  const Matrix4<Scalar> cofactors = numeric::adjugate(
      Matrix4<Scalar>{{{u[0], u[1], u[2], u[3]}, {v[0], v[1], v[2], v[3]}, {w[0], w[1], w[2], w[3]}, {}}});
  return {cofactors[0][3], cofactors[1][3], cofactors[2][3], Scalar(-cofactors[3][3])};
}

template <class Scalar>
Matrix4<Scalar> identity() {
  Matrix4<Scalar> m{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = Scalar(i == j ? 1 : 0);
  return m;
}

template <class Scalar>
Matrix4<Scalar> matrix_with_columns(const std::array<Vector4<Scalar>, 4>& columns) {
  Matrix4<Scalar> m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = columns[j][i];
  return m;
}

template <class Scalar>
Vector4<Scalar> operator*(const Matrix4<Scalar>& m, const Vector4<Scalar>& v) {
  Vector4<Scalar> image;
  for (int i = 0; i < 4; ++i) image[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2] + m[i][3] * v[3];
  return image;
}

template <class Scalar>
Matrix4<Scalar> operator*(const Matrix4<Scalar>& m, const Matrix4<Scalar>& n) {
  Matrix4<Scalar> product;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      product[i][j] = m[i][0] * n[0][j] + m[i][1] * n[1][j] + m[i][2] * n[2][j] + m[i][3] * n[3][j];
  return product;
}

/// Of an isometry: J M^T J. Exact.
template <class Scalar>
Matrix4<Scalar> inverse(const Matrix4<Scalar>& m) {
  Matrix4<Scalar> result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) result[i][j] = (i == 3) == (j == 3) ? m[j][i] : Scalar(-m[j][i]);
  return result;
}

/// The isometry that takes the base point to x along their geodesic and turns nothing.
template <class Scalar>
Matrix4<Scalar> boost_to(const Vector4<Scalar>& x) {
  Matrix4<Scalar> m = identity<Scalar>();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] += x[i] * x[j] / (1 + x[3]);
    m[i][3] = x[i];
    m[3][i] = x[i];
  }
  m[3][3] = x[3];
  return m;
}

/// max |M^T J M - J|. The entries of M grow like e^d where M moves the base point by d, and the rounding in
/// this number like e^2d: it is meaningful for isometries that move the base point a little.
template <class Scalar>
Scalar lorentz_defect(const Matrix4<Scalar>& m);

/// The isometry nearest to m, up to the square of its defect: M (3 - J M^T J M) / 2, a step of Newton's
/// method for the polar decomposition, taken twice. For isometries that move things a little: see
/// `lorentz_defect`.
template <class Scalar>
Matrix4<Scalar> reorthonormalized(const Matrix4<Scalar>& m);

/// max |M - N| / max |N|: how two isometries are compared.
template <class Scalar>
Scalar relative_difference(const Matrix4<Scalar>& m, const Matrix4<Scalar>& n);

/// Of two points: by the inner product where they are far apart, by the difference, which loses no digits,
/// where they are close.
template <class Scalar>
Scalar distance(const Vector4<Scalar>& x, const Vector4<Scalar>& y) {
  using std::acosh;
  using std::asinh;
  using std::sqrt;
  const Scalar cosh = -inner(x, y);
  if (cosh > 2) return acosh(cosh);
  const Vector4<Scalar> d = combination(Scalar(1), x, Scalar(-1), y);
  const Scalar square = inner(d, d);
  return square > 0 ? Scalar(2 * asinh(Scalar(sqrt(square) / 2))) : Scalar(0);
}

} // namespace tetrarch::embed
