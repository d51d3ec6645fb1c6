// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Paths laid through a surface from one point of its cuts to another, touching them nowhere else.
///
///        *-----------*-----*          * vertices on cuts or boundary, which a path must not touch
///       / \         / \   /
///      /   \       /   \ /            o free vertices
///   A *-----m-----o-----* B
///      \   / \   / \   /              From A to B across the middle m of a *chord*, an edge inside that
///       \ /   \ /   \ /               joins two forbidden vertices, over a free vertex, across a chord
///       again.
///        *-----*-----*
///
/// A path is a shortest one, where every chord crossed costs as much as ten edges; then the chords are split.
/// *Diagonals*, which only splits have put into a triangle of the first surface, are crossed for nothing:
/// they are flipped out of the way. So a path has one vertex for each edge of the first surface that it
/// crosses. Without this, a path between two others has as many edges as both together, and lengths grow
/// exponentially.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <functional>
#include <vector>

namespace tetrarch::surface {

/// A vertex where the boundary of a surface cut open passes.
struct Corner {
  SideEnd end;    ///< of the side after it, or any end there if it is inside
  int before = 0; ///< the mark of the side that the boundary comes along; 0: boundary of the surface itself
  int after = 0;
};

/// The corners of `open`, which is `cut_open(surface)`, in the order of the sides after them. Its mates must
/// not be turned. O(n).
std::vector<Corner> corners(const MarkedSurface& surface, const Surface& open);

/// What it costs to cut a forest of triangles of the first surface (`MarkedSurface::origin`), in edges of
/// mean length: a path along an edge that a way from a triangle to its parent crosses pays the toll of the
/// triangle, and so does a path through the triangle.
struct Tolls {
  std::vector<int> parent; ///< of each triangle; -1: none
  std::vector<double> of;  ///< each triangle
  double between(int p, int q) const {
    if (of.empty()) return 0;
    if (parent[p] == q) return of[p];
    return parent[q] == p ? of[q] : 0;
  }
  double through(int p) const { return of.empty() ? 0 : of[p]; }
};

/// The length of the shortest path from `from` to each vertex of `open`. O(n log n).
std::vector<double> path_lengths(const MarkedSurface& surface, const Surface& open,
                                 const std::vector<SideEnd>& from, const Tolls& tolls = {});

struct SplitCount {
  int edges = 0;
  int faces = 0;
};

/// Where a path may start or stop, found in `cut_open(surface)`: splits rename sides, so it is asked again.
using Places = std::function<std::vector<SideEnd>(const Surface& open)>;

/// Lays a shortest path from one of `from` to one of `to` and marks it with m, so that the path runs along
/// its sides of mark m. Throws `PreconditionError` if they are on different parts of the surface cut open,
/// and `InputError` if edges have no length: any path is a shortest one then. Returns what had to be split. A
/// stop is heard between searches. O(n log n).
SplitCount lay_path(MarkedSurface& surface, int m, const Places& from, const Places& to,
                    const Progress& progress = {}, const Tolls& tolls = {});

} // namespace tetrarch::surface
