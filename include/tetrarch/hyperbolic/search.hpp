// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The hyperbolic structure of a manifold, on whatever triangulation carries it.
///
/// A structure sits on a triangulation whose tetrahedra all exist in it; another triangulation of the same
/// manifold may have none. So, until a structure is found or the budget is spent: solve on the triangulation
/// as it is; on a simplified one; and on ones made from it by 2-3, 3-2 and 4-4 moves, by chance from a seed
/// and at the tetrahedra that degenerate. Now and then, the sooner the larger, the walk starts anew from
/// another small triangulation. No triangulation is solved twice.
///
/// Real boundary is coned and truncated first and finite vertices are merged away (moves/truncate.hpp): a
/// solid stands for its interior with geodesic boundary and cusps, balls filled into its spherical boundary.
/// Filling a sphere changes the manifold, and `filled_spheres` counts it: the structure is one of what was
/// given with so many balls filled in. A vertex whose link is a sphere, in a gluing without boundary there,
/// is a point of the manifold; merging it away changes the triangulation only. "Not found" is a statement
/// about the triangulations that were tried, never about the manifold. Source: mathematics of the
/// dissertation's section 4.3.3; the search is folklore (SnapPea does the like).

#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <array>
#include <cstdint>
#include <functional>

namespace tetrarch::hyperbolic {

struct SearchOptions {
  HyperbolizeOptions solve; ///< Newton's method does the search, whatever method is asked for here
  std::uint64_t seed = 1;
  /// Triangulations on which a structure is sought, the first two included. 0.05 to 1 milliseconds each up to
  /// a dozen tetrahedra. Of the gluings of up to four tetrahedra that are hyperbolic elsewhere, nearly all
  /// need less than ten. Fewer, once those tried have 250 times as many tetrahedra together: of 10,000
  /// tetrahedra 25 for 1000.
  int attempts = 1000;
  /// Triangulations may grow by so many tetrahedra above the simplified one.
  int most_extra_tets = 8;
  /// Asked once, with the simplified triangulation, when 25 triangulations carried no structure, or fewer
  /// large ones: whether it is known that there is none. Then the search ends.
  std::function<bool(const Triangulation&)> has_none;
};

struct Search {
  /// What the structure, or the last word about it, is on.
  Triangulation triangulation;
  /// Geometric; or what came of the simplified triangulation.
  Hyperbolization<double> structure;
  bool changed = false; ///< `triangulation` is not the one that was given
  /// Boundary spheres of the given triangulation that balls were filled into; where it is not 0,
  /// `triangulation` is one of another manifold than the given one.
  int filled_spheres = 0;
  int attempts = 0;
  /// How often each outcome was seen, by Outcome.
  std::array<int, outcome_count> seen{};
};

/// Throws PreconditionError for an empty or invalid triangulation and for one that is not connected.
/// Deterministic for a seed. A stop is thrown as `Stopped`.
[[nodiscard]] Search find_structure(const Triangulation& tri, const SearchOptions& options = {},
                                    const Progress& progress = {});

/// "geometric on the triangulation given", "no structure found on 1000 triangulations: 600 degenerate, ...".
std::string describe(const Search& search);

} // namespace tetrarch::hyperbolic
