// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Ridges and corners of a solid found again on the surface of a mesh of hexahedra.
///
///      .--.--.--.--.     Each corner gets the nearest point of the mesh's surface, each ridge a shortest
///      |  |  |==|==|     path of edges near it, and no two paths meet but at corners. What the paths
///      .--.==.--.--.     enclose are the patches: the match is good if there are as many, and each lies
///      |==|  |  |  |     nearest to a patch of its own.
///      '--'--'--'--'

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/layers.hpp"
#include "tetrarch/hex/targets.hpp"

#include <optional>
#include <vector>

namespace tetrarch::hex {

struct Match {
  std::vector<Home> home; ///< of each point
  std::vector<int> patch; ///< of each square of `surface_of`
  /// Of each patch: whether it has too few squares somewhere, so that one would be flat: one alone at a point
  /// in the middle of a ridge, or an edge from a ridge to itself.
  std::vector<char> is_cramped;
  /// No hexahedron has two sides in one patch.
  bool is_unfolded = true;
};

/// All points of the surface belong to the surface and nothing more.
Match unmatched(const product::HexMesh& mesh);

/// The mesh is to lie near the solid's surface already. Nothing where ridges find no way or patches do not
/// come out. O(r n log n) for r ridges.
[[nodiscard]] std::optional<Match> matched(const product::HexMesh& mesh, const product::Solid& solid,
                                           const Targets& targets, const Progress& progress = {});

} // namespace tetrarch::hex
