// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Vectors of space.

#include <array>
#include <cmath>

namespace tetrarch::product::vectors {

using Vector = std::array<double, 3>;

inline Vector sum(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector times(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}

} // namespace tetrarch::product::vectors
