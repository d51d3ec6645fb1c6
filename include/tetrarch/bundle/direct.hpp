// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cutting patterns by the dual graph: short proofs turned into code, and the witness for the dissertation's
/// algorithms, with which this shares nothing but the data structures.
///
/// Free boundary: an orientation of the edges by any total order of the vertices has no directed cycle.
///
/// Given boundary: a triangle with two sides of opposite values is safe whatever the third. Take a
/// *core* of triangles that are safe so: a dual cycle (among the triangles around an interior vertex)
/// oriented cyclically; or, where there is no interior vertex, so that the dual graph is a tree, a dual path
/// from a triangle with a boundary value -1 to one with +1, oriented along the way. All other triangles,
/// farthest from the core first, give the edge toward the core the opposite of another value. There is no
/// core where the dual graph is a tree and all boundary values equal some a, and then there is no pattern: n
/// triangles would need n sides of value -a, and the n-1 interior edges have only one each.

#include "tetrarch/bundle/cutting_pattern.hpp"

namespace tetrarch::bundle {

/// The edges oriented from the vertex of lower to the one of higher rank; ranks, one for each vertex, must
/// differ along every edge (else `PreconditionError`), so a disk with a loop has no such order. O(n).
CuttingPattern cut_by_order(const Disk& disk, const std::vector<int>& rank);

/// A pattern with the given boundary values, or the obstruction, which is then the whole disk. Throws as
/// `with_boundary`. O(n).
[[nodiscard]] CuttingResult cut_by_dual_graph(const Disk& disk, const BoundaryValues& boundary);

} // namespace tetrarch::bundle
