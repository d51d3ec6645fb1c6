// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Many curves across the triangles of a surface, laid all at once.
///
///            c              A *strand* runs from a corner of a triangle across edges to a corner of another
///           / \             one. Each crossing becomes a vertex, each passage through a triangle an edge:
///      ----*---*----        what lies between the passages of a triangle is cut into triangles without
///        /  \   \           further vertices. All are straight within the old triangles, so nothing
///    ---*----*---*---       folds, whatever the number of strands.
///      /      \   \         (Drawn: two passages around corner c, one around corner b.)
///     a--------*---b
///
/// An edge is halved by its middle vertex, the halves by theirs, and so on.

#include "tetrarch/surface/marked_surface.hpp"

#include <vector>

namespace tetrarch::surface {

struct Strand {
  SideEnd from;              ///< the corner where it starts
  std::vector<Side> crossed; ///< each seen from the triangle that it leaves
  SideEnd to;                ///< the corner where it ends
  int mark = 0;
};

/// Where a strand crosses an edge: its number, and which of its `crossed` it is.
struct Crossing {
  int strand = 0;
  int step = 0;
};

/// Lays strands that do not cross each other: `order[s]`, for the side s of lesser number of each edge
/// crossed, has the crossings along the edge from its start to its end. A strand crosses an edge at most
/// once, at least one in all, leaves its first triangle opposite `from` and enters its last one opposite
/// `to`. Edges crossed must not be marked, mates not turned. Triangles that no strand passes keep their
/// numbers. Returns the number of new vertices, one for each crossing. O(n + crossings * log(crossings)).
int lay_strands(MarkedSurface& surface, const std::vector<Strand>& strands,
                const Table<Side, std::vector<Crossing>>& order);

} // namespace tetrarch::surface
