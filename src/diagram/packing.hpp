// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A circle packing of a triangulated disk.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/layout.hpp"

#include <vector>

namespace tetrarch::diagram {

struct PackedCircle {
  PlanePoint center{};
  double radius = 1;
};

/// `flowers[v]` lists the neighbors of v counterclockwise: of an interior vertex all round, of a boundary
/// vertex from one boundary neighbor to the other. Boundary circles have radius 1. The disk must be
/// simplicial and connected, with an interior vertex.
std::vector<PackedCircle> packed(const std::vector<std::vector<int>>& flowers,
                                 const std::vector<bool>& boundary, const Progress& progress);

} // namespace tetrarch::diagram
