// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Down to the convex hull by 2-3 and 3-2 moves that pass through flat tetrahedra.
///
/// Draw the vertex vectors in R^{3,1}: the tetrahedra on them make a surface above the boundary of the convex
/// hull. Where it has a concave face, five vectors span a 4-simplex that sticks out. A 2-3 or a 3-2 move cuts
/// it off, and the surface comes down. Where one coordinate of the far vector is 0, the 2-3 move makes a
/// tetrahedron that stands upright: it is flat when seen from the origin. A later 3-2 move takes it away.
///
///     concave face ijk, far vector v' = a_f v_f + a_i v_i + a_j v_j + a_k v_k:
///       a_k <= 0 and the edge ij has three tetrahedra: 3-2 at ij
///       a_i, a_j, a_k >= 0: 2-3; the new tetrahedron that omits v_k is flat iff a_k = 0
///
/// Law: the sum of `cone_volume` changes by tilt * cone_volume < 0 in either move. So the walk ends; but it
/// may end where no move is possible. Source: Weeks 1993 for the moves and for passing through flat
/// tetrahedra.

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/progress.hpp"

#include <cstdint>
#include <vector>

namespace tetrarch::canonical {

struct FlipOptions {
  double margin = 1e-8; ///< a tilt or coordinate closer to 0 than this counts as 0
  int most_moves = 2000;
  std::uint64_t seed = 0; ///< 0: faces that stick out most come first; else a random one of those with a move
};

/// How the walk ended.
struct Flips {
  enum class End {
    convex,    ///< no face is concave, no tetrahedron is flat
    stuck,     ///< a concave face or a flat tetrahedron without a move
    exhausted, ///< `most_moves` were made
    inexact,   ///< a move did not change the sum of cone volumes as it must: rounding has taken over
  };
  End end = End::stuck;
  int moves = 0;
  int flat_tets = 0; ///< flat tetrahedra made on the way
  /// The moves, each to be made by `moves::replace` on what the ones before have left.
  std::vector<moves::Ball> path;
};

/// Mends concave faces until none is left. O(n) per move. Taking those first that stick out most gets stuck
/// from 6 in 1,000 of the minimal triangulations of cusped manifolds; of these half come through within forty
/// random orders.
template <class Scalar>
Flips flip_to_hull(Decorated<Scalar>& m, const FlipOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::canonical
