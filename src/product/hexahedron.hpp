// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One hexahedron: its corners and sides; and what meshes of them have in common.

#include "tetrarch/product/polycube.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// The scaled Jacobian at the corners and in the middle alone: no less than `scaled_jacobian`, which looks
/// between them, too, and is 0 where the determinant is not positive there.
double sampled_jacobian(const std::array<Point, 8>& corners);

/// Adds to `result.solid` the cubes whose corners all have a number there; `number` is -1 where a point was
/// left out, and what is beside it is left out, too.
void add_whole_cubes(PolycubeHexahedra& result, const std::vector<int>& number);

} // namespace tetrarch::product
