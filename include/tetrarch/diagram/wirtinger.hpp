// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The group of a graph in space, read off its diagram.
///
/// Look from above. A strand from one passage below (or vertex) to the next is a generator: the loop that
/// comes down from the eye to its right, passes under it, and goes up to its left. Going once round a
/// crossing or a vertex below everything is a relator: the generators of its darts in their order, inverted
/// where the strand comes in. So every generator is a meridian. One relator of each part follows from the
/// others. Source: Wirtinger; for graphs, Kauffman (1989), section III.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/diagram/diagram.hpp"

#include <vector>

namespace tetrarch::diagram {

struct Wirtinger {
  /// Of the whole: that of a diagram in several parts is their free product.
  algebra::Presentation group;
  /// For each edge of the graph (diagram::edges) a generator that is its meridian, from 0.
  std::vector<int> meridians;
};

/// O(darts).
Wirtinger wirtinger(const Diagram& diagram);

} // namespace tetrarch::diagram
