// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Shortest paths along the edges of a surface, and the dual forest between them.
///
/// The drawing is in surface/cuts.hpp. Lengths are given for each side and may be infinite: no path takes
/// such an edge, and vertices that only such edges lead to are not reached.

#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/surface/surface.hpp"

#include <vector>

namespace tetrarch::surface {

using numeric::infinity;

/// The edges, each as one of its sides. O(n).
std::vector<Side> edges(const Surface& surface);

/// Of each vertex, whether it is on the boundary. O(n).
std::vector<char> boundary_vertices(const Surface& surface);

/// The ends of edges at vertex v, one for each edge and twice for loops: ends[first[v]] ..
/// ends[first[v+1]-1].
struct EndsByVertex {
  std::vector<int> first;
  std::vector<SideEnd> ends;
};

EndsByVertex ends_by_vertex(const Surface& surface);

/// `length`, but infinite at the sides with a barred end. O(n).
std::vector<double> lengths_off(const Surface& surface, std::vector<double> length,
                                const std::vector<char>& is_barred);

/// A forest of shortest paths. The last step to a vertex is the end at its parent's of the edge that leads
/// there; none at roots.
using Paths = numeric::ShortestPaths<SideEnd>;

/// From the nearest of the roots. O(n log n).
Paths shortest_paths(const Surface& surface, const std::vector<double>& length,
                     const std::vector<int>& roots);

/// Edges closing loops with a forest of paths.
struct Closing {
  std::vector<Side> edges;   ///< by the length of their loops, shortest first
  double total = 0;          ///< of the lengths
  std::vector<char> crossed; ///< for each side, whether the dual tree crosses it
};

/// Crosses the edges outside the forest, those of the longest loops first, wherever that joins two parts of
/// the dual forest. Across boundary edges lies, if so wanted, one more place, outside; else they are no
/// edges. O(n log n).
Closing close_loops(const Surface& surface, const std::vector<double>& length, const Paths& paths,
                    bool outside);

} // namespace tetrarch::surface
