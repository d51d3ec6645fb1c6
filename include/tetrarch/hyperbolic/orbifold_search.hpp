// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A structure with marked edges or finite vertices, on whatever triangulation carries it.
///
/// Solves on the triangulation given; on one made smaller; and on others made by random moves that keep the
/// marks, until every tetrahedron is positively oriented or the attempts are spent. Then the best is
/// returned: a solution in which the fewest tetrahedra are turned over or flat. What else is found stays a
/// statement about the triangulations that were tried.

#include "tetrarch/hyperbolic/orbifold.hpp"

#include <array>
#include <cstdint>

namespace tetrarch::hyperbolic {

struct OrbifoldSearchOptions {
  OrbifoldOptions solve;
  std::uint64_t seed = 1;
  /// Triangulations to solve on, the first two included.
  int attempts = 40;
  /// Triangulations may grow by so many tetrahedra above the small one.
  int most_extra_tets = 6;
};

struct OrbifoldSearch {
  Triangulation triangulation; ///< that `structure` is on
  Marks marks;                 ///< and its marks
  OrbifoldStructure structure;
  bool changed = false; ///< `triangulation` is not the one that was given
  int attempts = 0;
  std::array<int, orbifold_outcome_count> seen{}; ///< how often each outcome was seen
};

/// Throws PreconditionError for marks with a fault and for a triangulation that is not connected.
/// Deterministic for a seed. A stop is thrown as `Stopped`.
[[nodiscard]] OrbifoldSearch find_orbifold(const Triangulation& tri, const Marks& marks,
                                           const OrbifoldSearchOptions& options = {},
                                           const Progress& progress = {});

/// "geometric, on the triangulation given", "no structure found on 40 triangulations: 40 not_found.".
std::string describe(const OrbifoldSearch& search);

} // namespace tetrarch::hyperbolic
