// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangles laid into the plane, and what linear maps do to them.

#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::numeric {

/// Corners in the complex plane.
using FlatTriangle = std::array<std::complex<double>, 3>;

/// The area of the parallelogram, positive where b lies counterclockwise of a.
inline double cross(std::complex<double> a, std::complex<double> b) {
  return (std::conj(a) * b).imag();
}

/// A triangle of space: corner 0 at 0, corner 1 on the positive real axis.
FlatTriangle laid_flat(const std::vector<Point>& points, const std::array<int, 3>& corners);

/// The cotangent of the angle at `apex` of a triangle of space, whatever its size; infinite or no number
/// where it has no area.
double cotangent(const Point& apex, const Point& from, const Point& to);

/// Positive where the corners are counterclockwise.
double twice_area(const FlatTriangle& p);

/// The square of the longest side.
double longest_squared(const FlatTriangle& p);

/// The nearest point to z of the segment from `from` to `to`, as the part of the way.
double nearest_part(std::complex<double> from, std::complex<double> to, std::complex<double> z);

/// The ratio of the axes of the linear map from p to q; 0 where it does not keep the orientation, or keeps it
/// by rounding only.
double ratio_of_axes(const FlatTriangle& p, const FlatTriangle& q);

} // namespace tetrarch::numeric
