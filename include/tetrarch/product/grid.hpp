// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A grid of squares on a floor that is a rectangle with rectangular holes.
///
///      .--.--.--.--.--.        Lines run along the outer sides and along those of the holes. Between them
///      |  |__|__|  |  |        are as many others as make the cells nearly as wide and as high as wanted, at
///      |--|     |--|--|        least none: each hole, and each gap between two, is one cell wide or more.
///      |  |_____|__|  |
///      |  |  |  |     |        Sides of different holes that nearly coincide share a line, which then has a
///      '--'--'--'-----'        small bend in it, since nodes on a hole stay on its side.
///
/// The floor is stretched along u and along v, piecewise linearly but for the bends, so cells are not squares
/// in (u, v): `stretch` measures the difference. Source: Yin, section 3.5, which gives no method.

#include "tetrarch/product/floor_map.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::product {

/// Where two lines of the grid meet.
struct GridNode {
  int column = 0; ///< of lines, from the left
  int row = 0;    ///< of lines, from below
  int loop = -1;  ///< 0 on the outer rectangle, k + 1 on hole k, -1 inside
  std::complex<double> position;
};

struct FloorGrid {
  int columns = 0; ///< of cells, those in holes included
  int rows = 0;
  std::vector<std::array<int, 4>> holes; ///< of each, the lines left, below, right and above
  std::vector<GridNode> nodes;           ///< by rows; none strictly inside a hole
  std::vector<std::array<int, 4>> cells; ///< nodes counterclockwise from the lower left one; by rows
  /// How many times longer the longer sides of a cell are than the others, all by their mean.
  double mean_stretch = 1;
  double max_stretch = 1;
};

struct GridOptions {
  int across = 16; ///< cells that fit into the width of the rectangle
  /// Sides of different holes nearer than this part of a cell share a line; it is lowered where an angle of a
  /// cell would be below 30 degrees or above 150.
  double shared = 0.25;
};

/// The grid on [0, 1] x [0, height] with these holes, each by its lower left and upper right corner. Throws
/// InputError where a hole is empty, touches another or does not lie inside, and if there would be more than
/// 10^8 cells; PreconditionError unless `across` >= 1 and 0 <= `shared` < 1/2. O(lines^2 + cells).
FloorGrid floor_grid(double height, const std::vector<std::array<std::complex<double>, 2>>& holes,
                     const GridOptions& options = {});

/// A point of a floor.
struct FloorPoint {
  int triangle = -1;              ///< of the solid's boundary
  std::array<double, 3> weight{}; ///< of its corners
  double miss = 0;                ///< how far from the wanted place it is, in the plane
};

/// Of each node, where it lies on the floor: those on the outer rectangle or on a hole at the nearest point
/// of this loop, so that they are on a wall; others in the triangle that they are deepest in, of those not
/// turned over, else at the nearest. `floor` must be a rectangle, `grid` made from it. Loops: O(nodes edges)
/// on them; else O(1) a node, as a rule.
std::vector<FloorPoint> nodes_on_floor(const Solid& solid, const FloorMap& floor, const FloorGrid& grid);

} // namespace tetrarch::product
