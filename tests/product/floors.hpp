// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Floors whose rectangle is known without a solver: that of a plate with square holes is its plan.

#include "product/solids.hpp"
#include "tetrarch/product/floor_map.hpp"

#include <complex>

namespace tetrarch::support {

/// `plate` must be one with square holes.
inline product::FloorMap floor_from_plan(const product::Solid& solid, const product::Partition& parts,
                                         const Extrusion& plate) {
  product::FloorMap floor = product::floor_map(solid, parts); // for its mesh
  const double width = std::max(plate.holes, 1);
  for (std::size_t v = 0; v < floor.vertex.size(); ++v) {
    const auto& [x, y, t] = plate.at[floor.vertex[v]];
    floor.position[v] = std::complex{x, y} / width;
  }
  floor.height = 1 / width;
  for (int k = 0; k < plate.holes; ++k)
    floor.rectangles.push_back({std::complex{k + 0.25, 0.25} / width, std::complex{k + 0.75, 0.75} / width});
  return floor;
}

} // namespace tetrarch::support
