// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where points of the plane lie in a mesh that is laid into it.
///
/// Triangles that are turned over are left out: where the drawing covers the plane once, counted with signs,
/// what they cover is covered by others too. Of several triangles the one is taken in which the point lies
/// deepest; of none, the nearest.

#include "tetrarch/slit/registration.hpp"

namespace tetrarch::slit {

struct FlatPoint {
  MeshPoint at;
  double outside = 0; ///< the distance from the triangle
};

/// Throws PreconditionError if all triangles are turned over. O(m log m + n log m) for m triangles and n
/// points, as a rule.
std::vector<FlatPoint> flat_points(const surface::Surface& surface,
                                   const std::vector<std::complex<double>>& position,
                                   const std::vector<std::complex<double>>& points);

} // namespace tetrarch::slit
