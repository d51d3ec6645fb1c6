// SPDX-License-Identifier: GPL-2.0-or-later

/// A second route to the volume, which knows nothing of dilogarithms: Schlaefli's formula from length 0.
///
/// Shrink all lengths of a compact structure by t from 1 to 0. There every tetrahedron is the limit with all
/// angles 0, of volume v = 3.6638623767... (the regular ideal octahedron's). With Theta_e the sum of angles
/// around e at t l, dV = -1/2 sum l dTheta integrates by parts to
///
///     V = T v + 1/2 (integral over t from 0 to 1 of sum l_e Theta_e(t l) dt - 2 pi sum l_e),
///
/// and the integrand is analytic on all of [0, 1]: Gauss's rule converges geometrically.

#include "certified.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/hyperbolic/volume.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <utility>
#include <vector>

using namespace tetrarch;
using numeric::Ball;

namespace {

/// Nodes and weights of Gauss's rule with n points on [0, 1], by Newton's method
/// on Legendre's polynomial. Its recurrence takes two bits a degree.
std::vector<std::pair<Ball, Ball>> gauss_rule(int n) {
  const numeric::WorkingPrecision more(numeric::working_precision() + 3 * n);
  std::vector<std::pair<Ball, Ball>> rule;
  for (int k = 0; k < n; ++k) {
    Ball x = std::cos(M_PI * (k + 0.75) / (n + 0.5));
    Ball slope = 0;
    for (int step = 0; step < 12; ++step) {
      Ball p = 1;
      Ball q = 0; // the polynomial of degree one less
      for (int j = 1; j <= n; ++j) {
        const Ball next = ((2 * j - 1) * x * p - (j - 1) * q) / j;
        q = std::exchange(p, next);
      }
      slope = n * (q - x * p) / (1 - x * x);
      x = numeric::midpoint(x - p / slope);
    }
    rule.emplace_back((1 + x) / 2, 1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

Ball integrand(const support::Certified& c, const hyperbolic::Metric<Ball>& lengths, const Ball& t) {
  Ball sum = 0;
  for (int tet = 0; tet < c.tri.size(); ++tet) {
    auto six = hyperbolic::lengths_at(c.skeleton, lengths, tet);
    auto shrunk = six;
    for (Ball& length : shrunk) length *= t;
    const auto angles = hyperbolic::dihedral_angles(shrunk, hyperbolic::all_hyperideal);
    REQUIRE(angles);
    for (int e = 0; e < 6; ++e) sum += six[e] * (*angles)[e];
  }
  return sum;
}

} // namespace

TEST_CASE("volumes to 100 digits agree with an integral", "[verified]") {
  const numeric::WorkingPrecision precise(420);
  const auto rule = gauss_rule(300);
  // The limit of a tetrahedron with all angles 0: 8 Lobachevsky(pi/4) = 4 Catalan's constant, OEIS A006752.
  const Ball octahedron = 4 * hyperbolic::clausen(Ball(numeric::pi<Ball>() / 2));
  std::set<std::string> volumes;
  for (const int tets : {2, 3})
    for (const catalogue::Manifold& m : catalogue::stored_table(tets)) {
      if (m.cusps > 0 || !volumes.insert(m.volume.substr(0, 20)).second) continue;
      CAPTURE(m.name);
      const support::Certified c(m.signature);
      const auto result = verified::certify_to(100, c.tri, c.skeleton, c.found);
      REQUIRE(result.proof);
      hyperbolic::Metric<Ball> lengths = result.proof->lengths;
      for (Ball& length : lengths) length = numeric::midpoint(length);
      Ball twice = 0;
      for (const auto& [t, weight] : rule) twice += weight * integrand(c, lengths, t);
      for (const Ball& length : lengths) twice -= 2 * numeric::pi<Ball>() * length;
      const Ball volume = tets * octahedron + twice / 2;
      CHECK(abs(numeric::midpoint(volume) - numeric::midpoint(result.proof->volume)) < ldexp(Ball(1), -335));
    }
  CHECK(volumes.size() == 18); // FMP 2004: one of two tetrahedra, 18 of three, of which one has a cusp
}
