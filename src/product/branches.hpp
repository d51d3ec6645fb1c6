// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Two trees on a sphere with holes, from one half of its holes and from the other, that reach into all its
/// limbs on opposite sides.
///
///            .-----.          The boundary of a handlebody is cut along loops around its tunnels. Floor and
///           ( ceil. )         ceiling get a bank of each, so what is theirs must join those banks. And a limb
///      _____ |  |  | ____     that lies in the floor alone is out of the field's reach: w decays in it
///      floor |  |  | floor    exponentially. So the ceiling sends a branch to its tip along one side, and
///            |  |  |          the floor along the other; between them there is a wall.
///          ceiling
///
/// Of all vertices that one is taken which is farthest from a tree although it is not near the other one, and
/// the tree grows to it along a way that is short where lengths are measured in distances from the other tree:
/// such a way keeps to the middle of what the other tree leaves. And so on.
///
/// Lengths are those of ways along edges.

#include "tetrarch/surface/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace tetrarch::product {

/// Vertices of one half of the holes and of the other, and the trees with them.
struct OppositeTrees {
  std::array<std::vector<int>, 2> banks;
  std::array<std::vector<int>, 2> trees;

  /// Whether this bank is one of the first tree's.
  bool is_first(const std::vector<int>& bank) const {
    return std::find(banks[0].begin(), banks[0].end(), bank.front()) != banks[0].end();
  }
};

/// `banks`: the vertices of both banks of each loop; those of the first loop are in this order, of others
/// that bank goes to the first tree which makes ways short. Then `branches` are added in all, fewer where no
/// vertex can be reached. Nothing if the banks cannot be joined without touching each other. O((loops +
/// branches) n log n).
std::optional<OppositeTrees> opposite_trees(const surface::TriangleMesh& surface,
                                            const std::vector<std::array<std::vector<int>, 2>>& banks,
                                            int branches);

/// The distance of each vertex from the nearest of these. O(n log n).
std::vector<double> distances(const surface::TriangleMesh& mesh, const std::vector<int>& from);

} // namespace tetrarch::product
