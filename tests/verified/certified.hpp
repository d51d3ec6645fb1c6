// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Manifolds with their proofs, for tests.

#include "tetrarch/core/signature.hpp"
#include "tetrarch/verified/certificate.hpp"
#include "tetrarch/verified/structure.hpp"

#include <optional>
#include <string>

namespace tetrarch::support {

/// A gluing, its structure in doubles, and what the proof came to.
struct Certified {
  Triangulation tri;
  Skeleton skeleton;
  hyperbolic::Hyperbolization<double> found;
  verified::Certification result;

  explicit Certified(const std::string& signature, const verified::CertifyOptions& options = {})
      : tri(from_signature(signature)), skeleton(tri), found(hyperbolic::hyperbolize(tri, skeleton)) {
    if (found.outcome == hyperbolic::Outcome::geometric)
      result = verified::certify(tri, skeleton, found, options);
  }
  std::string text() const { return verified::certificate(tri, skeleton, *result.proof); }
};

} // namespace tetrarch::support
