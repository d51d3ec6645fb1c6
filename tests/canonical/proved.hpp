// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Canonical cells with their proofs, for tests.

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/verified/structure.hpp"

#include <string>

namespace tetrarch::support {

/// The lengths of a structure on this triangulation, certified; empty if they are not.
inline hyperbolic::Metric<numeric::Ball> certified_lengths(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  const auto found = hyperbolic::hyperbolize(tri, skeleton);
  if (found.outcome != hyperbolic::Outcome::geometric) return {};
  const auto result = verified::certify(tri, skeleton, found);
  return result.proof ? result.proof->lengths : hyperbolic::Metric<numeric::Ball>();
}

/// The cells, proved if that succeeds.
inline canonical::Canonical proved(canonical::Canonical c) {
  const auto lengths = certified_lengths(c.triangulation);
  if (lengths.size() > 0)
    c.proof = canonical::certify_cells(c.triangulation, Skeleton(c.triangulation), lengths, c.flat);
  return c;
}

inline canonical::Canonical proved(const std::string& signature) {
  const Triangulation tri = from_signature(signature);
  return proved(canonical::canonize(tri, hyperbolic::hyperbolize(tri, Skeleton(tri))));
}

} // namespace tetrarch::support
