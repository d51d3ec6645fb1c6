// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Codes of diagrams.
///
///     embedding:2 { 0: (3, 4, 5), 1: (2, 5, 4), 2: (1, 3, 5, 5), ... }     the embedding format
///     PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]                      planar diagram of KnotTheory
///     X[1, 2, 3, 4] V[1, 5, 6] ...                                         with vertices of a graph
///     [[1, 4, 2, 5], [3, 6, 4, 1], [5, 2, 6, 3]]                           the same as a list
///     braid 1 -2 1 -2     Braid[3, {1, -2, 1, -2}]     BR(3, [1, -2])      closures of braids
///     DT[4, 6, 2]         DT: [(6, 8), (2, 4)]         DT[cacbca]          Dowker and Thistlethwaite
///     Conway[2 1 1 2]     Conway[3, 2 1, -2]                               rational and Montesinos links
///     Gauss[-1, 2, -3, 1, -2, 3]    O1-U2-O3-U1-O2-U3                      Gauss codes
///
/// *Embedding format* (of Paolini's appcontour): each vertex lists its neighbors counterclockwise, or
/// clockwise after `-{`. Vertices of valence 4 are crossings, if the choice says so: they are numbered in the
/// order of the list from the lowest bit, and bit 0 means that the strand through the first and third place
/// passes over, bit 1 the other one. A word "o" or "odd" before the list of a crossing says 0, "e" or "even"
/// 1. Parallel arcs are paired so that the places at one end follow one another in the order opposite to that
/// at the other; where they do not lie side by side, so that the diagram is plane.
///
/// *Planar diagrams*: each arc has a number that occurs twice. X[i, j, k, l] lists the arcs of a crossing
/// counterclockwise from the one by which the lower strand comes in, V[i, j, ...] those of a vertex, P[i, j]
/// of a point on an arc; Loop[i] is a circle.
///
/// *Conway's notation*: "a b" is a reflected in the diagonal and b beside it; "a, b, c" sets tangles side by
/// side, with "+" or "-" at the end for a crossing more. Polyhedra are not read.
///
/// *Gauss and DT codes* do not say on which side a strand crosses: it is found by embedding a graph in the
/// plane (Boyer and Myrvold), where the four arcs of a crossing are held in order by a wheel. A prime diagram
/// is determined up to its mirror image in a line of the plane (which mirrors the manifold); one that is a
/// sum may come out as another sum. Sources: Dowker and Thistlethwaite (1983); Boyer and Myrvold (2004).

#include "tetrarch/diagram/diagram.hpp"

#include <string>
#include <string_view>

namespace tetrarch::diagram {

/// Whether the text begins like one of the codes above that has a word of its own ("embedding", "PD", "X[",
/// "braid", "DT", "Gauss", "Conway", "O1"), or like a list of lists of numbers. O(1).
bool looks_like_diagram(std::string_view text);

/// The diagram. Lines that begin with '#' are passed over. Throws InputError that names the line and what was
/// expected: lists that do not close, an arc with one end or three, a rotation that is not plane (with its
/// genus), letters where numbers are expected. O(length), of Gauss codes near-linear.
Diagram read_diagram(std::string_view text, const std::string& source);

} // namespace tetrarch::diagram
