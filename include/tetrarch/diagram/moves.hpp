// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Moves of diagrams. None changes the graph in space.
///
/// Each makes a new diagram. A dart names its arc and the region to its left. Source: Reidemeister, "Knoten
/// und Gruppen" (1927); for graphs, Kauffman (1989).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/diagram.hpp"

#include <vector>

namespace tetrarch::diagram {

/// A kink on an arc, Reidemeister's first move. Walking from the dart, one comes to the new crossing, turns
/// to the left (or right) round a loop and crosses the way one came; the first passage is over or under.
struct Kink {
  int dart = 0;
  bool left = true;
  bool over_first = true;
};
/// O(darts), for all of them together; their arcs must differ. Throws PreconditionError otherwise.
Diagram with_kinks(const Diagram& diagram, const std::vector<Kink>& kinks);

/// Pushes the arc of `mover` over (or under) that of `other`, Reidemeister's second move: two crossings more.
/// Both have one region to their left, or lie in two parts, which makes one part of them. Throws
/// PreconditionError otherwise, or if the arcs are the same. O(darts).
struct Poke {
  int mover = 0;
  int other = 0;
  bool over = true;
};
Diagram with_poke(const Diagram& diagram, const Poke& poke);

/// Whether the region to the left of the dart is that of a kink, a region with one corner, at a crossing.
/// O(1).
bool is_kink(const Diagram& diagram, int dart);
/// Whether it has two corners, at two crossings, and one of its arcs passes over at both. O(1).
bool is_poke(const Diagram& diagram, int dart);
/// Whether it has three corners, at three crossings, and of its arcs one passes over at both its ends and one
/// under at both. O(1).
bool is_triangle(const Diagram& diagram, int dart);

/// Whether it has two corners, at a vertex (of valence 3 or more) and a crossing: two edges are twisted
/// there. The dart may be either. O(1).
bool is_twist(const Diagram& diagram, int dart);

/// The inverses of the first two moves, and the third: the strand that passes over the other two is pushed
/// across their crossing. Throw PreconditionError unless the region is of that kind. O(darts).
Diagram without_kink(const Diagram& diagram, int dart);
Diagram without_poke(const Diagram& diagram, int dart);
Diagram with_triangle_turned(const Diagram& diagram, int dart);
/// The crossing goes, and the two edges change places at the vertex (the fifth move).
Diagram without_twist(const Diagram& diagram, int dart);
/// Makes a twist: the dart stands at a vertex of valence 3 or more, and changes places with the next one
/// counterclockwise.
Diagram with_twist(const Diagram& diagram, int dart, bool over);

/// Pushes a vertex of valence 3 along its edge through the next crossing: the two other edges follow it, and
/// cross what it crosses, so that there is one crossing more (the fourth move). The dart stands at the
/// vertex, and its arc ends at a crossing. Throws PreconditionError otherwise. O(darts).
Diagram with_vertex_passed(const Diagram& diagram, int dart);

/// Whether the dart's arc joins two vertices of valence 3. O(1).
bool is_ih(const Diagram& diagram, int dart);
/// The IH move, which changes the graph and not its neighborhood: the edge shrinks to a point and another one
/// grows there, across it in the plane.
///
///     b       f          b     f
///      >--d--<     to     >---<  turned by a right angle: b and c below one vertex, f and a at the other
///     a       c
///
/// A handlebody-knot is a spatial graph of valence 3 up to isotopy and such moves. Throws PreconditionError
/// unless `is_ih`. Source: Ishii, "Moves and invariants for knotted handlebodies" (2008). O(darts).
Diagram with_ih(const Diagram& diagram, int dart);

/// A diagram of a graph with the same neighborhood and few crossings: `simplified`, and IH moves along edges
/// with two crossings or fewer, those that twist the edges included, as long as they lead to fewer crossings,
/// or for a while to as many. The graph may change, a theta curve to a handcuff graph for instance. Not
/// always the fewest. Some dozens of milliseconds for ten crossings; a diagram in several parts is only
/// `simplified`.
Diagram simplified_handlebody(const Diagram& diagram, const Progress& progress = {});

/// Without the vertices of valence 2, but for one on each circle without crossings. O(darts).
Diagram without_points(const Diagram& diagram);

/// The same graph with fewer crossings: takes kinks, pokes and twists away, and lays a strand that passes
/// over (or under) all that it crosses along a shorter way, until nothing helps. Not always the fewest: some
/// unknots resist. Greedy; O(darts) for each move.
Diagram simplified(const Diagram& diagram, const Progress& progress = {});

/// The same graph as a diagram in one part: each further part is pushed over the first. Two crossings more
/// for each. O(darts).
Diagram connected(const Diagram& diagram);

} // namespace tetrarch::diagram
