// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Canonical cells with their proofs, for tests.

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/canonical/certify.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/verified/structure.hpp"

#include <optional>
#include <string>
#include <utility>

namespace tetrarch::support {

/// What is proved of the cells that these faces make of a triangulation; nothing where no structure is
/// certified on it.
inline std::optional<canonical::CellsProof> proof_of_cells(const Triangulation& tri,
                                                           const canonical::FlatFaces& flat) {
  const Skeleton skeleton(tri);
  const auto found = hyperbolic::hyperbolize(tri, skeleton);
  if (found.outcome != hyperbolic::Outcome::geometric) return std::nullopt;
  const auto result = verified::certify(tri, skeleton, found);
  if (!result.proof) return std::nullopt;
  canonical::Solvers solvers;
  solvers.merged = [&](const Table<EdgeId, int>& block, double reach) {
    return verified::solve_merged(skeleton, block, found.lengths, reach);
  };
  solvers.precise = [&](int bits) -> std::optional<hyperbolic::Metric<numeric::Ball>> {
    const auto precise = verified::certify(tri, skeleton, found, {bits, bits, false});
    if (!precise.proof) return std::nullopt;
    return precise.proof->lengths;
  };
  return canonical::certify_cells(tri, skeleton, result.proof->lengths, flat, solvers);
}

/// The cells, proved if that succeeds.
inline canonical::Canonical proved(canonical::Canonical c) {
  if (auto proof = proof_of_cells(c.triangulation, c.flat)) c.proof = *std::move(proof);
  return c;
}

inline canonical::Canonical proved(const std::string& signature) {
  const Triangulation tri = from_signature(signature);
  return proved(canonical::canonize(tri, hyperbolic::hyperbolize(tri, Skeleton(tri))));
}

} // namespace tetrarch::support
