// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The boundary of a handlebody, divided into a floor, a ceiling and walls.
///
///        ceiling                Two disjoint bases of the same type, disks with n holes, and n + 1 walls
///       .-------.               between them, cylinders, each with one rim on the floor and one on the
///      /  (__)  /| wall 0       ceiling. Wall 0 is the outer one: the one whose rim on the floor is longest,
///     .--------. |              if nobody says otherwise. The others follow by decreasing length of it.
///     | wall 1 |/
///     '--------'  floor below
///
/// Source: Yin, sections 3.3.1 and 3.4.1.

#include "tetrarch/product/solid.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::product {

/// Patches of a partition: floor, ceiling, and wall i as first_wall + i.
inline constexpr int floor_patch = 0;
inline constexpr int ceiling_patch = 1;
inline constexpr int first_wall = 2;

/// Which triangles of the boundary are floor, ceiling and walls.
struct Partition {
  std::vector<int> patch; ///< of each triangle of the solid's boundary
  int walls = 0;

  int holes() const { return walls - 1; }
};

/// A partition, or why there is none.
struct PartitionAttempt {
  std::optional<Partition> partition;
  std::string why_not; ///< empty where there is one
};

/// The partition whose bases are the triangles of base 0 (floor) and of base 1 (ceiling); all others, -1, are
/// walls, numbered as above, with the wall through triangle `outer` first if that is not -1. If they make
/// none, the reason names the piece with the wrong topology and one of its triangles by vertices (counted
/// from 0), or another fault: bases that touch or are of different types, walls that are no cylinders from
/// floor to ceiling, a number of walls that the genus of the boundary forbids. O(n).
[[nodiscard]] PartitionAttempt try_partition(const Solid& solid, const std::vector<int>& base,
                                             int outer = -1);

/// The same for bases from outside: throws InputError with the reason.
Partition partition(const Solid& solid, const std::vector<int>& base, int outer = -1);

/// Of each vertex of the mesh, which base it is on: floor_patch, ceiling_patch or -1. O(n).
std::vector<int> bases_of_vertices(const Solid& solid, const Partition& partition);

} // namespace tetrarch::product
