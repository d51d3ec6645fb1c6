// SPDX-License-Identifier: GPL-2.0-or-later

/// Closed manifolds, whose only vertex is a point: volumes, and the argument that lets three equations go.

#include "closed.hpp"

#include "src/verified/edge_system.hpp"
#include "src/verified/gauge.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using numeric::Ball;
using support::CertifiedClosed;

namespace {

/// The sum of K times directions at one vertex, and the sum of |K|, over the ends of edges.
struct EndSums {
  std::array<double, 3> directed{};
  double sizes = 0;
};

EndSums end_sums(const CertifiedClosed& c, const hyperbolic::Metric<double>& lengths) {
  const auto k = hyperbolic::edge_curvature(c.skeleton, hyperbolic::dihedral_angles(c.skeleton, lengths));
  const auto motions = verified::Gauge(c.tri, c.skeleton).motions(lengths);
  EndSums sums;
  for (const EdgeId e : all<EdgeId>(k.size())) {
    for (std::size_t d = 0; d < 3; ++d) sums.directed[d] += k[e] * motions[e.value][d];
    sums.sizes += 2 * std::abs(k[e]); // both ends are at the only vertex
  }
  return sums;
}

double size_of(const std::array<double, 3>& x) {
  return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

} // namespace

TEST_CASE("closed manifolds are certified, and the intervals hold the census' volumes", "[verified]") {
  int count = 0;
  for (const support::ClosedVolume& known : support::closed_volumes()) {
    CAPTURE(known.name);
    const CertifiedClosed c(known.signature);
    if (c.found.outcome != hyperbolic::Outcome::geometric) continue;
    REQUIRE(c.result.proof);
    CHECK(c.result.proof->bits == 53);
    CHECK(c.result.proof->fixed.size() == 3);
    const auto [low, high] = verified::volume_interval(*c.result.proof);
    CHECK(std::stod(low) == Approx(std::stod(known.volume)).epsilon(0).margin(2e-11)); // 11 digits at least
    CHECK(std::stod(high) == Approx(std::stod(known.volume)).epsilon(0).margin(2e-11));
    ++count;
  }
  CHECK(count >= 80); // of 85: on some no triangulation is found all of whose tetrahedra are positive
}

TEST_CASE("the smallest closed manifold's volume to 50 digits", "[verified]") {
  // The Weeks manifold's is 3 * 23^(3/2) zeta_K(2) / (4 pi^4) for the cubic field K of discriminant -23
  // (Borel 1981), with zeta_K = zeta times the L-function of eta(z) eta(23 z), summed in 60 digits by mpmath.
  const CertifiedClosed c("jLvMLQQbfefgihhiixiptvvvgof");
  const auto precise = verified::certify_to(50, c.tri, c.skeleton, c.found);
  REQUIRE(precise.proof);
  const numeric::WorkingPrecision precision(precise.proof->bits);
  CHECK(numeric::certain_digits(precise.proof->volume, 50) ==
        "0.94270736277692772092129960309221164759032710576688");
}

TEST_CASE("moving the point changes no angle", "[verified]") {
  // The derivatives of the angles vanish in these directions, for they belong to one structure.
  for (const char* signature : {"jLvMLQQbfefgihhiixiptvvvgof", "jLvAzQQbefgihhiihxttasjvobr"}) {
    CAPTURE(signature);
    const CertifiedClosed c(signature);
    REQUIRE(c.result.proof);
    const auto motions = verified::Gauge(c.tri, c.skeleton).motions(c.found.lengths);
    const verified::EdgeSystem all_lengths(c.skeleton, std::vector<EdgeId>{});
    const auto h = all_lengths.hessian(c.found.lengths);
    double most = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      double size = 0;
      for (const auto& row : h.rows) {
        double change = 0;
        for (const auto& [column, value] : row) change += value * motions[column][d];
        CHECK(std::abs(change) < 1e-11);
      }
      for (const auto& row : motions) size += std::abs(row[d]);
      most = std::max(most, size);
    }
    CHECK(most > 1);
  }
}

TEST_CASE("curvatures at a point add up to nothing but for their squares", "[verified]") {
  // The bound that replaces the dropped equations, at random lengths, where all curvatures are there.
  support::Random random(19);
  double nearest = 0;
  for (const char* signature : {"jLvMLQQbfefgihhiixiptvvvgof", "kLLLLMQkacfgijjhiijnkgjitpemgn"}) {
    CAPTURE(signature);
    const CertifiedClosed c(signature);
    REQUIRE(c.result.proof);
    for (int trial = 0; trial < 300; ++trial) {
      hyperbolic::Metric<double> lengths = c.found.lengths;
      const double most = std::pow(10, -1 - trial % 4);
      for (double& length : lengths) length += most * (random.below(2001) - 1000) / 1000.0;
      const EndSums sums = end_sums(c, lengths);
      if (!(sums.sizes <= 2)) continue;
      CHECK(size_of(sums.directed) <= sums.sizes * sums.sizes / 2 + 1e-13);
      if (most < 0.01) nearest = std::max(nearest, size_of(sums.directed) / sums.sizes);
    }
  }
  CHECK(nearest < 0.01); // where K is small the sum is smaller by far
  CHECK(nearest > 0);
}

TEST_CASE("curvatures that need not vanish are not said to", "[verified]") {
  const CertifiedClosed c("jLvMLQQbfefgihhiixiptvvvgof");
  REQUIRE(c.result.proof);
  const verified::Gauge gauge(c.tri, c.skeleton);
  const std::vector<EdgeId>& fixed = c.result.proof->fixed;
  const hyperbolic::Metric<Ball>& box = c.result.proof->lengths;
  hyperbolic::Metric<Ball> k(box.size(), widened(Ball(0), Ball(1e-10)));
  CHECK(gauge.dropped_vanish(fixed, box, k));
  // One edge twice: three equations that are but two.
  CHECK_FALSE(gauge.dropped_vanish({fixed[0], fixed[0], fixed[1]}, box, k));
  CHECK_FALSE(gauge.dropped_vanish({fixed[0], fixed[1]}, box, k));
  // So large that a football of curvatures is not excluded.
  for (const EdgeId e : fixed) k[e] = widened(Ball(0), Ball(0.3));
  CHECK_FALSE(gauge.dropped_vanish(fixed, box, k));
}

TEST_CASE("cone manifolds are not certified", "[verified]") {
  // Three loops with other angles: all other equations hold, and the tetrahedra are there.
  const CertifiedClosed c("jLvMLQQbfefgihhiixiptvvvgof");
  REQUIRE(c.result.proof);
  const verified::Gauge gauge(c.tri, c.skeleton);
  int tried = 0;
  for (const EdgeId x : all<EdgeId>(c.skeleton.edge_count()))
    for (const EdgeId y : all<EdgeId>(x.value))
      for (const EdgeId z : all<EdgeId>(y.value)) {
        const auto lengths = support::cone_lengths(c.tri, c.skeleton, {z, y, x}, 1.1);
        if (!lengths) continue;
        CAPTURE(x.value, y.value, z.value);
        auto taken = c.found;
        taken.lengths = *lengths;
        CHECK_FALSE(verified::certify(c.tri, c.skeleton, taken).proof);
        // Here the point cannot be held by these three lengths: that is what the identity says.
        const auto k =
            hyperbolic::edge_curvature(c.skeleton, hyperbolic::dihedral_angles(c.skeleton, *lengths));
        hyperbolic::Metric<Ball> at(k.size(), Ball(0));
        hyperbolic::Metric<Ball> curvature(k.size(), Ball(0));
        for (const EdgeId e : all<EdgeId>(k.size())) {
          at[e] = (*lengths)[e];
          curvature[e] = k[e];
        }
        CHECK_FALSE(gauge.dropped_vanish({z, y, x}, at, curvature));
        ++tried;
      }
  CHECK(tried == 120); // 10 edges
}
