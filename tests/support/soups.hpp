// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Small soups.

#include "support/errors.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/soup.hpp"

#include <array>
#include <string>
#include <vector>

namespace tetrarch::support::soups {

/// As if read from a MEDIT file: elements are numbered from 1 and have lines.
inline format::Soup soup_of(const std::vector<std::array<double, 3>>& points,
                            const std::vector<std::array<int, 4>>& tetrahedra,
                            const std::vector<std::array<int, 3>>& triangles = {}) {
  format::Soup soup;
  soup.points = points;
  soup.tetrahedra = tetrahedra;
  soup.triangles = triangles;
  return format::read_medit(format::write_medit(soup), "f");
}

/// The corners of a cube with the axes' diagonal, 4x+2y+z, and the six tetrahedra around that diagonal, one
/// for each order of the axes. Half of them are positive: those of the even orders.
inline std::vector<std::array<double, 3>> cube_points() {
  return {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};
}
inline std::vector<std::array<int, 4>> cube_tetrahedra() {
  return {{0, 4, 6, 7}, {0, 2, 3, 7}, {0, 1, 5, 7}, {0, 4, 5, 7}, {0, 2, 6, 7}, {0, 1, 3, 7}};
}
/// The cube's boundary, seen counter-clockwise from outside.
inline std::vector<std::array<int, 3>> cube_surface() {
  return {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
          {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
}

} // namespace tetrarch::support::soups
