// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/lorentz.hpp"

#include "tetrarch/numeric/instantiate.hpp"

namespace tetrarch::embed {
namespace {

template <class Scalar>
Scalar largest_entry(const Matrix4<Scalar>& m) {
  using std::abs;
  Scalar largest = 0;
  for (const auto& row : m)
    for (const Scalar& x : row)
      if (!(abs(x) <= largest)) largest = abs(x); // not a number comes through
  return largest;
}

template <class Scalar>
Matrix4<Scalar> difference(const Matrix4<Scalar>& m, const Matrix4<Scalar>& n) {
  Matrix4<Scalar> d;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) d[i][j] = m[i][j] - n[i][j];
  return d;
}

} // namespace

template <class Scalar>
Scalar lorentz_defect(const Matrix4<Scalar>& m) {
  return largest_entry(difference(inverse(m) * m, identity<Scalar>()));
}

template <class Scalar>
Matrix4<Scalar> reorthonormalized(const Matrix4<Scalar>& m) {
  Matrix4<Scalar> result = m;
  for (int step = 0; step < 2; ++step) {
    Matrix4<Scalar> correction = inverse(result) * result;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) correction[i][j] = (Scalar(i == j ? 3 : 0) - correction[i][j]) / 2;
    result = result * correction;
  }
  return result;
}

template <class Scalar>
Scalar relative_difference(const Matrix4<Scalar>& m, const Matrix4<Scalar>& n) {
  return largest_entry(difference(m, n)) / largest_entry(n);
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Scalar lorentz_defect(const Matrix4<Scalar>&);                                                    \
  template Matrix4<Scalar> reorthonormalized(const Matrix4<Scalar>&);                                        \
  template Scalar relative_difference(const Matrix4<Scalar>&, const Matrix4<Scalar>&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
