// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Closed manifolds with their proofs, for tests.

#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/orbifold_search.hpp"
#include "tetrarch/verified/certificate.hpp"
#include "tetrarch/verified/structure.hpp"

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::support {

/// A closed manifold, a structure in doubles on some triangulation of it, and what the proof came to.
struct CertifiedClosed {
  Triangulation tri;
  Skeleton skeleton;
  hyperbolic::Hyperbolization<double> found;
  verified::Certification result;

  explicit CertifiedClosed(const std::string& signature, const verified::CertifyOptions& options = {})
      : CertifiedClosed(hyperbolic::find_orbifold(from_signature(signature), {}, few_attempts()), options) {}
  std::string text() const { return verified::certificate(tri, skeleton, *result.proof); }

private:
  /// Most are solved as they are given.
  static hyperbolic::OrbifoldSearchOptions few_attempts() {
    hyperbolic::OrbifoldSearchOptions options;
    options.attempts = 6;
    return options;
  }
  CertifiedClosed(const hyperbolic::OrbifoldSearch& search, const verified::CertifyOptions& options)
      : tri(search.triangulation), skeleton(tri) {
    found.lengths = search.structure.lengths;
    if (search.structure.outcome != hyperbolic::OrbifoldOutcome::geometric) return;
    found.outcome = hyperbolic::Outcome::geometric;
    result = verified::certify(tri, skeleton, found, options);
  }
};

/// The lengths of the cone manifold with the angle 2 pi / order around these edges, and no other
/// singularity;
/// nothing where it is not found.
inline std::optional<hyperbolic::Metric<double>> cone_lengths(const Triangulation& tri,
                                                              const Skeleton& skeleton,
                                                              const std::vector<EdgeId>& cones,
                                                              double order) {
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  for (const EdgeId e : cones) orders[e] = order;
  const auto found = hyperbolic::solve_orbifold(tri, skeleton, orders);
  if (found.outcome != hyperbolic::OrbifoldOutcome::geometric) return std::nullopt;
  return found.lengths;
}

struct ClosedVolume {
  std::string signature, volume, name;
};

/// The sample of the census of Hodgson and Weeks.
inline std::vector<ClosedVolume> closed_volumes() {
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/closed_volumes.txt");
  std::vector<ClosedVolume> list;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t first = line.find('|');
    const std::size_t second = line.find('|', first + 1);
    list.push_back(
        {line.substr(0, first), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
  return list;
}

} // namespace tetrarch::support
