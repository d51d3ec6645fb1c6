// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Solved triangulations with their inner products, and random geometric ones of the same manifold.

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <algorithm>
#include <stdexcept>

namespace tetrarch::support {

inline canonical::Decorated<double> decorated(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  const auto structure = hyperbolic::hyperbolize(tri, skeleton);
  if (structure.outcome != hyperbolic::Outcome::geometric) throw std::runtime_error("no structure");
  return canonical::decorate(tri, skeleton, structure.lengths);
}

/// So many random 2-3 moves at faces that the new edge crosses well inside: the new tetrahedra exist, whether
/// the face was convex or concave. Inner products ride along.
inline canonical::Decorated<double> scrambled(canonical::Decorated<double> m, int moves, SplitMix64& random) {
  for (int made = 0, tries = 0; made < moves && tries < 1000; ++tries) {
    const TetFace face{random.below(m.tri.size()), random.below(4)};
    const auto ball = moves::two_three_ball(m.tri, face);
    if (!std::holds_alternative<moves::Ball>(ball)) continue;
    const auto across = canonical::look_across(m, face);
    const auto& shared = face_vertex[face.face];
    if (std::any_of(shared.begin(), shared.end(), [&](int v) { return across.a[v] < 1e-3; })) continue;
    m = canonical::move(m, std::get<moves::Ball>(ball), 3, 4, canonical::product_across(m, face, across));
    ++made;
  }
  return m;
}

} // namespace tetrarch::support
