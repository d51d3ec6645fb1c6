// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// MEDIT's mesh files (`.mesh`), which TetGen, Gmsh and most mesh generators write.
///
///     MeshVersionFormatted 2
///     Dimension 3
///     Vertices
///     4                        how many
///     0 0 0 1                  coordinates and a reference, an integer that is passed over
///     ...
///     Triangles
///     4
///     1 3 2 7                  three vertices, counted from 1, and a reference: its tag
///     ...
///     Tetrahedra
///     1
///     1 2 3 4 0
///     End                      may be missing
///
/// A keyword that is none of these is passed over with the numbers after it (edges, corners, normals, ...),
/// quadrilaterals with a warning; volume elements other than tetrahedra are refused, since the rest would be
/// another solid. "#" begins a comment. Coordinates of dimension 2 are refused, as is the binary form
/// (`.meshb`). Source: Frey, "MEDIT: an interactive mesh visualization software" (INRIA RT-0253, 2001).

#include "tetrarch/format/soup.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// Throws InputError. O(length).
Soup read_medit(std::string_view text, const std::string& source);
/// The references of triangles are their tags; all others are 0. O(size).
std::string write_medit(const Soup& soup);

/// Hexahedra alone: vertices bottom counterclockwise from above, then top likewise, which is the order of
/// Gmsh too. `references` are one for each, or none: 0. Throws PreconditionError for an index out of range,
/// and for other numbers of references. O(size).
std::string write_medit_hexahedra(const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<int, 8>>& hexahedra,
                                  const std::vector<int>& references = {});

} // namespace tetrarch::format
