// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The canonical cells straight from the convex hull of the vertex vectors, without a single move.
///
/// The translates of the tetrahedra tile hyperbolic space, and their vertex vectors are an orbit of the
/// group. A functional phi with phi(v) = 1 on four of them and phi(v) >= 1 on all others supports a cell. An
/// oracle looks for a vector with phi(v) < 1 among the tiles that lie nearest to the functional's pole; the
/// simplex method leads to a first cell, and from each cell gift wrapping leads across its walls.
///
///     cell phi, wall psi = 0 (psi >= 0 on the cell): the next cell is phi + lambda psi, with lambda the
///     least (phi(v) - 1) / (-psi(v)) over psi(v) < 0
///
/// The oracle sees finitely many tiles and may miss a vector. But cells that are polytopes, paired along
/// their walls, strictly convex there and with angles of 2 pi around every edge are locally convex, hence the
/// whole hull: a missed vector is caught, and more tiles are looked at. An independent check of flips.hpp,
/// and what helps where those get stuck. Source: Epstein-Penner 1988 and Kojima 1990 for the hull; the
/// construction is ours.

#include "tetrarch/canonical/cells.hpp"
#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/progress.hpp"

#include <optional>
#include <vector>

namespace tetrarch::canonical {

/// A wall of a cell, and the wall of a cell that it is glued to.
struct HullWall {
  std::vector<int> corners; ///< numbers of the cell's corners, in cyclic order
  int other_cell = -1;
  int other_wall = -1;
  std::vector<int> images; ///< the corner of the other cell that meets `corners[k]`
};

/// A cell with corners 0, 1, ... .
struct HullCell {
  int corner_count = 0;
  std::vector<HullWall> walls;
};

/// How far the oracle looks before it says that there is no vector below 1.
struct HullBudget {
  int tiles = 240;
  /// Tiles farther from the pole than the horospheres and boundary planes of value 1 need not be looked at:
  /// no face reaches beyond these except those that end there. That is certain of cross-sections of area
  /// `canonical::cusp_area`; of larger ones, which bring much fewer tiles, it is a guess. 0: all tiles.
  double cusp_area = 4;
};

struct HullOptions {
  double margin = 1e-8; ///< values of phi - 1 and psi closer to 0 than this count as 0
  std::vector<HullBudget> budgets{{60, 4}, {240, 1}}; ///< in turn, until the check holds
  int starts = 2;                                     ///< first tiles that are tried for each
};
/// For where that fails: a short geodesic winds thousands of tiles around itself.
inline HullOptions patient_hull_options(double margin) {
  return {margin, {{1000, 4}, {4000, 1}, {4000, cusp_area}}, 2};
}

/// The cells with their gluings, or nothing if the check failed for every budget. `m` has no flat tetrahedra.
/// 0.1 to 2 ms for a dozen cells in double precision.
template <class Scalar>
std::optional<std::vector<HullCell>> direct_hull(const Decorated<Scalar>& m, const HullOptions& options = {},
                                                 const Progress& progress = {});

/// As for a triangulation whose flat faces are known. O(n).
CellDecomposition cell_decomposition(const std::vector<HullCell>& cells);

/// A triangulation that subdivides the cells, where each can be coned from one of its corners such that the
/// walls' diagonals fit; nothing if the search for such corners finds none within its budget.
std::optional<Triangulation> subdivision(const std::vector<HullCell>& cells);

} // namespace tetrarch::canonical
