// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Vectors in space, as far as this room needs them.

#include "tetrarch/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tetrarch::scene {

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double s, const Point& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Along `a` with length 1; none where `a` has no direction.
inline std::optional<Point> direction(const Point& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  if (!(length > 0)) return std::nullopt;
  return Point{a[0] / length, a[1] / length, a[2] / length};
}

/// The largest extent of some points along an axis; there must be one.
inline double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  return size;
}

} // namespace tetrarch::scene
