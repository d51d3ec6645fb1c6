// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/mobius.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <limits>
#include <utility>

namespace tetrarch::embed {
namespace {

template <class Scalar>
Complex<Scalar> operator+(const Complex<Scalar>& z, const Complex<Scalar>& w) {
  return {z.re + w.re, z.im + w.im};
}
template <class Scalar>
Complex<Scalar> operator-(const Complex<Scalar>& z, const Complex<Scalar>& w) {
  return {z.re - w.re, z.im - w.im};
}
template <class Scalar>
Complex<Scalar> operator*(const Complex<Scalar>& z, const Complex<Scalar>& w) {
  return {z.re * w.re - z.im * w.im, z.re * w.im + z.im * w.re};
}
template <class Scalar>
Complex<Scalar> operator/(const Complex<Scalar>& z, const Scalar& s) {
  return {z.re / s, z.im / s};
}
template <class Scalar>
Complex<Scalar> conjugate(const Complex<Scalar>& z) {
  return {z.re, -z.im};
}
template <class Scalar>
Scalar magnitude(const Complex<Scalar>& z) {
  using std::sqrt;
  return sqrt(Scalar(z.re * z.re + z.im * z.im));
}

/// Each part from the one that does not cancel.
template <class Scalar>
Complex<Scalar> square_root(const Complex<Scalar>& z) {
  using std::sqrt;
  const Scalar r = magnitude(z);
  if (z.re >= 0) {
    const Scalar u = sqrt(Scalar((r + z.re) / 2));
    return {u, u == 0 ? Scalar(0) : Scalar(z.im / (2 * u))};
  }
  const Scalar v = z.im < 0 ? Scalar(-sqrt(Scalar((r - z.re) / 2))) : Scalar(sqrt(Scalar((r - z.re) / 2)));
  return {Scalar(z.im / (2 * v)), v};
}

template <class Scalar>
using Matrix2 = std::array<std::array<Complex<Scalar>, 2>, 2>;

template <class Scalar>
Matrix2<Scalar> matrix_of(const Mobius<Scalar>& m) {
  return {{{m.a, m.b}, {m.c, m.d}}};
}

template <class Scalar>
Matrix2<Scalar> product(const Matrix2<Scalar>& m, const Matrix2<Scalar>& n) {
  Matrix2<Scalar> p;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) p[i][j] = m[i][0] * n[0][j] + m[i][1] * n[1][j];
  return p;
}

template <class Scalar>
Matrix2<Scalar> conjugated(const Matrix2<Scalar>& m) {
  return {{{conjugate(m[0][0]), conjugate(m[0][1])}, {conjugate(m[1][0]), conjugate(m[1][1])}}};
}

template <class Scalar>
Matrix2<Scalar> adjoint(const Matrix2<Scalar>& m) {
  return {{{conjugate(m[0][0]), conjugate(m[1][0])}, {conjugate(m[0][1]), conjugate(m[1][1])}}};
}

/// X of the vector v, complex-linear in v.
template <class Scalar>
Matrix2<Scalar> hermitian(const Vector4<Scalar>& v) {
  return {{{Complex<Scalar>{v[3] + v[2]}, Complex<Scalar>{v[0], v[1]}},
           {Complex<Scalar>{v[0], Scalar(-v[1])}, Complex<Scalar>{v[3] - v[2]}}}};
}

template <class Scalar>
Vector4<Scalar> column(const Matrix4<Scalar>& m, int j) {
  return {m[0][j], m[1][j], m[2][j], m[3][j]};
}

/// The matrix A up to a factor of modulus 1, from the rank-one matrices P_jk = (column j of A)(column k of
/// A)*: the longer column from P_jj, the other one from P_01, each read in the row where the first is larger.
template <class Scalar>
Matrix2<Scalar> up_to_phase(const Matrix4<Scalar>& m) {
  using std::sqrt;
  const Vector4<Scalar> z = column(m, 2);
  const Vector4<Scalar> t = column(m, 3);
  const Scalar half = Scalar(1) / 2;
  const auto p00 = hermitian(combination(half, t, half, z));
  const auto p11 = hermitian(combination(half, t, Scalar(-half), z));
  const auto x = hermitian(column(m, 0));
  const auto y = hermitian(column(m, 1));
  Matrix2<Scalar> p01; // the image of (e_x - i e_y) / 2
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) p01[i][j] = {(x[i][j].re + y[i][j].im) / 2, (x[i][j].im - y[i][j].re) / 2};

  const int long_column = p00[0][0].re + p00[1][1].re >= p11[0][0].re + p11[1][1].re ? 0 : 1;
  const auto& square = long_column == 0 ? p00 : p11;
  const int r = square[0][0].re >= square[1][1].re ? 0 : 1;
  const Scalar pivot = sqrt(square[r][r].re);
  Matrix2<Scalar> a;
  a[r][long_column] = {pivot};
  a[1 - r][long_column] = square[1 - r][r] / pivot;
  for (int i = 0; i < 2; ++i)
    a[i][1 - long_column] = (long_column == 0 ? conjugate(p01[r][i]) : p01[i][r]) / pivot;
  return a;
}

} // namespace

template <class Scalar>
Mobius<Scalar> composed(const Mobius<Scalar>& m, const Mobius<Scalar>& n) {
  const Matrix2<Scalar> right = matrix_of(n);
  const Matrix2<Scalar> p = product(matrix_of(m), m.reverses ? conjugated(right) : right);
  return {p[0][0], p[0][1], p[1][0], p[1][1], m.reverses != n.reverses};
}

template <class Scalar>
Mobius<Scalar> mobius_of(const Matrix4<Scalar>& m) {
  const bool reverses = numeric::determinant(m) < 0;
  Matrix4<Scalar> proper = m;
  if (reverses)
    for (auto& row : proper) row[1] = -row[1];
  const Matrix2<Scalar> a = up_to_phase(proper);
  const Complex<Scalar> root = square_root(Complex<Scalar>(a[0][0] * a[1][1] - a[0][1] * a[1][0]));
  const Scalar norm = root.re * root.re + root.im * root.im;
  const Complex<Scalar> factor = conjugate(root) / norm;
  return {a[0][0] * factor, a[0][1] * factor, a[1][0] * factor, a[1][1] * factor, reverses};
}

template <class Scalar>
Matrix4<Scalar> lorentz_of(const Mobius<Scalar>& mobius) {
  const Matrix2<Scalar> a = matrix_of(mobius);
  Matrix4<Scalar> m;
  for (int j = 0; j < 4; ++j) {
    Vector4<Scalar> basis{};
    basis[j] = Scalar(j == 1 && mobius.reverses ? -1 : 1);
    const Matrix2<Scalar> x = product(product(a, hermitian(basis)), adjoint(a));
    m[0][j] = x[0][1].re;
    m[1][j] = x[0][1].im;
    m[2][j] = (x[0][0].re - x[1][1].re) / 2;
    m[3][j] = (x[0][0].re + x[1][1].re) / 2;
  }
  return m;
}

template <class Scalar>
Scalar relative_difference(const Mobius<Scalar>& m, const Mobius<Scalar>& n) {
  if (m.reverses != n.reverses) return std::numeric_limits<Scalar>::infinity();
  const Matrix2<Scalar> p = matrix_of(m);
  const Matrix2<Scalar> q = matrix_of(n);
  Scalar plus = 0;
  Scalar minus = 0;
  Scalar largest = 0;
  const auto raise = [](Scalar& most, const Scalar& x) {
    if (!(x <= most)) most = x;
  };
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      raise(minus, magnitude(p[i][j] - q[i][j]));
      raise(plus, magnitude(p[i][j] + q[i][j]));
      raise(largest, magnitude(q[i][j]));
    }
  return (minus < plus ? minus : plus) / largest;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Mobius<Scalar> composed(const Mobius<Scalar>&, const Mobius<Scalar>&);                            \
  template Mobius<Scalar> mobius_of(const Matrix4<Scalar>&);                                                 \
  template Matrix4<Scalar> lorentz_of(const Mobius<Scalar>&);                                                \
  template Scalar relative_difference(const Mobius<Scalar>&, const Mobius<Scalar>&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
