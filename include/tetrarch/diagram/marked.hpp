// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Diagrams of graphs whose edges are not all drilled: some stay in space, with a cone angle or a parabolic
/// meridian.
///
/// Edges that are drilled shrink, each component of them to a vertex; the boundary of its neighborhood is the
/// link of that vertex, in which the edges that stay end as cone points. A component that is a tree leaves a
/// sphere with cone points: an orbifold's vertex of any valence. Source: Heard, Orb's documentation, 2007.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/diagram.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::moves {
struct MarkedTriangulation; // moves/marked.hpp
}

namespace tetrarch::diagram {

struct ExteriorOptions; // exterior.hpp

/// What becomes of an edge of the graph: its order (core: marks), or nothing: it is drilled.
using Fate = std::optional<double>;

struct MarkedDiagram {
  Diagram diagram;
  /// Of each dart, the same on both halves of an arc and on both sides of a crossing. At a vertex of valence
  /// 2 it may change.
  std::vector<Fate> fates;
};

/// All edges are drilled. O(darts).
MarkedDiagram all_drilled(Diagram diagram);
/// Whether some edge stays. O(darts).
bool keeps_edges(const MarkedDiagram& marked);
/// As diagram::edges, but an edge ends at a point of valence 2 where its fate changes. O(darts).
Classes edges(const MarkedDiagram& marked);
/// Of each of these. O(darts).
std::vector<Fate> fates_of_edges(const MarkedDiagram& marked);

/// The graph that is drawn in an Orb file (format: orb.hpp), seen as on the screen; nothing where none is
/// drawn. Edges are numbered by their first segments, as they are there. Points of valence 2 are left out,
/// unless a circle has no other or its two segments differ in being drilled. `fates` is as the file says.
///
/// Throws InputError that names the line: for a crossing of segments that do not cross, two segments that
/// cross where no crossing says so, or meet otherwise, and for a crossing in a wrong place along a segment.
/// Where the file's triangulation has other singular curves than the drawing, orders cannot be told and that
/// is an error, too, unless `drilled` asks for all edges drilled. O(segments^2).
std::optional<MarkedDiagram> read_orb_diagram(std::string_view text, const std::string& source,
                                              bool drilled = false);

/// The exterior of what is drilled, with the edges that stay as marked edges, with few tetrahedra; those of
/// order 1 go. A null edge between two cusps has no place in a triangulation (hyperbolic: orbifold) and is
/// drilled, too, which changes nothing: so a circle of order 0 becomes a cusp. As `exterior`; then
/// O(n^2).
moves::MarkedTriangulation marked_exterior(const MarkedDiagram& marked, const ExteriorOptions& options,
                                           const Progress& progress = {});
/// With the usual options.
moves::MarkedTriangulation marked_exterior(const MarkedDiagram& marked);

} // namespace tetrarch::diagram
