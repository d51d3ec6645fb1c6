// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cutting patterns: how the prisms over the triangles of a disk are cut into tetrahedra, consistently.
///
///     T0 ------- T1      Over each edge of the disk stands a wall, from the bottom copy B of the disk to the
///      |       / |       top copy T. The wall over the side that runs from B0 to B1 is sliced along B0T1,
///      |  +1 /   |       value +1, or along B1T0, value -1. Seen from the triangle behind the wall the side
///      |   /     |       runs the other way, and the value is the opposite.
///     B0 ------- B1
///
/// A prism comes apart into three tetrahedra unless its three sides have equal values. Equivalently, a
/// pattern is an orientation of the edges (+1: along the side) by which no triangle is a directed cycle.
/// Source: Yin, 5.1.2 and 5.1.3.

#include "tetrarch/bundle/disk.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace tetrarch::bundle {

/// A value +1, -1 or 0 (still open) on each side, the a(e,f) of the text. Mates have opposite values, always.
class CuttingPattern {
public:
  /// All sides open.
  explicit CuttingPattern(const Disk& disk) : value_(3 * disk.triangle_count(), 0) {}

  int operator[](Side s) const { return value_[s]; }
  bool is_open(Side s) const { return value_[s] == 0; }
  /// Gives side s this value, +1 or -1, and gives its mate, if there is one, the opposite value.
  void set(const Disk& disk, Side s, int value) {
    value_[s] = static_cast<std::int8_t>(value);
    if (!disk.is_boundary(s)) value_[disk.mate(s)] = static_cast<std::int8_t>(-value);
  }
  friend bool operator==(const CuttingPattern&, const CuttingPattern&) = default;

private:
  Table<Side, std::int8_t> value_;
};

/// One value, +1 or -1, for each side of `disk.boundary()`, in that order.
using BoundaryValues = std::vector<int>;

/// The pattern with these values on the boundary, open elsewhere. Throws `PreconditionError` if their number
/// is wrong or one is neither +1 nor -1. O(n).
CuttingPattern with_boundary(const Disk& disk, const BoundaryValues& boundary);

/// The values of a pattern on the boundary. O(boundary).
BoundaryValues boundary_of(const Disk& disk, const CuttingPattern& pattern);

/// A sentence that says why this is no cutting pattern: a side is open, mates agree, or a triangle has three
/// equal values. Empty for a cutting pattern. O(n).
std::string why_not_valid(const Disk& disk, const CuttingPattern& pattern);

/// Why boundary values cannot be extended to the disk: a sub-mesh on which every value given is the
/// forbidding one. Source: Yin, Definition 5.3.2.
struct Obstruction {
  std::vector<int> triangles; ///< in increasing order
  int forbidding = 0;         ///< +1 or -1
};

using CuttingResult = std::variant<CuttingPattern, Obstruction>;

} // namespace tetrarch::bundle
