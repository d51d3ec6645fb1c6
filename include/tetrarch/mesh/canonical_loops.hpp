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
/// Handle by handle, in the surface cut open so far, whose boundary is one curve of finished commutators:
///   1. The discrete cut locus of a corner x between two commutators: grow a disk from x, prune the edges
///      where it meets itself; arcs remain. Of all such corners the one where step 2 is cheapest.
///   2. A shortest loop a from x across one of them that is *linked* with another (they alternate on the
///      boundary of the disk), so that a does not cut the surface in two.
///   3. A shortest path b from the copy of x that lies on a's own boundary curve to one of the others. The
///      boundary word W becomes W b a b^-1 a^-1: the next commutator.
/// Loops that would touch are kept apart by splitting edges.
/// Source: Yin, section 7.1 (what is to be found; it does not say how); Erickson and Har-Peled, "Optimally
/// cutting a surface into a disk" (2004) (the cut locus).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/mesh/marked_surface.hpp"

#include <string>
#include <vector>

namespace tetrarch::mesh {

struct CanonicalLoops {
  int base = 0;            ///< a vertex
  std::vector<int> length; ///< of loop k, at [k-1], in edges
  int edge_splits = 0;     ///< needed to keep loops apart
  int face_splits = 0;
};

/// Marks canonical loops 1 to 2g on a closed oriented surface without marks, through vertex `base`, or
/// through a vertex with short loops if there is no `base`. Throws `PreconditionError` unless the surface is
/// connected, closed, unmarked and of positive genus, and no mates are turned. Reports handles, and stops
/// between searches. Some five searches for each handle, O(g n log n) for n triangles in the end; n itself
/// grows by up to some ten splits for each triangle and ten handles.
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

} // namespace tetrarch::mesh
