// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Four by four matrices over any scalar: determinant and adjugate, by the twelve 2x2 minors of the upper and
/// of the lower two rows. No division takes place, so they serve every commutative ring.

#include <array>

namespace tetrarch::numeric {

template <class Scalar>
using Matrix4 = std::array<std::array<Scalar, 4>, 4>;

/// The 2x2 minors of the upper (rows 0, 1) and the lower two rows; minor n belongs to the columns
/// edge_vertex[n].
template <class Scalar>
struct Minors {
  std::array<Scalar, 6> upper;
  std::array<Scalar, 6> lower;

  explicit Minors(const Matrix4<Scalar>& m) {
    constexpr std::array<std::array<int, 2>, 6> columns{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    for (int n = 0; n < 6; ++n) {
      const auto [i, j] = columns[n];
      upper[n] = m[0][i] * m[1][j] - m[0][j] * m[1][i];
      lower[n] = m[2][i] * m[3][j] - m[2][j] * m[3][i];
    }
  }
  Scalar determinant() const {
    return upper[0] * lower[5] - upper[1] * lower[4] + upper[2] * lower[3] + upper[3] * lower[2] -
           upper[4] * lower[1] + upper[5] * lower[0];
  }
};

template <class Scalar>
Scalar determinant(const Matrix4<Scalar>& m) {
  return Minors<Scalar>(m).determinant();
}

/// The transposed matrix of cofactors of m, whose minors the caller has: m * adjugate(m) = det(m).
template <class Scalar>
Matrix4<Scalar> adjugate(const Matrix4<Scalar>& m, const Minors<Scalar>& minors) {
  const auto& s = minors.upper;
  const auto& c = minors.lower;
  Matrix4<Scalar> a;
  a[0][0] = m[1][1] * c[5] - m[1][2] * c[4] + m[1][3] * c[3];
  a[0][1] = -m[0][1] * c[5] + m[0][2] * c[4] - m[0][3] * c[3];
  a[0][2] = m[3][1] * s[5] - m[3][2] * s[4] + m[3][3] * s[3];
  a[0][3] = -m[2][1] * s[5] + m[2][2] * s[4] - m[2][3] * s[3];
  a[1][0] = -m[1][0] * c[5] + m[1][2] * c[2] - m[1][3] * c[1];
  a[1][1] = m[0][0] * c[5] - m[0][2] * c[2] + m[0][3] * c[1];
  a[1][2] = -m[3][0] * s[5] + m[3][2] * s[2] - m[3][3] * s[1];
  a[1][3] = m[2][0] * s[5] - m[2][2] * s[2] + m[2][3] * s[1];
  a[2][0] = m[1][0] * c[4] - m[1][1] * c[2] + m[1][3] * c[0];
  a[2][1] = -m[0][0] * c[4] + m[0][1] * c[2] - m[0][3] * c[0];
  a[2][2] = m[3][0] * s[4] - m[3][1] * s[2] + m[3][3] * s[0];
  a[2][3] = -m[2][0] * s[4] + m[2][1] * s[2] - m[2][3] * s[0];
  a[3][0] = -m[1][0] * c[3] + m[1][1] * c[1] - m[1][2] * c[0];
  a[3][1] = m[0][0] * c[3] - m[0][1] * c[1] + m[0][2] * c[0];
  a[3][2] = -m[3][0] * s[3] + m[3][1] * s[1] - m[3][2] * s[0];
  a[3][3] = m[2][0] * s[3] - m[2][1] * s[1] + m[2][2] * s[0];
  return a;
}

template <class Scalar>
Matrix4<Scalar> adjugate(const Matrix4<Scalar>& m) {
  return adjugate(m, Minors<Scalar>(m));
}

} // namespace tetrarch::numeric
