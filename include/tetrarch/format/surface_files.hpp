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
/// OBJ counts points from 1, or from the last one backwards as -1; a backslash at the end of a line goes on
/// with the next. OFF: also COFF, NOFF, STOFF and the like, BINARY, with the counts glued to the head,
/// without the head or the number of edges. STL, text or binary (little-endian), has no points but corners:
/// those of equal coordinates become one point; several solids in one text are patches, whose tags count from
/// 0; keywords may be in capitals, the last solid may lack its end. PLY: text or binary of either order;
/// faces are lists vertex_indices or vertex_index, triangle strips are read too. Polygons are cut into
/// triangles. What else is there (normals, colors, names, materials, other elements and properties) is
/// counted in the ledger. Sources: Wavefront's OBJ specification; the Geomview manual, "OFF files"; Burns,
/// "Automated Fabrication", section 6.5 (STL); Turk, "The PLY polygon file format" (1994).

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
