// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The files of Orb, Heard's program for hyperbolic 3-orbifolds (`.orb`). They are read only.
///
///     % orb
///     8knot                                           the name
///     SolutionType geometric_solution
///     vertices_known                                  may be missing, and then the two vertices below too
///
///       1  0 1.000  1  1  2xv  1ux  2vw  1xv  2ux  1vw
///       2  0 1.000  1  1  2xw  1wx  2wu  1vu  2uv  1uw
///                                                     a blank line, then more that is passed over: lengths,
///                                                     angles, peripheral curves, a diagram of the graph
///
/// One line per edge class: its number from 1; the singular curve that it belongs to (0: none) and its order
/// (1: regular, 0: its meridian is parabolic); its two vertices; then the tetrahedra around it, in order.
/// There, "2xv" is tetrahedron 2, counted from 1, whose faces x and v meet at the edge, u,v,w,x being
/// 0,1,2,3: the walk comes in through the second and leaves through the first. The tetrahedra are oriented:
/// with f,g the two faces and p,q the ends of the edge, the permutation 0123 -> fgpq is always of the same
/// sign, which says how the ends follow each other. So every gluing is told three times, once for each edge
/// of the face.
///
/// Found by looking at five of the example files that come with Orb (DamianHeard/orb, "examples"), not at its
/// source: read like this and in no other way tried, all gluings agree, and edges, their degrees and vertices
/// are as the file says. None of them has boundary faces, and so none are
/// expected.

#include "tetrarch/format/document.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

inline constexpr std::string_view orb_header = "% orb";

/// The gluings, the name, and the orders of singular edges as marks. Throws InputError with the line at
/// fault, also where a face has no gluing or two. O(length).
Document read_orb(std::string_view text, const std::string& source);

} // namespace tetrarch::format
