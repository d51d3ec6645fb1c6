// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A corner of a triangle, and the sides as one sees them who stands there and looks into it.
///
///              opposite
///            2 ---<--- 1
///             \       /          A corner is named by the side that starts there, `right_of`.
///        left  \     /  right
///               `   /
///              corner 0

#include "tetrarch/surface/side.hpp"

namespace tetrarch::surface {

constexpr SideEnd start_of(Side s) {
  return {s, true};
}
constexpr SideEnd corner_at(int triangle, int corner) {
  return start_of(Side(triangle, (corner + 2) % 3));
}
constexpr Side right_of(SideEnd corner) {
  return Side(corner.side.triangle(), (corner.corner() + 2) % 3);
}
constexpr Side left_of(SideEnd corner) {
  return Side(corner.side.triangle(), (corner.corner() + 1) % 3);
}
constexpr Side opposite(SideEnd corner) {
  return Side(corner.side.triangle(), corner.corner());
}

} // namespace tetrarch::surface
