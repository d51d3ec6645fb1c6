// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Curves and graphs in space, given by points and straight segments, and their diagrams.
///
/// The picture is what an eye sees from a random place outside: the sphere of directions from there. Three
/// points turn left in it exactly if they and the eye span a positive tetrahedron, so every question is the
/// sign of a volume and is answered exactly: where two segments cross, which is nearer to the eye, in which
/// order a segment meets others (numeric: predicates; rational numbers where doubles do not decide). A place
/// from which three things fall together is changed for another one. So the diagram is that of the segments
/// as given, to the last bit of their coordinates.
///
/// Source: perspective pictures of knots are textbook matter; the reduction, Koniaris and Muthukumar,
/// "Knottedness in ring polymers" (1991), and Taylor (2000).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/diagram.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::diagram {

/// Points with any number of segments at each; a closed curve has two at each of its points.
struct Curve {
  std::vector<numeric::Point> points;
  std::vector<std::array<int, 2>> segments;
};

/// Whether the text is a list of points, three numbers a line, or Wavefront OBJ with lines ("l") and no
/// faces. O(length).
bool looks_like_curve(std::string_view text);

/// Three numbers a line: the points of a closed curve in order; an empty line, or one without numbers,
/// begins the next component. The file of molecules "XYZ" (a count, a comment, an element before the
/// numbers) is such a list. OBJ: vertices "v" and lines "l"; a line of many vertices is closed only if it
/// ends where it begins. Throws InputError that names the line: fewer than three points of a closed curve,
/// what is no number or not finite, a segment from a point to itself or given twice. O(length).
Curve read_curve(std::string_view text, const std::string& source);

/// The same curve with fewer points: a point between two segments goes where no other segment meets the
/// triangle of the two. Repeats until none goes. O(n^2) in the worst case, n = 10,000: a second.
Curve reduced(const Curve& curve, const Progress& progress = {});

struct ProjectOptions {
  std::uint64_t seed = 1;
  int views = 4; ///< the one with the fewest crossings is taken
};

/// The diagram. Throws InputError if the curve meets itself (which segments do), if two points coincide, if
/// a point has no segment, if a coordinate is not finite, or if the curve is so small or large that there is
/// no place to look from. O((segments + pairs of them that are near in the picture) log).
Diagram project(const Curve& curve, const std::string& source, const ProjectOptions& options = {},
                const Progress& progress = {});

} // namespace tetrarch::diagram
