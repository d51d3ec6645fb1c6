// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// MEDIT's mesh files (`.mesh`), which TetGen, Gmsh and most mesh generators write.
///
///     MeshVersionFormatted 2
///     Dimension 3
///     Vertices
///     4                        how many
///     0 0 0 1                  coordinates and a reference, an integer that is passed over here
///     ...
///     Triangles
///     4
///     1 3 2 7                  three vertices, counted from 1, and a reference
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

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throws InputError. O(length).
Soup read_medit(std::string_view text, const std::string& source);
/// All references are 0. O(size).
std::string write_medit(const Soup& soup);

} // namespace tetrarch::format
