// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A search for a partition of the boundary, without any hints.
///
///     ridges    Cut along its sharp edges, the boundary falls apart into sides. Of all pairs of sides that
///               are bases of a partition, one is taken.
///     axes      Floor is where the outer normal, smoothed, points against an axis, ceiling where it points
///               along it. Of many axes and thresholds one is taken. Rims are made smooth curves by splitting
///               tetrahedra along them.
///     tunnels   Inner walls are bands around short loops of the boundary that are a basis of the homology of
///               the solid, the outer one lies halfway between their banks. Where limbs would lie in one base
///               alone, both bases send branches into them, on opposite sides. Rims are made smooth as above.
///
/// The search tries the three ways in this order. It takes the first partition whose field has no critical
/// point, or else the partition with the fewest. It tries more branches as long as they make the field reach
/// clearly farther. Among several sides or axes the best has the greatest score: |F - C| / A, where F and C
/// are the vector areas of floor and ceiling and A is the area of the boundary. It is the greater, the larger
/// and flatter the bases are and the more they face away from each other, and it does not depend on the
/// position of the solid. Source: after Yin, section 3.4.1, who flows from seeds.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/partition.hpp"
#include "tetrarch/solid/split_edges.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::product {

struct AutomaticOptions {
  double ridge_degrees = 30; ///< an edge is sharp if the normals of its triangles differ by more than this
  int axes = 100;            ///< besides the six principal ones
  /// Thresholds for the cosine between normal and axis, which set how far the bases reach.
  std::vector<double> thresholds{0.2, 0.35, 0.5, 0.65, 0.8};
  /// Rounds of averaging the normals, until one of them does it. Some make rims smoother, many wash small
  /// holes away.
  std::vector<int> smoothings{25, 5, 0, 100};
  /// Numbers of branches that floor and ceiling send into limbs, tried one after the other.
  std::vector<int> branches{0, 4, 8, 12, 16, 24, 32};
  bool smooth_rims = true; ///< whether tetrahedra may be split
  int threads = 1;         ///< of the search for axes; they make no difference to what is found
};

struct Automatic {
  Solid solid; ///< as it was, but for splits; old vertices keep their numbers
  Partition partition;
  double score = 0;
  std::string how; ///< in words: which way, which axis
  /// Split k made vertex n + k of a solid with n vertices; its ends may be vertices made before.
  std::vector<solid::EdgePoint> splits;
};

/// Nothing if no way led to a partition, which proves nothing about the solid. O(axes thresholds n) at worst.
[[nodiscard]] std::optional<Automatic>
automatic_partition(const Solid& solid, const AutomaticOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::product
