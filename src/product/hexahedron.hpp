// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One hexahedron: its corners and sides; and what meshes of them have in common.

#include "tetrarch/product/polycube.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// Of each corner its three neighbors, so that they make a right-handed corner of a cube.
inline constexpr std::array<std::array<int, 3>, 8> corner_neighbors{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
/// Seen from outside each is counterclockwise.
inline constexpr std::array<std::array<int, 4>, 6> outward_sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Squares of the surface, by their points, seen from outside: those of one hexahedron only. O(n log n).
std::vector<std::array<int, 4>> surface_squares(const HexMesh& mesh);

/// Adds to `result.solid` the cubes whose corners all have a number there; `number` is -1 where a point was
/// left out, and what is beside it is left out, too.
void add_whole_cubes(PolycubeHexahedra& result, const std::vector<int>& number);

} // namespace tetrarch::product
