// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/predicates.hpp"

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>

namespace tetrarch::numeric {
namespace {

using Rational = boost::multiprecision::mpq_rational;

template <class T>
using VectorOf = std::array<T, 3>;

template <class T>
VectorOf<T> difference(const Point& p, const Point& q) {
  return {T(p[0]) - T(q[0]), T(p[1]) - T(q[1]), T(p[2]) - T(q[2])};
}

template <class T>
T determinant(const VectorOf<T>& x, const VectorOf<T>& y, const VectorOf<T>& z) {
  const T first = x[0] * (y[1] * z[2] - y[2] * z[1]);
  const T second = x[1] * (y[2] * z[0] - y[0] * z[2]);
  const T third = x[2] * (y[0] * z[1] - y[1] * z[0]);
  return first + second + third;
}

/// The determinant with every sign taken positive.
double permanent(const VectorOf<double>& x, const VectorOf<double>& y, const VectorOf<double>& z) {
  const auto a = [](double value) { return std::fabs(value); };
  return a(x[0]) * (a(y[1] * z[2]) + a(y[2] * z[1])) + a(x[1]) * (a(y[2] * z[0]) + a(y[0] * z[2])) +
         a(x[2]) * (a(y[0] * z[1]) + a(y[1] * z[0]));
}

double largest(const VectorOf<double>& x) {
  return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
}

/// Each of the six products goes through eight roundings: three differences, two multiplications, one
/// subtraction, two additions. The bound allows for sixteen, which covers those of the bound itself.
constexpr double relative_error = 16 * (std::numeric_limits<double>::epsilon() / 2);
/// Up to this length of the differences nothing overflows, and what underflows (below 1e-307 times a
/// difference) stays far under the least determinant that is believed.
constexpr double longest_difference = 1e100;
constexpr double least_determinant = 1e-200;

} // namespace

Sign volume_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto x = difference<double>(b, a);
  const auto y = difference<double>(c, a);
  const auto z = difference<double>(d, a);
  const double det = determinant(x, y, z);
  const double least = least_determinant + relative_error * permanent(x, y, z);
  const bool in_range = std::max({largest(x), largest(y), largest(z)}) < longest_difference;
  if (const Sign sign = sign_beyond(det, least); in_range && sign != Sign::undecided) return sign;
  // GMP ends the program where a number is none. Differences of finite numbers may be infinite, sums of no
  // numbers are none.
  for (const Point& p : {a, b, c, d})
    if (!std::isfinite(p[0] * 0 + p[1] * 0 + p[2] * 0)) return Sign::undecided;
  const Rational exact =
      determinant(difference<Rational>(b, a), difference<Rational>(c, a), difference<Rational>(d, a));
  return static_cast<Sign>(exact.sign());
}

} // namespace tetrarch::numeric
