// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface sliced open along paths of edges, such as landmark curves.
///
///      a---b---c---d              .--b---c--.         A path becomes a boundary loop of twice as many edges:
///                        =>     a             d       its inner vertices are there twice, its ends once.
///                                 `--b'--c'-'
///
/// A path is given by vertices; each two are joined by a shortest path of edges, neighbours by their edge. A
/// closed path, whose last vertex is the first one again, becomes two loops, or a single one where the
/// surface is turned around it.

#include "tetrarch/mesh/opened.hpp"

#include <vector>

namespace tetrarch::mesh {

/// Slices along all paths, given by the numbers of vertices. Shortest paths keep off the boundary, the
/// vertices given, and the paths before them. Throws InputError, naming the vertex, where there is none of
/// that number, it is on the boundary (an earlier cut is boundary), or it is given twice; where no way is
/// left to the next vertex; where a path has less than two edges, or a closed one names less than three
/// vertices; and where closed paths cut the surface in two. O(n log n) for each two vertices.
OpenedMesh slice(const OpenedMesh& opened, const std::vector<std::vector<long long>>& paths);

} // namespace tetrarch::mesh
