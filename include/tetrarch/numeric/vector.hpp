// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Points and vectors of space: what the rooms above write with them.
///
/// They are plain arrays, so that a name found by its arguments would be sought in std: say
/// `using namespace numeric;` where you use the operators.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace tetrarch::numeric {

using Point = std::array<double, 3>;
using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator-(const Vector& a) {
  return {-a[0], -a[1], -a[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The root of the sum of squares: overflows above 1e154, and is quick.
inline double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}
/// The same without overflow, and to the last digit but one.
inline double length(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}
/// The length of p - q.
inline double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}
/// Along `a` with length 1; none where `a` has no direction.
inline std::optional<Vector> direction(const Vector& a) {
  const double size = length(a);
  if (!(size > 0)) return std::nullopt;
  return Vector{a[0] / size, a[1] / size, a[2] / size};
}

/// The largest extent of some points along an axis; there must be one.
inline double extent(const std::vector<Point>& points) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  return size;
}

} // namespace tetrarch::numeric
