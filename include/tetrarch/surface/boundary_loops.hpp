// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The boundary of a triangle mesh, loop by loop, from the longest on.
///
///       .-----------.       An annulus has two loops: 0 is the outer one, if it is longer. People ask for a
///      /    .--.     \      loop by its number or as v17: the loop through vertex 17.
///     0    1    |     |
///      \    '--'     /
///       '-----------'

#include "tetrarch/surface/triangle_mesh.hpp"

#include <vector>

namespace tetrarch::surface {

/// One loop of the boundary, and its size.
struct BoundaryLoop {
  /// The ends at which a walk along the loop enters its sides, as in `boundary_curves`.
  std::vector<SideEnd> sides;
  double length = 0;
  /// Length of the vector area, |sum p x q| / 2 over the edges pq: the area inside a flat loop, and for any
  /// loop the area of its largest shadow.
  double area = 0;
};

/// The loops by decreasing length; among loops of equal length the one with the least vertex comes first.
/// O(n).
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh);

/// The index of the loop through a vertex; -1 if the vertex is not on the boundary. O(size of all loops).
[[nodiscard]] int loop_through(const std::vector<BoundaryLoop>& loops, const Surface& surface, int vertex);

/// For each vertex the index of the loop through it; -1 for interior vertices. O(n).
std::vector<int> loops_of_vertices(const std::vector<BoundaryLoop>& loops, const Surface& surface);

} // namespace tetrarch::surface
