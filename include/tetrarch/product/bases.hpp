// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Floor and ceiling from hints of the caller.
///
///       labels     the triangles that a file labels so
///       cycles     closed walks on the boundary, which cut it into bases and walls
///       flooding   from a seed, as far as triangles face its way; what is left over are the walls
///       tunnels    loops around the walls, widened to both sides; what is left over are the bases
///
/// Each function gives the bases in the form of `partition`, 0, 1 or -1 for each triangle of the boundary;
/// `partition` checks them. Vertices are those of the solid. Source: Yin, section 3.4.1.

#include "tetrarch/product/solid.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// Triangles by their vertices, and a label of each. Throws InputError if one of the two labels does not
/// occur, or occurs on something other than a triangle of the boundary. O(n log n).
std::vector<int> bases_with_labels(const Solid& solid, const std::vector<std::array<int, 3>>& triangles,
                                   const std::vector<int>& label, std::array<int, 2> floor_and_ceiling);

/// Walks by their vertices; the last is joined with the first. The bases are the two pieces that are no
/// annuli; of four annuli, those two opposite ones that are flatter. The floor is the one with the first
/// triangle. Throws InputError if two consecutive vertices are not an edge of the boundary, or if the pieces
/// are of another kind. O(n log n).
std::vector<int> bases_between_cycles(const Solid& solid, const std::vector<std::vector<int>>& cycles);

struct Flooding {
  std::array<int, 2> seeds{}; ///< of floor and ceiling: vertices
  double threshold = 0.3;     ///< of 1 - n . n0, for the normals of a triangle and of the seed
};
/// By triangles, since normals of vertices are blurred at ridges. Small holes are filled and rims smoothed,
/// as far as triangles go. Throws InputError if a seed is not on the boundary or has no triangle within the
/// threshold, or if the two floods meet. O(n).
std::vector<int> bases_by_flooding(const Solid& solid, const Flooding& flooding);

/// Walls are the triangles whose vertices are no farther than `extend`, along edges, from a tunnel, a walk as
/// above. Throws InputError as above, and unless exactly two pieces are left. O(n log n).
std::vector<int> bases_beyond_tunnels(const Solid& solid, const std::vector<std::vector<int>>& tunnels,
                                      double extend);

} // namespace tetrarch::product
