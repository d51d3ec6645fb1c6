// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How dangerous the boundary values of a sub-component are.
///
/// | danger     | meaning                                                                             |
/// | ---------- | ----------------------------------------------------------------------------------- |
/// | safe       | every dangling or singular triangle has boundary sides +1 and -1; so aggregated      |
/// |            | pieces are safe whatever their values                                               |
/// | moderate   | not safe, but +1 and -1 both occur: always linear                                   |
/// | extreme    | not safe, and all values that are given equal one a, the *forbidding value*         |
///
/// More values never make a piece more dangerous. The dissertation leaves the forbidding value undefined for
/// a piece without values; here it is 0, and such a piece needs both values from its neighbors. Source: Yin,
/// Definitions 5.2.1 and 5.3.1.

#include "tetrarch/bundle/cutting_pattern.hpp"
#include "tetrarch/bundle/partition.hpp"

namespace tetrarch::bundle {

enum class Danger : std::uint8_t { safe, moderate, extreme };

/// How dangerous the boundary values of a sub-component are.
struct Assignment {
  Danger danger = Danger::safe;
  int forbidding = 0; ///< of an extreme one +1 or -1, or 0 if all values are open; else 0
  friend bool operator==(const Assignment&, const Assignment&) = default;
};

/// O(triangles of the piece).
Assignment classify(const Partition& partition, const CuttingPattern& pattern, const Piece& piece);

/// Whether each dangling or singular triangle of the unsolved mesh has boundary sides +1 and -1. O(frontier).
bool is_safe(const UnsolvedMesh& mesh, const CuttingPattern& pattern);

} // namespace tetrarch::bundle
