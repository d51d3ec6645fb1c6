// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The Tetrarch file format: one JSON object, versioned.
///
///     {
///       "format": "tetrarch-triangulation",
///       "version": 1,
///       "name": "figure eight",                                             optional
///       "tetrahedra": 2,
///       "gluings": [
///         [[1, "0132"], [1, "1230"], [1, "2310"], [1, "2103"]],             one tetrahedron a line
///         [[0, "0132"], [0, "3201"], [0, "3012"], [0, "2103"]]
///       ],
///       "marks": [[0, "01", 3], [1, "23", 0]],                              optional
///       "metric": { "edge_lengths": [...], "dihedral_angles": [...], "volume": 2.02988321 },       optional
///       "canonical": { "cells": ["octahedron"], "cell_of": [...], "flat_faces": [...], ... },      optional
///       "bundle": { "fiber": 1, "euler_number": 2, "base_vertices": [...], ... },                  optional
///       "provenance": { ... }                                               optional
///     }
///
/// gluings[t][f] is null where face f of tetrahedron t is on the boundary, else the other tetrahedron and the
/// images of the vertices 0, 1, 2, 3. Each gluing is stated from both sides, and the two must agree. A length
/// or angle is a number, or a string of digits where a double would lose some; an infinite length is null.
/// A mark is a tetrahedron, one of its edges, and the order of the edge: 0 for a parabolic meridian, n for
/// the cone angle 2 pi / n; a class of edges is named once, by any of its edges, or more often with one
/// order. "canonical" and "bundle" are the structs of those names, member by member (document.hpp); of
/// flat_faces the numbers of those that are flat are written. The schema is
/// census/schema/triangulation.schema.json.
///
/// Laws: `write_json(read_json(text)) == text` for every text that `write_json` gave; members this version
/// does not know survive, in their places. Numbers of unknown members survive by value; one with more than 17
/// significant digits is refused rather than rounded.

#include "tetrarch/format/document.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

inline constexpr std::string_view json_format_tag = "tetrarch-triangulation";
inline constexpr int json_format_version = 1;
/// Arrays and objects may be nested this deep, unknown members included.
inline constexpr int json_deepest_nesting = 64;

/// Throws InputError with the line, the member and the cause for anything that is not as described above:
/// broken JSON, a repeated key, nesting too deep, another format or version, a missing member, a wrong type
/// or count, a permutation that is none, a tetrahedron out of range, a face glued to itself, twice, or not
/// alike from both sides, a list of another length than what it is about. Nothing is allocated on the
/// strength of a stated count. O(length).
Document read_json(std::string_view text, const std::string& source);

/// Canonical text. Members keep the order in which they were read; new ones follow in the order above.
/// Throws PreconditionError if a list of one entry per tetrahedron has another number of them. O(size).
std::string write_json(const Document& document);

} // namespace tetrarch::format
