// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Bases that are nearly right, made so: crumbs, holes and pinches go.
///
///       .--.   o           A crumb is a piece of a base that is not its largest; it becomes wall. A hole
///      |    |              is a disk of wall within one base; it is filled. At a pinch, and where floor
///      | o  |_             and ceiling touch, the triangles around become wall. A jag is a triangle with
///      '----'              two sides on the other patch; it goes over.

#include "tetrarch/product/solid.hpp"

#include <vector>

namespace tetrarch::product {

/// The area of each triangle of the boundary times its outer unit normal. O(n).
std::vector<Point> vector_areas(const Solid& solid);

/// Changes `base` (0, 1, or -1 for walls, of each triangle) as above, until nothing changes or after a fixed
/// number of rounds. Whether the result is a partition, `partition` decides. O(n) a round.
void clean_up(const Solid& solid, std::vector<int>& base);

} // namespace tetrarch::product
