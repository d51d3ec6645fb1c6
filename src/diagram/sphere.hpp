// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How the 3-sphere is made over a diagram (exterior.hpp tells the whole story).

#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/marked.hpp"

namespace tetrarch::diagram {

/// The fates of all darts after a move that kept the old darts and added crossings. O(darts).
std::vector<Fate> carried(const std::vector<Fate>& fates, const Diagram& after);

/// The same graph with kinks: every region that drilled edges bound has a corner at a crossing, and drilled
/// arcs on one level make no cycle, so that they may be crushed. The diagram is in one part. O(darts).
MarkedDiagram with_kinks_for_crushing(const MarkedDiagram& marked);

/// The sphere over a diagram in one part, as it is: five tetrahedra for each dart.
Sphere sphere_over(const Diagram& diagram);

} // namespace tetrarch::diagram
