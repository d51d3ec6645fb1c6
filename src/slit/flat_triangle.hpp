// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangles laid into the plane, and what linear maps do to them.

#include "tetrarch/mesh/triangle_mesh.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::slit {

/// Corners in the complex plane.
using FlatTriangle = std::array<std::complex<double>, 3>;

/// A triangle of space: corner 0 at 0, corner 1 on the positive real axis.
FlatTriangle laid_flat(const std::vector<std::array<double, 3>>& points,
                       const mesh::Surface::Triangle& corners);

/// Positive where the corners are counterclockwise.
double twice_area(const FlatTriangle& p);

/// The square of the longest side.
double longest_squared(const FlatTriangle& p);

/// The ratio of the axes of the linear map from p to q; 0 where it does not keep the orientation, or keeps it
/// by rounding only.
double ratio_of_axes(const FlatTriangle& p, const FlatTriangle& q);

} // namespace tetrarch::slit
