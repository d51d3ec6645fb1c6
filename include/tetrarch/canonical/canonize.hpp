// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The canonical (Epstein-Penner-Kojima) decomposition of a hyperbolic manifold with geodesic boundary and
/// cusps.
///
/// Faces are asked for convexity (decorated.hpp). While one is concave, a 2-3 or 3-2 move mends it, through
/// flat tetrahedra where need be (flips.hpp); inner products ride along. If no move applies, the cells are
/// built directly (hull.hpp). If that fails, too, a few random topological moves change the triangulation,
/// the structure is solved on it, and the work begins again. The triangulation that comes out is solved
/// again, and its tilts alone are believed. Faces that are flat belong to cells that are no tetrahedra. Every
/// cusp gets a cross-section of area `cusp_area`: with geodesic boundary present the cells depend on it, so
/// it is part of the definition of the isometry signature.
///
/// Signs: in double precision a tilt within `sign_margin` of 0 is not believed. Then everything is decided
/// again in 60-digit arithmetic with the margin 1e-30; what still lies within it counts as flat, *confirmed
/// but not certified*. Source: Kojima 1990; Frigerio-Petronio 2004; Weeks 1993 for the moves.

#include "tetrarch/canonical/cells.hpp"
#include "tetrarch/canonical/cells_proof.hpp"
#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/marks.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::canonical {

struct CanonizeOptions {
  /// A double-precision tilt or coordinate closer to 0 than this goes to high precision. The structures are
  /// solved to 1e-12; conditioning has never cost more than three digits.
  double sign_margin = 1e-8;
  int move_budget = 2000; ///< geometric moves per attempt
  int restarts = 1000;    ///< attempts from a randomly changed triangulation, about 0.1 ms each
  std::uint64_t seed = 1;
};

/// The canonical decomposition, or how far the search for it came.
struct Canonical {
  enum class Outcome {
    canonical, ///< no face is concave
    stuck,     ///< a concave face without a move, after all restarts
  };
  Outcome outcome = Outcome::stuck;
  /// The last triangulation, subdividing the cells; its flat faces are only drawn.
  Triangulation triangulation;
  FlatFaces flat;
  bool has_flat_faces = false;
  /// The smallest |tilt| of a face that is not flat: how far every sign was from being in doubt.
  double smallest_tilt = 0;
  int geometric_moves = 0;
  bool by_hull = false; ///< flips got stuck, and the cells were built directly
  int restarts = 0;
  /// The cells' names by their number, and the triangulation that names the manifold: `triangulation` itself
  /// where all cells are tetrahedra, else the coned one (cells.hpp).
  std::vector<std::string> cells;
  Triangulation canonical_triangulation;
  /// Of marked edges (marked_canonize.hpp): those of `triangulation`, and those of `canonical_triangulation`.
  Marks marks, canonical_marks;
  /// Equal exactly for isometric manifolds (orientation forgotten), as far as the cells are proved.
  std::string isometry_signature;
  /// Whether the cells are proved. `canonize` proves nothing; whoever has certified lengths may
  /// (certify.hpp).
  CellsProof proof;
};

/// Canonises a solved structure (`structure.outcome` must be geometric, else PreconditionError).
/// Cost: O(n) per move; high precision only where a sign asks for it.
[[nodiscard]] Canonical canonize(const Triangulation& tri,
                                 const hyperbolic::Hyperbolization<double>& structure,
                                 const CanonizeOptions& options = {}, const Progress& progress = {});

/// The isometries, as automorphisms of the canonical triangulation; orientation-reversing ones included.
/// Marks go to marks of the same order.
std::vector<Isomorphism> isometry_group(const Canonical& canonical);

/// Whether two manifolds are isometric.
struct IsometryAnswer {
  enum class Verdict { isometric, not_isometric, undecided };
  /// What a yes or a no rests on.
  enum class Proof {
    none,        ///< undecided
    isomorphism, ///< of triangulations: a homeomorphism, hence an isometry (Mostow rigidity)
    boundary,    ///< the boundaries differ
    homology,    ///< the first homology groups differ
    volume,      ///< certified volumes lie in disjoint intervals
    cells,       ///< the canonical decompositions differ, and both are proved
    structure,   ///< one has a certified structure, the other is proved to have none
    covers,      ///< the first homology groups of covers of some degree differ
    marks,       ///< the marked edges differ: the orders of some, or at some vertex
  };
  Verdict verdict = Verdict::undecided;
  Proof proof = Proof::none;
  std::string reason;
  Isomorphism isometry; ///< between the triangulations that were compared, where isometric
};
/// The name as spelt above; stable, for JSON.
const char* to_string(IsometryAnswer::Proof proof);

/// Compares canonical triangulations. Where they are isomorphic, the manifolds are isometric, proved or not.
/// Where they differ, the manifolds are not isometric if both decompositions are proved; else undecided.
[[nodiscard]] IsometryAnswer compare(const Canonical& a, const Canonical& b);

} // namespace tetrarch::canonical
