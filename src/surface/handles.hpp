// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// All handles of a closed surface, each opened by two loops through a point of its own.
///
///       .--o--.    .--o--.    .--o--.       A handle is searched for in a ball of triangles around a place
///      /  (_)  \__/  (_)  \__/  (_)  \      that a handle must be near, since a shortest loop through the
///      \       /  \       /  \       /      base closes there. If a ball holds none, one of twice its size
///       '-----'    '-----'    '-----'       is tried, after all smaller ones.
///
/// The loops keep off the ways from the base to other places: all strands from there would go around them.
/// So a handle costs no more than its neighborhood has triangles, and the smallest ones are taken first. Cut
/// along all loops, the surface is a sphere with as many holes as handles.
/// Source of the places: Eppstein, "Dynamic generators of topologically embedded graphs" (2003).

#include "lay_path.hpp"

#include <vector>

namespace tetrarch::surface {

struct Handles {
  std::vector<int> point; ///< of handle k, at [k]; its loops have the marks 2k+1 and 2k+2
  SplitCount splits;
};

/// Marks 2g loops on a closed oriented surface of genus g >= 1 without marks. Handle 0 is at vertex `base`.
/// Reports handles, and stops between searches. O(n log n) for n triangles if each handle fits into a ball
/// of bounded size.
Handles lay_handles(MarkedSurface& surface, int base, const Progress& progress);

} // namespace tetrarch::surface
