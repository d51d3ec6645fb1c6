// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Canonical loops: 2g loops through a base point that open a closed surface of genus g to a polygon.
///
///            3              The boundary of the polygon, which lies to its left, reads
///          .----.             1 2 -1 -2 3 4 -3 -4 ...
///      4  /      \  -2
///        .        .         All 4g corners are copies of the base point; the loops meet nowhere else, and
///     -3 |        | -1      none meets itself. Side k runs along loop k, side -k back along its other bank.
///        .        .
///     -4  \      /  2       (Drawn: genus 2.)
///          '----'
///            1
///
/// A few handles are laid one after the other, in the surface cut open so far, and keep off each other at the
/// price of a detour: wide surfaces need hardly a split. Of many handles
///   1. each is opened by two short loops through a point of its own, near it: a ball of triangles around
///      it is all that is looked at (surface/handles.hpp in the sources);
///   2. what is left is a sphere with g holes. A tree of shortest paths leads from the base to all of them;
///      on each of its ways the four ends of a handle's loops move to the base, side by side
///      (surface/tails.hpp).
/// The boundary of the disk then goes around the tree, past one commutator after the other. Where loops pass
/// through one triangle, they cross its edges at new vertices.
///
/// Loops that are all at one base are long: where a closed curve separates m handles from it, they cross that
/// curve 4 m times at least, and 4 m times is what they do. On a chain of g handles that makes about g^2
/// crossings, on a wide surface g^1.5, whatever the way.
/// Source: Yin, section 7.1 (what is to be found; it does not say how); Erickson and Har-Peled, "Optimally
/// cutting a surface into a disk" (2004) (the cut locus).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <string>
#include <vector>

namespace tetrarch::surface {

struct CanonicalLoops {
  int base = 0;            ///< a vertex
  std::vector<int> length; ///< of loop k, at [k-1], in edges
  int edge_splits = 0;     ///< needed to keep loops apart
  int face_splits = 0;
};

/// Marks canonical loops 1 to 2g on a closed oriented surface without marks, through vertex `base`, or
/// through a vertex with short loops if there is no `base`. Throws `PreconditionError` unless the surface is
/// connected, closed, unmarked and of positive genus, and no mates are turned. Reports handles, and stops
/// between searches. O((n + result) log n) for n triangles where handles are found in balls of bounded size;
/// O(g n log n) at worst.
CanonicalLoops mark_canonical_loops(MarkedSurface& surface, int base = -1, const Progress& progress = {});

/// The boundary word of `cut_open(surface)`: one mark for each run of equal marks, from the first run of the
/// least positive mark. Throws `PreconditionError` unless it has exactly one boundary curve and no mates are
/// turned. O(n).
std::vector<int> boundary_word(const MarkedSurface& surface);

/// The fault of the marked loops, for audits; empty if they are canonical. O(n).
std::string why_not_canonical(const MarkedSurface& surface);

/// The edges of curve `mark`. O(n).
int length_of(const MarkedSurface& surface, int mark);

/// Splits edges of curve `mark` until it has at least `edges`: always the longest edge (without points, the
/// least often halved), and among equal ones the side of least number. Returns the number of splits. Throws
/// `PreconditionError` if there is no such curve. O(n + splits * log n).
int lengthen(MarkedSurface& surface, int mark, int edges);

} // namespace tetrarch::surface
