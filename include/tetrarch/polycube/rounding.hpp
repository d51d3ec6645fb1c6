// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Planes of a polycube brought to integers.
///
///      |--- 2.4 ---|          A gap joins two planes of one axis that are the ends of a line, or face each
///      |-1.3-|-1.1-|    -->   other through the solid. Its rounded width is to be near the width it had, and
///      0     1     2          at least 1, so that no line and no wall collapses. All gaps agree, being
///                             differences of places.
///
/// From the first solution, in which each plane is pushed as far as those below it want, planes are moved by
/// 1 together with those that stand in their way, as long as the sum of squares falls. That is no proof of a
/// least sum.

#include "tetrarch/core/progress.hpp"

#include <optional>
#include <vector>

namespace tetrarch::polycube {

/// From one plane up to another.
struct Gap {
  int low = 0;
  int high = 0;
  double width = 0;
  double weight = 1;
};

/// The place of each plane, at least 1 above the lower end of its gaps. Nothing where gaps run in a circle.
/// Throws Stopped. O(g p) a round for g gaps and p planes.
[[nodiscard]] std::optional<std::vector<int>> rounded_places(const std::vector<double>& places,
                                                             const std::vector<Gap>& gaps,
                                                             const Progress& progress = {});

} // namespace tetrarch::polycube
