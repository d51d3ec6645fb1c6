// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One handle after the other: two loops through a point that cross there and meet nowhere else.
///
///        .------------.         Loop 1 goes once around the tube, loop 2 along it. Cut along both, the
///       /   ._____.    \        surface loses a handle and has one hole more, whose boundary reads
///      |   (___o===)==  |       1 2 -1 -2 up to its sense: four corners at the point o.
///       \      |       /
///        '-----|------'
///
/// 1. The discrete cut locus of the point: grow a disk from it, prune the edges where it meets itself or ends
///    freely; arcs remain, some of them from hole to hole.
/// 2. Loop 1 is a shortest one across an arc that is *linked* with another (they alternate on the boundary of
///    the disk), so that it does not cut the surface in two.
/// 3. Loop 2 is a shortest path from one bank of loop 1 to the other.
/// Loops that would touch what they must not are kept away by splitting edges.
/// Source: Erickson and Har-Peled, "Optimally cutting a surface into a disk" (2004) (the cut locus).

#include "lay_path.hpp"

namespace tetrarch::surface {

/// Marks loops 1 and 2 through vertex `base`, which must be inside, on a connected oriented surface of
/// positive genus without marks. The loops keep off its boundary. Edges from the base to itself are split
/// first. Returns the splits. A stop is heard between searches. O(n log n) for n triangles.
SplitCount lay_handle(MarkedSurface& surface, int base, const Tolls& tolls, const Progress& progress);

/// Marks canonical loops 1 to 2 `handles`, up to their names, through vertex `base` on a closed oriented
/// surface of that genus without marks: one handle after the other, in the surface cut open so far, each
/// from the corner between two finished commutators where its loops are shortest. A loop keeps off the
/// earlier ones at the price of a detour, so that a wide surface needs hardly a split; but each handle
/// costs some five searches of all that the earlier ones have left. Reports handles. O(g n log n).
SplitCount lay_handles_in_turn(MarkedSurface& surface, int base, int handles, const Progress& progress);

/// Whether the cyclic word, read from letter `start` on, is p q -p -q r s -r -s ...
bool is_product_of_commutators(const std::vector<int>& word, std::size_t start);

/// The marks along a boundary curve of the surface cut open, one for each run.
std::vector<int> runs(const MarkedSurface& surface, const std::vector<SideEnd>& curve);

} // namespace tetrarch::surface
