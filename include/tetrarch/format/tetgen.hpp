// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// TetGen's files: points in `NAME.node`, tetrahedra in `NAME.ele`, and perhaps triangles in `NAME.face`.
///
///     NAME.node   4 3 0 1           points, dimension, attributes, boundary marker?
///                 1 0 0 0 -1        number, coordinates, attributes, marker
///     NAME.ele    1 4 0             tetrahedra, 4 points each, a region attribute?
///                 1 1 2 3 4         number, points, attribute: its tag
///     NAME.face   4 1               triangles, boundary marker?
///                 1 1 3 2 -1        number, points, marker: its tag
///
/// Of each first line, all but the first number may be missing. Numbers count from 0 or from 1, as the first
/// line of the points says. "#" begins a comment. Tetrahedra of ten points are read by their corners. In
/// dimension 2, as Triangle writes, z is 0, and the elements are triangles of three points, or of six, which
/// are read by their corners. Further attributes and markers of points are passed over.
/// Sources: TetGen 1.5 user's manual, section 5.2; Shewchuk's Triangle, "File formats".

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// The texts of the files and what error messages call them.
struct TetgenFiles {
  std::string node;
  std::string ele;
  std::string node_source;
  std::string ele_source;
  std::string face = {}; ///< empty: there is none
  std::string face_source = {};
};

/// Throws InputError. O(length).
Soup read_tetgen(const TetgenFiles& files);
/// Counted from 1, without the sources. A surface is written in dimension 3 as elements of three points, with
/// no triangles beside. O(size).
TetgenFiles write_tetgen(const Soup& soup);

} // namespace tetrarch::format
