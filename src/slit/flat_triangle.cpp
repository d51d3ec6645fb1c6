// SPDX-License-Identifier: GPL-2.0-or-later
#include "flat_triangle.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::slit {

using Complex = std::complex<double>;

namespace {

/// Edges 01 and 02 laid flat.
FlatTriangle laid_flat(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double length = std::hypot(a[0], a[1], a[2]);
  const double area =
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return {0.0, length, {(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / length, area / length}};
}

} // namespace

FlatTriangle laid_flat(const std::vector<std::array<double, 3>>& points,
                       const mesh::Surface::Triangle& corners) {
  const auto edge = [&](int c) {
    std::array<double, 3> e{};
    for (int k = 0; k < 3; ++k) e[k] = points[corners[c]][k] - points[corners[0]][k];
    return e;
  };
  const auto a = edge(1);
  const auto b = edge(2);
  double size = 0;
  for (const auto& e : {a, b})
    for (const double x : e) size = std::max(size, std::abs(x));
  constexpr double least = 1e-60;
  constexpr double most = 1e60;
  if (least < size && size < most) return laid_flat(a, b);
  // Squares of tiny edges underflow, of huge ones overflow; powers of two change no digit.
  const int power = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
  const auto scaled = [&](std::array<double, 3> e) {
    for (double& x : e) x = std::ldexp(x, -power);
    return e;
  };
  FlatTriangle result = laid_flat(scaled(a), scaled(b));
  for (Complex& z : result) z = {std::ldexp(z.real(), power), std::ldexp(z.imag(), power)};
  return result;
}

double twice_area(const FlatTriangle& p) {
  return (std::conj(p[1] - p[0]) * (p[2] - p[0])).imag();
}

double longest_squared(const FlatTriangle& p) {
  return std::max({std::norm(p[1] - p[0]), std::norm(p[2] - p[1]), std::norm(p[0] - p[2])});
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

} // namespace tetrarch::slit
