// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Two trees on a ring, each from one of its banks, that reach into all its branches on opposite sides.
///
///            .-----.             A limb of a solid that lies in the floor alone is out of the field's reach:
///            w
///           ( ceil. )            decays in it exponentially. So the ceiling sends a branch to its tip, along
///      _____ |  |  | ____        one side, and the floor along the other; between them there is a wall.
///      floor |  |  | floor
///            |  |  |             Of all vertices that one is taken which is farthest from a tree although it
///          ceiling               is not near the other one, and the tree grows to it along a way that is
///                                short where lengths are measured in distances from the other tree: such a
///                                way keeps to the middle of what the other tree leaves. And so on.
///
/// Lengths are those of ways along edges.

#include "tetrarch/mesh/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// The two sets of vertices, each a connected graph with its bank, the banks among them. `branches` are added
/// in all, fewer where no vertex can be reached. O(branches n log n).
std::array<std::vector<int>, 2> opposite_trees(const mesh::TriangleMesh& ring,
                                               const std::array<std::vector<int>, 2>& banks, int branches);

/// The distance of each vertex from the nearest of these. O(n log n).
std::vector<double> distances(const mesh::TriangleMesh& mesh, const std::vector<int>& from);

} // namespace tetrarch::product
