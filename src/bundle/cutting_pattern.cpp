// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/cutting_pattern.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::bundle {

CuttingPattern with_boundary(const Disk& disk, const BoundaryValues& boundary) {
  if (boundary.size() != disk.boundary().size())
    throw PreconditionError("the boundary has " + std::to_string(disk.boundary().size()) + " edges, but " +
                            std::to_string(boundary.size()) + " values are given");
  CuttingPattern pattern(disk);
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary[k] != 1 && boundary[k] != -1)
      throw PreconditionError("boundary edge " + std::to_string(k) + " has value " +
                              std::to_string(boundary[k]) + ", neither 1 nor -1");
    pattern.set(disk, disk.boundary()[k], boundary[k]);
  }
  return pattern;
}

BoundaryValues boundary_of(const Disk& disk, const CuttingPattern& pattern) {
  BoundaryValues values;
  for (const Side s : disk.boundary()) values.push_back(pattern[s]);
  return values;
}

std::string why_not_valid(const Disk& disk, const CuttingPattern& pattern) {
  for (int t = 0; t < disk.triangle_count(); ++t) {
    const std::string where = "triangle " + std::to_string(t);
    int sum = 0;
    for (const Side s : sides_of(t)) {
      if (pattern.is_open(s)) return where + ": side " + std::to_string(s.corner()) + " is open";
      if (!disk.is_boundary(s) && pattern[disk.mate(s)] != -pattern[s])
        return where + ": side " + std::to_string(s.corner()) + " and its mate do not have opposite values";
      sum += pattern[s];
    }
    if (sum == 3 || sum == -3) return where + ": the three sides have equal values";
  }
  return "";
}

} // namespace tetrarch::bundle
