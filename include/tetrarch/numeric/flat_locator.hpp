// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where points of the plane lie among triangles that cover a part of it.
///
///      +---+---+       A tree of boxes finds the triangles near a point. Triangles that are turned over are
///      | /\|   |       left out: where the drawing covers the plane once, counted with signs, others cover
///      |/__\   |       what they cover. Where several triangles cover a point, two measures of depth serve
///      +---+\--+       two ends:
///
/// `inside` and `nearest` go by weights: the triangle in which the least weight of the point is greatest.
/// Weights within rounding of a side are exactly 0, so that points of a side stay there.
/// `deepest` goes by distance: the triangle from whose sides the point is farthest.
///
/// Where no triangle covers a point, the nearest one is taken.

#include "tetrarch/numeric/flat_triangle.hpp"

#include <array>
#include <complex>
#include <memory>
#include <vector>

namespace tetrarch::numeric {

struct FlatPlace {
  int triangle = -1;              ///< -1: none
  std::array<double, 3> weight{}; ///< of its corners
  double outside = 0;             ///< the distance from the triangle
};

/// Copies share the tree.
class FlatLocator {
public:
  /// O(n log n).
  explicit FlatLocator(std::vector<FlatTriangle> triangles);

  /// The triangle in which the point is, none if there is none. O(log n), as a rule, like the others.
  FlatPlace inside(std::complex<double> z) const;
  /// The same, or the nearest one; none only if there are no triangles.
  FlatPlace nearest(std::complex<double> z) const;
  /// By distance; none only if there are no triangles.
  FlatPlace deepest(std::complex<double> z) const;

  bool empty() const;                   ///< whether all triangles are turned over
  double area() const { return area_; } ///< of all triangles that are not turned over

private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
  double area_ = 0;
};

} // namespace tetrarch::numeric
