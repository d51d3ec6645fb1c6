// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cuts that open a surface to a disk, and loops that generate its fundamental group.
///
///      tree              cotree             what neither takes
///     .__.  .__.         | | | |
///     |  |__|  |        -+-+-+-+-           The primal tree leads to every vertex, the dual tree through
///     .__.  |__.         | | | |            every triangle, and they cross nowhere. On a closed surface
///                                           2 - chi edges are in neither; each closes a loop with the tree.
///
/// The triangles, joined across the edges of the dual tree only, are a disk. So the edges that it does not
/// cross form a cut graph; dangling branches are pruned. Here the primal tree is made of shortest paths, and
/// the dual tree crosses the edges first that would close the longest loops: the loops left are as short as
/// loops through the root can be. Surfaces may have boundary, be non-orientable, or have one vertex. Source:
/// Eppstein, "Dynamic generators of topologically embedded graphs" (2003); Erickson and Whittlesey, "Greedy
/// optimal homotopy and homology generators" (2005).

#include "tetrarch/surface/marked_surface.hpp"

#include <vector>

namespace tetrarch::surface {

/// A closed walk: it leaves each end along its side, and the next end is at the vertex there.
using Loop = std::vector<SideEnd>;

/// For each side the distance of its ends, or 1 where the surface has no points. O(n).
std::vector<double> side_lengths(const MarkedSurface& surface);
/// Of one side.
double side_length(const MarkedSurface& surface, Side s);
/// The distance of the centers of the triangles on the two sides of an edge inside, or 1 without points.
double dual_length(const MarkedSurface& surface, Side s);

/// Marks the edges that are not `crossed` (a flag for each side), except those of dangling branches, which
/// end neither on the boundary nor at other branches. Each maximal arc between branching points or the
/// boundary gets a number of its own, 1, 2, ..., and one bank of it the positive sign; a closed curve without
/// branching point counts as one arc. Where the crossed edges make a spanning tree of the triangles,
/// `cut_open` is then a disk, unless the surface is a sphere, where nothing remains. Returns how many arcs
/// there are. Earlier marks are lost. O(n).
int mark_uncrossed(MarkedSurface& surface, const std::vector<char>& crossed);

/// Marks a short cut graph, so that `cut_open` is a disk; arcs are numbered as in `mark_uncrossed`. Where
/// there is boundary, the arcs run from boundary to boundary by the shortest ways; on a disk nothing is
/// marked; on a sphere it is one edge with two ends, which opens it to a disk with two sides. Returns the
/// number of arcs. Throws `PreconditionError` if the surface is not connected. O(n log n).
int mark_cut_graph(MarkedSurface& surface);

/// The shortest system of loops through vertex `root` that generates the fundamental group, shortest first:
/// 2 - chi loops of a closed surface, 1 - chi of one with boundary. Marks play no part. Throws
/// `PreconditionError` if there is no such vertex or the surface is not connected. O(n log n + result).
std::vector<Loop> generators(const MarkedSurface& surface, int root);

/// The root whose generators are shortest in total, among `tries` >= 1 vertices: the first vertex, then each
/// time the vertex farthest from all earlier ones. Throws as `generators`. O(tries * n log n).
int root_of_short_generators(const MarkedSurface& surface, int tries = 8);

} // namespace tetrarch::surface
