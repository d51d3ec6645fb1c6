// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From a surface cut into disks to a circle bundle of any Euler number.
///
/// Any cut graph serves if its complement consists of disks. The fibers are twisted by one step on as many of
/// its edges as necessary, and the shifts are a flow on the graph. The flow runs along a spanning tree to a
/// root, where it drains away in whole turns. Canonical loops and equators, on which the dissertation builds,
/// are cut graphs; there the same twists and shifts come out as in its Definitions 6.3.1 (i counted from the
/// right vertex) and 7.3.1. Source: Yin, chapters 6 and 7, generalized.

#include "tetrarch/bundle/circle_bundle.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <optional>
#include <vector>

namespace tetrarch::bundle {

/// Turns triangles over so that mates are turned on cut edges only, and only where they must be. Throws
/// `PreconditionError` if a part of the cut surface is not orientable. O(n).
void orient_parts(surface::MarkedSurface& cut);

/// Puts a vertex into each part of the cut surface that has no interior vertex; returns the number of new
/// vertices. O(n).
int give_inner_vertices(surface::MarkedSurface& cut);

/// One side of each cut edge, the one of positive mark, by curve and then by number. O(n log n).
std::vector<Side> cut_edges(const surface::MarkedSurface& cut);

/// The twist of each side, mates alike: |total| cut edges get -1 or +1 such that the whole bundle turns by
/// `total` = e * N; edges of higher marks come first. Throws `PreconditionError` if there are too few cut
/// edges. O(n).
std::vector<int> spread_twist(const surface::MarkedSurface& cut, int total);

/// Splits cut edges until there are at least `edges`, in rounds that halve every edge; the curves of higher
/// marks come first. The history is the surface's. O(n + splits * log(splits)).
void split_cut_edges(surface::MarkedSurface& cut, int edges);

/// Shifts with the given twists on a connected cut graph, such that they cancel around every vertex but one,
/// around which they add up to the sum of the twists; at the root's end of edges outside the spanning tree
/// the shift is 0. O(n).
std::vector<Shift> shifts_of(const surface::MarkedSurface& cut, const std::vector<int>& twist, int root);

/// The values that twists ask for on cut edges (+1 on the side of positive mark where there is a choice), and
/// on the rest of each covering disk a cutting pattern. `boundary`, if given, has a value for each boundary
/// side of the surface, in the order of `boundary_sides`; otherwise they are free. The obstruction names
/// triangles of the surface. O(n).
struct Values {
  std::vector<std::int8_t> value; ///< of each side
  std::optional<Obstruction> obstruction;
};
Values values_of(const surface::MarkedSurface& cut, const std::vector<int>& twist,
                 const std::optional<BoundaryValues>& boundary = std::nullopt);

/// The boundary sides of the surface (where nothing is cut), curve by curve, as the boundary runs.
std::vector<Side> boundary_sides(const surface::Surface& surface);

} // namespace tetrarch::bundle
