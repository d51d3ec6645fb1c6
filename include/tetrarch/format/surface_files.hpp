// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangle meshes from files: OBJ, OFF, STL and PLY.
///
///     OBJ                OFF                STL                      PLY
///     v 0 0 0            OFF                solid name               ply
///     v 1 0 0            4 4 6              facet normal 0 0 -1      format ascii 1.0
///     ...                0 0 0              outer loop               element vertex 4
///     f 1 3 2            ...                vertex 0 0 0             property double x
///     f 1/5/2 2 4        3 0 2 1            ...                      ...
///
/// OBJ counts points from 1, or from the last one backwards as -1; texture and normal numbers, names and
/// materials are passed over. OFF: also COFF, NOFF, STOFF and the like, whose extra numbers are passed over.
/// STL, text or binary (little-endian), has no points but corners: those of equal coordinates become one
/// point. PLY: text or binary of either order; elements and properties other than the points' x, y, z and the
/// faces' list of vertices are passed over. A face of more than three corners is refused: there is more than
/// one way to cut it.
/// Sources: Wavefront's OBJ specification; the Geomview manual, "OFF files"; Burns, "Automated Fabrication",
/// section 6.5 (STL); Turk, "The PLY polygon file format" (1994).

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throw InputError. O(length), expected for STL.
Soup read_obj(std::string_view text, const std::string& source);
Soup read_off(std::string_view text, const std::string& source);
Soup read_stl(std::string_view text, const std::string& source);
Soup read_ply(std::string_view text, const std::string& source);

/// Whether `text` has exactly the length that the count in a binary STL file announces.
bool is_binary_stl(std::string_view text);

/// The points and triangles; the tetrahedra are dropped. O(size).
std::string write_obj(const Soup& soup);
std::string write_off(const Soup& soup);
/// Text, with normals of zero length: readers compute them from the corners.
std::string write_stl(const Soup& soup);
/// Text.
std::string write_ply(const Soup& soup);

} // namespace tetrarch::format
