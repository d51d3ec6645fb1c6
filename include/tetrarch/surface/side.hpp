// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The sides of the triangles of a surface, and their ends: where one stands when walking on it.
///
///            2
///           / \          Side s of a triangle lies opposite corner s and runs from corner s+1 to corner s+2
///   side 1 /   \ side 0  (mod 3): counterclockwise. It is what others call a half-edge.
///         / --> \        An end of a side is a corner seen from one of the two sides that meet there;
///        0-------1       `pivot` goes to the other.
///          side 2

#include <array>

namespace tetrarch::surface {

/// One side of one triangle.
struct Side {
  int value = -1; ///< 3 * triangle + corner opposite; -1: none

  constexpr Side() = default;
  constexpr explicit Side(int index) : value(index) {}
  constexpr Side(int triangle, int corner) : value(3 * triangle + corner) {}

  constexpr bool exists() const { return value >= 0; }
  constexpr int triangle() const { return value / 3; }
  constexpr int corner() const { return value % 3; }
  /// The next side of the triangle, counterclockwise: it starts where this one ends.
  constexpr Side next() const { return corner() == 2 ? Side(value - 2) : Side(value + 1); }
  constexpr Side previous() const { return corner() == 0 ? Side(value + 2) : Side(value - 1); }
  friend constexpr bool operator==(Side, Side) = default;
};

/// The three sides of a triangle, for `for (Side s : sides_of(t))`.
constexpr std::array<Side, 3> sides_of(int triangle) {
  return {Side(triangle, 0), Side(triangle, 1), Side(triangle, 2)};
}

/// The end of a side from which it starts, or the one at which it stops.
struct SideEnd {
  Side side;
  bool at_start = true;

  /// The corner of the side's triangle.
  constexpr int corner() const { return at_start ? side.next().corner() : side.previous().corner(); }
  /// The same corner as an end of the other side there.
  constexpr SideEnd pivot() const {
    return at_start ? SideEnd{side.previous(), false} : SideEnd{side.next(), true};
  }
  friend constexpr bool operator==(SideEnd, SideEnd) = default;
};

} // namespace tetrarch::surface
