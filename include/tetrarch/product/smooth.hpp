// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Improving hexahedra by moving their points, one after the other.
///
///      .-----.-----.     The worst of the hexahedra around a point is to be as good as can be. A
///      |     |     |     point goes to the middle of its neighbors, or half the way, if this worst
///      |    x--->. |     becomes better there; else, if it is bad, a search in 14 directions with
///      .---- \ ----.     smaller and smaller steps finds a better place, if any is near. At first,
///      |     |     |     where hexahedra are bad, it is the sum of what is lacking around a point that
///      '-----'-----'     is to become less, and none may become worse than the worst of all.
///
/// The mesh that is kept is the best of all met between sweeps, the first included: of fewest inverted
/// hexahedra, then of greatest least scaled Jacobian, then of greatest mean. So no mesh becomes worse.
///
/// Source: Freitag and Plassmann, "Local optimization-based simplicial mesh untangling and improvement"
/// (2000), for tetrahedra.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/hex_mesh.hpp"

#include <functional>
#include <vector>

namespace tetrarch::product {

struct SmoothOptions {
  int most_sweeps = 30;      ///< over all points
  double search_below = 0.5; ///< search around points whose worst hexahedron is below
  double least_gain = 1e-4;  ///< of the worst around a point, for which the point is moved
  /// Where a point goes that would go to a place: points of a curved surface are brought back to it. Empty:
  /// there.
  std::function<Point(int, const Point&)> brought_back;
};

struct Smoothed {
  int sweeps = 0;
  int moved = 0; ///< points
  double minimum_before = 1;
  double minimum_after = 1;
  int bad_before = 0; ///< hexahedra of scaled Jacobian 0 or less
  int bad_after = 0;
};

/// Points with `fixed` not 0 stay where they are. Points are visited by number, so the result is the same
/// everywhere. Stops when no point moves, or with the last sweep. Throws PreconditionError unless `fixed` has
/// a value for each point. O(n) a sweep.
Smoothed smooth(HexMesh& mesh, const std::vector<char>& fixed, const SmoothOptions& options = {},
                const Progress& progress = {});

} // namespace tetrarch::product
