// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/volume.hpp"

#include "tetrarch/hyperbolic/real50.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace tetrarch::hyperbolic {
namespace {

/// Coefficients of the two series of Clausen's function, for n = 1, 2, ...:
///   Cl(x)      = x - x log x + sum zero[n] x^(2n+1),   zero[n] = |B_2n| / (2n (2n+1)!)
///   Cl(pi - y) = y log 2     - sum half[n] y^(2n+1),   half[n] = (4^n - 1) zero[n]
/// Used for x <= 2 pi/3 and y <= pi/3, where each term is at most a ninth of the one before.
template <class Scalar>
struct ClausenSeries {
  std::vector<Scalar> zero;
  std::vector<Scalar> half;

  /// The tangent numbers T_n = 4^n (4^n - 1) |B_2n| / (2n) come from a recurrence that only adds positive
  /// numbers (Brent-Harvey 2011), so no digit is lost, in any scalar.
  ClausenSeries() {
    const int terms = static_cast<int>(std::numeric_limits<Scalar>::digits / (2 * std::log2(3.0))) + 2;
    std::vector<Scalar> tangent(static_cast<std::size_t>(terms) + 1, Scalar(1));
    for (int k = 2; k <= terms; ++k) tangent[k] = (k - 1) * tangent[k - 1];
    for (int k = 2; k <= terms; ++k)
      for (int j = k; j <= terms; ++j) tangent[j] = (j - k) * tangent[j - 1] + (j - k + 2) * tangent[j];
    Scalar power = 1;
    Scalar factorial = 1;
    for (int n = 1; n <= terms; ++n) {
      power *= 4;
      factorial *= 2 * n * (2 * n + 1);
      half.push_back(tangent[n] / (power * factorial));
      zero.push_back(half.back() / (power - 1));
    }
  }
};

template <class Scalar>
const ClausenSeries<Scalar>& clausen_series() {
  static const ClausenSeries<Scalar> series;
  return series;
}

/// sum c[n] x^(2n+1), stopped when the terms cease to count.
template <class Scalar>
Scalar odd_series(const std::vector<Scalar>& c, const Scalar& x) {
  const Scalar square = x * x;
  Scalar power = x;
  Scalar sum = 0;
  for (const Scalar& coefficient : c) {
    power *= square;
    const Scalar term = coefficient * power;
    sum += term;
    if (term < std::numeric_limits<Scalar>::epsilon() * sum / 16) break;
  }
  return sum;
}

/// The sines and cosines of a sum of some of the six angles are needed often; here as a complex number.
template <class Scalar>
struct Point {
  Scalar re;
  Scalar im;
};

/// A..F of the formula: the angles at 01, 02, 03, 23, 13, 12.
template <class Scalar>
SixNumbers<Scalar> in_ushijima_order(const SixNumbers<Scalar>& angles) {
  return {angles[0], angles[1], angles[2], angles[5], angles[4], angles[3]};
}

/// Minus the determinant of the Gram matrix of the angles; positive for a hyperbolic tetrahedron.
template <class Scalar>
Scalar minus_determinant(const SixNumbers<Scalar>& angles) {
  using std::cos;
  Matrix4<Scalar> g;
  constexpr std::array<std::array<int, 2>, 6> place{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  for (int i = 0; i < 4; ++i) g[i][i] = 1;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = place[e];
    g[i][j] = -cos(angles[5 - e]);
    g[j][i] = g[i][j];
  }
  return -determinant(g);
}

/// The common denominator ad + be + cf + abf + ace + bcd + def + abcdef.
template <class Scalar>
Point<Scalar> denominator(const SixNumbers<Scalar>& u) {
  using std::cos;
  using std::sin;
  const auto& [a, b, c, d, e, f] = u;
  Point<Scalar> sum{Scalar(0), Scalar(0)};
  for (const Scalar& exponent :
       {Scalar(a + d), Scalar(b + e), Scalar(c + f), Scalar(a + b + f), Scalar(a + c + e), Scalar(b + c + d),
        Scalar(d + e + f), Scalar(a + b + c + d + e + f)}) {
    sum.re += cos(exponent);
    sum.im += sin(exponent);
  }
  return sum;
}

/// sinA sinD + sinB sinE + sinC sinF.
template <class Scalar>
Scalar sine_sum(const SixNumbers<Scalar>& u) {
  using std::sin;
  return sin(u[0]) * sin(u[3]) + sin(u[1]) * sin(u[4]) + sin(u[2]) * sin(u[5]);
}

/// Twice Im U(e^(i phi)).
template <class Scalar>
Scalar twice_imaginary_u(const Scalar& phi, const SixNumbers<Scalar>& u) {
  const auto& [a, b, c, d, e, f] = u;
  const Scalar turned = phi + pi<Scalar>();
  return clausen(phi) + clausen(Scalar(phi + a + b + d + e)) + clausen(Scalar(phi + a + c + d + f)) +
         clausen(Scalar(phi + b + c + e + f)) - clausen(Scalar(turned + a + b + c)) -
         clausen(Scalar(turned + a + e + f)) - clausen(Scalar(turned + b + d + f)) -
         clausen(Scalar(turned + c + d + e));
}

} // namespace

template <class Scalar>
Scalar clausen(const Scalar& x) {
  using std::abs;
  using std::floor;
  using std::log;
  const Scalar half_turn = pi<Scalar>();
  Scalar r = x - 2 * half_turn * floor(Scalar(x / (2 * half_turn) + Scalar(0.5)));
  const bool negative = r < 0;
  r = abs(r);
  if (r == 0) return Scalar(0);
  Scalar value;
  if (3 * r <= 2 * half_turn) {
    value = r - r * log(r) + odd_series(clausen_series<Scalar>().zero, r);
  } else {
    const Scalar y = half_turn - r;
    value = y * log(Scalar(2)) - odd_series(clausen_series<Scalar>().half, y);
  }
  return negative ? Scalar(-value) : value;
}

template <class Scalar>
std::array<std::array<Scalar, 2>, 2> ushijima_roots(const SixNumbers<Scalar>& angles) {
  using std::sqrt;
  const SixNumbers<Scalar> u = in_ushijima_order(angles);
  const Point<Scalar> d = denominator(u);
  const Scalar s = sine_sum(u);
  const Scalar root = sqrt(minus_determinant(angles));
  const Scalar scale = -2 / (d.re * d.re + d.im * d.im);
  return {{{scale * (s * d.re - root * d.im), scale * (-root * d.re - s * d.im)},
           {scale * (s * d.re + root * d.im), scale * (root * d.re - s * d.im)}}};
}

template <class Scalar>
Scalar volume(const SixNumbers<Scalar>& angles) {
  using std::abs;
  using std::atan2;
  using std::sqrt;
  const Scalar square = minus_determinant(angles);
  if (!(square > 0)) return Scalar(0);
  const SixNumbers<Scalar> u = in_ushijima_order(angles);
  const Point<Scalar> d = denominator(u);
  const Scalar middle = pi<Scalar>() - atan2(d.im, d.re);
  const Scalar spread = atan2(Scalar(sqrt(square)), sine_sum(u));
  return abs(Scalar(twice_imaginary_u(Scalar(middle - spread), u) -
                    twice_imaginary_u(Scalar(middle + spread), u))) /
         4;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Scalar clausen(const Scalar&);                                                                    \
  template std::array<std::array<Scalar, 2>, 2> ushijima_roots(const SixNumbers<Scalar>&);                   \
  template Scalar volume(const SixNumbers<Scalar>&);
TETRARCH_INSTANTIATE(double)
TETRARCH_INSTANTIATE(Real50)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
