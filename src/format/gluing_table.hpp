// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Gluings as files state them, from both sides of every face, before anyone believes them.
///
/// A file may claim anything. The table holds the claims as they were read, `find_fault` names the first that
/// cannot be, and only a table without fault becomes a `Triangulation`.

#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// One entry per tetrahedron and face; tet -1 claims a boundary face.
using GluingTable = std::vector<std::array<Gluing, 4>>;

struct GluingFault {
  TetFace at;
  std::string what; ///< a sentence that names the faces and the contradiction
};

/// The first claim, in the order of (tetrahedron, face), that names a tetrahedron out of range, glues a face
/// to itself, or is contradicted by the face it names. O(n).
std::optional<GluingFault> find_fault(const GluingTable& table);

/// The triangulation of a table without fault. O(n).
Triangulation build(const GluingTable& table);

/// "0132" and the like, or nothing.
std::optional<Perm4> parse_perm(std::string_view text);

} // namespace tetrarch::format
