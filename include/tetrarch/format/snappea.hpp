// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// SnapPea's triangulation files (`.tri`), which SnapPy and Regina read.
///
///     % Triangulation
///     figure eight                             the name, one line
///     geometric_solution  2.02988321           how far SnapPea got, and the volume
///     oriented_manifold                        or nonorientable_manifold, unknown_orientability
///     CS_unknown                               or CS_known and a number
///     1 0                                      torus cusps, Klein bottle cusps
///         torus   0.0   0.0                    per cusp: its kind, and its Dehn filling: 0 0 is complete
///     2                                        tetrahedra
///       1 1 1 1                                per tetrahedron: who lies across faces 0, 1, 2, 3
///       0132 1230 2310 2103                    by which permutations
///       0 0 0 0                                the cusp at each vertex, -1 for a finite one
///       ...                                    64 integers: meridian and longitude, each on two sheets
///       0.5 0.866                              the shape
///
/// Faces, vertices and permutations mean what they mean here. (SnapPea's edge e is our 5 - e, but no edge
/// number stands in the file.) Solution, volume, orientability, invariant and shapes are for people: SnapPea
/// computes them anew, and so they are checked and dropped. White space is free after the second line; blank
/// lines before the name, and a blank one in its place, are read as well.
/// Source: Weeks, "SnapPea Triangulation File Format" (1997), an annotated example.

#include "tetrarch/format/document.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

inline constexpr std::string_view snappea_header = "% Triangulation";
/// Stands for no name, as SnapPea cannot read an empty one.
inline constexpr std::string_view snappea_no_name = "unnamed";

/// The gluings and the name. Peripheral curves and Dehn fillings are passed over; the document is the
/// unfilled manifold. Throws InputError with the line where the text ends too early, is not as above, goes on
/// after the last tetrahedron, or states gluings that cannot be. O(length).
Document read_snappea(std::string_view text, const std::string& source);

/// How a ledger's entry of a filling that was passed over begins.
inline constexpr std::string_view dehn_filling = "Dehn filling";

/// The Dehn fillings that a file states.
struct DehnFillings {
  /// Of each tetrahedron, vertex and face how often the curves that are to bound disks enter the truncation
  /// triangle there, less how often they leave (moves/dehn_filling.hpp). No entries: there is no such curve.
  std::vector<std::array<std::array<std::int64_t, 4>, 4>> curves;
  std::vector<std::string> named; ///< those along these curves: "Dehn filling (1,2) of cusp 0"
  /// Those that make no manifold: slopes that are no coprime integers, or a file without peripheral curves.
  std::vector<std::string> left;
};

/// What `read_snappea` passes over of the same text; throws and costs as that does.
DehnFillings read_dehn_fillings(std::string_view text, const std::string& source);

/// The text, not solved, with no cusp stated: SnapPea finds them and chooses peripheral curves. Warns about
/// each vertex link that is neither sphere, torus nor Klein bottle (SnapPy refuses such a file; Regina reads
/// it), about a manifold without cusps, reversed edges, several components, and a name that does not fit on a
/// line. Throws InputError where there is a boundary face or no tetrahedron: the format has no way to say so.
/// O(n).
Written write_snappea(const Document& document);

} // namespace tetrarch::format
