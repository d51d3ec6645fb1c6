// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where the nodes and arcs of a diagram lie: the circles of a packing.

#include "packing.hpp"
#include "tetrarch/diagram/diagram.hpp"

namespace tetrarch::diagram {

/// Circles of nodes and of the points of darts.
struct Places {
  std::vector<PackedCircle> node;
  std::vector<PackedCircle> point;
};

/// Packs each part as a triangulated disk and sets them side by side, each 1 high.
Places places_of(const Diagram& diagram, const Progress& progress);

} // namespace tetrarch::diagram
