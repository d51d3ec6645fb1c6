// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/flat_triangle.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::numeric {

using Complex = std::complex<double>;

namespace {

/// Edges 01 and 02 laid flat.
FlatTriangle laid_flat(const Vector& a, const Vector& b) {
  const double base = length(a);
  return {0.0, base, {dot(a, b) / base, length(cross(a, b)) / base}};
}

} // namespace

FlatTriangle laid_flat(const std::vector<Point>& points, const std::array<int, 3>& corners) {
  const Vector a = points[corners[1]] - points[corners[0]];
  const Vector b = points[corners[2]] - points[corners[0]];
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::abs(a[k]), std::abs(b[k])});
  constexpr double least = 1e-60;
  constexpr double most = 1e60;
  if (least < size && size < most) return laid_flat(a, b);
  // Squares of tiny edges underflow, of huge ones overflow; powers of two change no digit.
  const int power = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
  const auto scaled = [&](Vector e) {
    for (double& x : e) x = std::ldexp(x, -power);
    return e;
  };
  FlatTriangle result = laid_flat(scaled(a), scaled(b));
  for (Complex& z : result) z = {std::ldexp(z.real(), power), std::ldexp(z.imag(), power)};
  return result;
}

double cotangent(const Point& apex, const Point& from, const Point& to) {
  Vector a = from - apex;
  Vector b = to - apex;
  // Products of three tiny edges underflow, of huge ones overflow; powers of two change no digit.
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::abs(a[k]), std::abs(b[k])});
  constexpr double least = 1e-60;
  constexpr double most = 1e60;
  if (!(least < size && size < most) && size > 0 && std::isfinite(size))
    for (auto* const e : {&a, &b})
      for (std::size_t k = 0; k < 3; ++k) (*e)[k] = std::ldexp((*e)[k], -std::ilogb(size));
  return dot(a, b) / length(cross(a, b));
}

double twice_area(const FlatTriangle& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

double longest_squared(const FlatTriangle& p) {
  return std::max({std::norm(p[1] - p[0]), std::norm(p[2] - p[1]), std::norm(p[0] - p[2])});
}

double nearest_part(Complex from, Complex to, Complex z) {
  const Complex side = to - from;
  const double square = std::norm(side);
  return square > 0 ? std::clamp((std::conj(side) * (z - from)).real() / square, 0.0, 1.0) : 0.0;
}

double ratio_of_axes(const FlatTriangle& p, const FlatTriangle& q) {
  // q = forward z + backward conj(z), up to a common factor and the translation.
  const Complex z1 = p[1] - p[0];
  const Complex z2 = p[2] - p[0];
  const Complex w1 = q[1] - q[0];
  const Complex w2 = q[2] - q[0];
  const double forward = std::abs(w1 * std::conj(z2) - w2 * std::conj(z1));
  const double backward = std::abs(z1 * w2 - z2 * w1);
  // Beyond this ratio the difference is a rounding error, of either sign.
  constexpr double flattest = 1e12;
  return forward + backward < flattest * (forward - backward) ? (forward + backward) / (forward - backward)
                                                              : 0.0;
}

} // namespace tetrarch::numeric
