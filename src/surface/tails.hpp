// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The loops of all handles, led to one base point along a tree.
///
///      o2    o3           Cut along the loops of its g handles, the surface is a sphere with g holes, so any
///       \   //            tree of ways from the base to the other handles' points cuts it into a disk. Each
///        \ //             way carries four strands, the ends of two loops. They go side by side, turn around
///         |||             the point, two to the left and two to the right, and take the place of the loops'
///         |||             first and last edges. (Drawn: two strands instead of four for each handle.)
///          *
///
/// The tree is one of shortest paths through the triangles. A way enters the star of a handle's point through
/// its *gate*, a triangle with two new corners, and no other way passes there.
///
/// No choice of loops needs fewer strands: where a closed curve separates m handles from the base, loops that
/// cut these to a disk cross it at least 4 m times. (The loops cut that part, of Euler number 1 - 2m, into
/// disks by arcs from the curve to itself; each arc raises the Euler number by one; so there are 2m arcs or
/// more, of two ends each.) So the loops are as long as the sum over handles of their distance, in the end:
/// g^2 edges on a chain of handles, less on wider surfaces.

#include "handles.hpp"

namespace tetrarch::surface {

/// Leads all loops to the point of handle 0; or, if the base is free, to the point of another one near the
/// middle of the ways from there, where no branch leads to more than half of the handles: that one becomes
/// handle 0. A stop is heard between stages. O((n + result) log n) for n triangles.
SplitCount lay_tails(MarkedSurface& surface, Handles& handles, bool base_is_free, const Progress& progress);

} // namespace tetrarch::surface
