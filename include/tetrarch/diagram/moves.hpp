// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Moves of diagrams. None changes the graph in space.
///
/// Each makes a new diagram. A dart names its arc and the region to its left. Source: Reidemeister, "Knoten
/// und Gruppen" (1927); for graphs, Kauffman (1989).

#include "tetrarch/diagram/diagram.hpp"

#include <vector>

namespace tetrarch::diagram {

/// A kink on an arc, Reidemeister's first move. Walking from the dart, one comes to the new crossing, turns
/// to the left (or right) round a loop and crosses the way one came; the first passage is over or under.
struct Kink {
  int dart = 0;
  bool left = true;
  bool over_first = true;
};
/// O(darts), for all of them together; their arcs must differ. Throws PreconditionError otherwise.
Diagram with_kinks(const Diagram& diagram, const std::vector<Kink>& kinks);

/// Pushes the arc of `mover` over (or under) that of `other`, Reidemeister's second move: two crossings more.
/// Both have one region to their left, or lie in two parts, which makes one part of them. Throws
/// PreconditionError otherwise, or if the arcs are the same. O(darts).
struct Poke {
  int mover = 0;
  int other = 0;
  bool over = true;
};
Diagram with_poke(const Diagram& diagram, const Poke& poke);

/// The same graph as a diagram in one part: each further part is pushed over the first. Two crossings more
/// for each. O(parts * darts).
Diagram connected(const Diagram& diagram);

} // namespace tetrarch::diagram
