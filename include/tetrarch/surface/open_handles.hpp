// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Opening handles: a surface of genus g, cut along g loops, becomes a sphere with 2g more holes.
///
///      .-------------.        .-------------.     Handle by handle, in the surface cut open so far: a
///     /   __     __   \      /   __     __   \    short loop that does not cut it in two and touches
///    |---(__)   (__)---| => |===(__)   (__)===|   neither boundary nor earlier loops. Its two banks
///     \               /      \               /    become boundary loops. (Drawn: a double torus, opened
///      '-------------'        '-------------'     by a loop around the tube beside either hole.)
///
/// A loop is the shortest that consists of two shortest paths from a root and an edge. The edge is one that
/// neither the tree of these paths nor a dual tree takes: then a dual loop crosses it and nothing else of the
/// loop, whose sides are thus connected. Roots are vertices far from each other, then vertices of the best
/// loop, while it gets shorter. So the loops are short, but nothing proves that they are the shortest.
///
/// On a coarse surface all vertices may be taken. If no loop is left, the middle of each edge inside that
/// joins two of them gets a vertex; the free vertices and the edges between them then have all loops of the
/// surface. Source: Yin, section 2.4.4; Erickson and Whittlesey, "Greedy optimal homotopy and homology
/// generators" (2005).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/surface/opened.hpp"

#include <vector>

namespace tetrarch::surface {

struct HandleLoop {
  int edges = 0;
  double length = 0;
};

struct OpenedHandles {
  OpenedMesh opened;
  std::vector<HandleLoop> loops; ///< in the order of their cutting; as many as handles
  int edge_splits = 0;
};

/// Cuts along a loop for each handle; on a sphere with or without holes there is nothing to do. Throws
/// InputError if the surface is not orientable. O(n log n) for each handle.
OpenedHandles open_handles(const OpenedMesh& opened, const Progress& progress = {});

} // namespace tetrarch::surface
