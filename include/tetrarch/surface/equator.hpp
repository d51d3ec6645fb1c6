// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Equators: simple closed curves of edges that halve a sphere.
///
/// A disk grows over the sphere from a seed, triangle by triangle, and its rim is a simple closed curve all
/// the while. A triangle with two sides on the rim goes first, which shortens the rim; else the one whose
/// apex is nearest to the seed:
///
///            *                      *
///           / \                    / \            disk below; one edge more,
///     --*--*---*--*--   =>   --*--*   *--*--       and back again at the next triangle: one less
///
/// So the disk grows in rows. Among all rims from all seeds, the equator is one that halves the triangles as
/// evenly as its number of edges allows, or a shorter one that is a little less even.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <array>

namespace tetrarch::surface {

struct Equator {
  int edges = 0;                  ///< of the curve; more than wanted if no shorter one was found
  int edge_splits = 0;            ///< edge splits that lengthened it
  int face_splits = 0;            ///< that gave a disk its interior vertex
  std::array<int, 2> triangles{}; ///< of the two disks
};

/// Marks an equator (1) of `edges` edges on a sphere without marks, such that both disks have an interior
/// vertex; the bank of mark +1 belongs to the disk of triangle 0. If the curve has fewer edges, some are
/// split. It has more edges if the search found no shorter curve: on a simplicial mesh every curve has at
/// least three. Throws `PreconditionError` unless the surface is a sphere without marks. `seeds` triangles
/// are tried, far from each other; a stop is heard between them. O(seeds * n log n).
Equator mark_equator(MarkedSurface& sphere, int edges, int seeds = 8, const Progress& progress = {});

} // namespace tetrarch::surface
