// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Slicing a surface open along paths of edges, such as landmark curves.
///
///      a---b---c---d              .--b---c--.         A path becomes a boundary loop of twice as many edges:
///                        =>     a             d       its inner vertices are there twice, its ends once.
///                                 `--b'--c'-'
///
/// A path is given by vertices; each two are joined by a shortest path of edges, neighbors by their edge. A
/// closed path, whose last vertex is the first one again, becomes two loops, or a single one where the
/// surface is turned around it.

#include "tetrarch/surface/opened.hpp"

#include <vector>

namespace tetrarch::surface {

/// Slices along all paths, given by vertex numbers. Shortest paths avoid the boundary, the given vertices and
/// the earlier paths. Throws InputError with the vertex if it does not exist, lies on the boundary (an
/// earlier cut is boundary) or is given twice, or if no path leads to the next vertex. Throws InputError also
/// for a path of fewer than two edges, for a closed path of fewer than three vertices, and if closed paths
/// cut the surface in two. O(n log n) for each two consecutive vertices.
OpenedMesh slice(const OpenedMesh& opened, const std::vector<std::vector<long long>>& paths);

} // namespace tetrarch::surface
