// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// MEDIT's mesh files (`.mesh`, binary `.meshb`), which TetGen, Gmsh and most mesh generators write.
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
///     1 2 3 4 0                four vertices and a reference: its tag
///     End                      may be missing
///
/// Quadrilaterals, pyramids, prisms and hexahedra are cut, elements of second order ("TetrahedraP2") read by
/// their corners. A keyword that is none of these is passed over with the numbers after it (edges, corners,
/// normals, ...); the ledger counts all that. In dimension 2, points have two coordinates, and z is 0. "#"
/// begins a comment. The binary form is that of libMeshb, versions 1 to 4, of either byte order.
/// Sources: Frey, "MEDIT: an interactive mesh visualization software" (INRIA RT-0253, 2001); the manual of
/// libMeshb (Marechal).

#include "tetrarch/format/soup.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// Throws InputError. O(length).
Soup read_medit(std::string_view text, const std::string& source);
/// Whether `text` begins as the binary form does: the integer 1, then a version, in either byte order.
bool is_binary_medit(std::string_view text);
/// Text. The references of triangles and tetrahedra are their tags, those of vertices 0. O(size).
std::string write_medit(const Soup& soup);

/// The same as bytes in the order of this machine: version 2, where positions in the file have 4 bytes, or
/// version 3, with 8 of them, from 2 GB on. O(size).
std::string write_meshb(const Soup& soup);

/// Hexahedra alone: vertices bottom counterclockwise from above, then top likewise, which is the order of
/// Gmsh too. `references` are one for each, or none: 0. Throws PreconditionError for an index out of range,
/// and for other numbers of references. O(size).
std::string write_medit_hexahedra(const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<int, 8>>& hexahedra,
                                  const std::vector<int>& references = {});

} // namespace tetrarch::format
