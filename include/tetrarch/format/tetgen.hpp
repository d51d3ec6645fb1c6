// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// TetGen's pair of files: points in `NAME.node`, tetrahedra in `NAME.ele`.
///
///     NAME.node   4 3 0 1           points, dimension 3, attributes, boundary marker?
///                 1 0 0 0 -1        number, coordinates, attributes, marker
///     NAME.ele    1 4 0             tetrahedra, 4 points each, a region attribute?
///                 1 1 2 3 4         number, points, attribute
///
/// Numbers count from 0 or from 1, as the first line of the points says. "#" begins a comment. Tetrahedra of
/// ten points are refused. Source: TetGen 1.5 user's manual, section 5.2.

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// The texts of both files and what error messages call them.
struct TetgenFiles {
  std::string node;
  std::string ele;
  std::string node_source;
  std::string ele_source;
};

/// Throws InputError. O(length).
Soup read_tetgen(const TetgenFiles& files);
/// Counted from 1, without the sources. Triangles are dropped. O(size).
TetgenFiles write_tetgen(const Soup& soup);

} // namespace tetrarch::format
