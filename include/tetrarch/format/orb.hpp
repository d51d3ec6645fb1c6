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
///                                                     a blank line, then blocks that are passed over, of
///                                                     lengths and angles, and of peripheral curves
///     3                                               the drawing of the graph, which may be missing: points
///     0  117  53                                      with their places on the screen, y going down;
///     ...
///     2
///     0  0  1  0                                      straight segments from point to point, 1: drilled;
///     ...
///     1
///     0  108  97  5  4  0.52  0.47                    crossings: place, the segment above and the one below,
///     ...                                             and how far along each of them it is, from 0 to 1
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
/// expected. Singular curves are the edges of the drawn graph that are not drilled, numbered from 1 by their
/// first segments. (Which of the two segments of a crossing is above, no volume tells; Orb's code does, where
/// it reads the file.)

#include "tetrarch/format/document.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

inline constexpr std::string_view orb_header = "% orb";

/// The gluings, the name, and the orders of singular edges as marks. Throws InputError with the line at
/// fault, also where a face has no gluing or two. O(length).
Document read_orb(std::string_view text, const std::string& source);

/// The drawing of a graph, as the file has it.
struct OrbDrawing {
  struct Segment {
    int from = 0; ///< points
    int to = 0;
    bool drilled = false;
    int line = 0; ///< of the file
  };
  struct Crossing {
    int over = 0; ///< segments
    int under = 0;
    double along_over = 0; ///< from 0 at its beginning to 1
    double along_under = 0;
    int line = 0;
  };
  std::vector<std::array<int, 2>> points; ///< at most a million from 0 in either direction; y goes down
  std::vector<Segment> segments;
  std::vector<Crossing> crossings;
  std::vector<double> orders; ///< of singular curve k + 1, as the edges of the triangulation have it
};
/// Nothing where the file has no drawing. Throws InputError as `read_orb` does, and for a point or a segment
/// that there is none of, a segment from a point to itself, two orders of one curve. Whether the picture is
/// that of a diagram is not asked. O(length).
std::optional<OrbDrawing> read_orb_drawing(std::string_view text, const std::string& source);

} // namespace tetrarch::format
