// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/flips.hpp"

#include "canonical/scrambled.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/signature.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::canonical;
using support::decorated;

namespace {

double total_cone_volume(const Decorated<double>& m) {
  double sum = 0;
  for (int t = 0; t < m.tri.size(); ++t) sum += cone_volume(m, t);
  return sum;
}

} // namespace

TEST_CASE("every flip lowers the sum of cone volumes", "[canonical]") {
  int moves = 0;
  int flats = 0;
  // Stuck without flat tetrahedra; from geodesic boundary, too.
  for (const char* name : {"eLAkbbcddbulxn", "fLLQccceddehwhwww", "fLAMcbccdeeeejlhw", "eLAkbccddhhnxk"}) {
    const Decorated<double> start = decorated(from_signature(name));
    double before = total_cone_volume(start);
    Flips flips;
    FlipOptions options;
    for (options.most_moves = 1; flips.end != Flips::End::convex; ++options.most_moves) {
      Decorated<double> m = start;
      flips = flip_to_hull(m, options);
      REQUIRE((flips.end == Flips::End::convex || flips.end == Flips::End::exhausted));
      if (flips.moves < options.most_moves) break;
      const double after = total_cone_volume(m);
      CHECK(after < before - 1e-9);
      before = after;
    }
    moves += flips.moves;
    flats += flips.flat_tets;
  }
  CHECK(moves > 10);
  CHECK(flats > 3);
}

TEST_CASE("flips come down from geometric scrambles", "[canonical]") {
  // Adversarial starts: random 2-3 moves that keep all tetrahedra positive. Six in a hundred get stuck, and
  // the hull helps there.
  int tried = 0;
  int stuck = 0;
  int helped = 0;
  SplitMix64 random(7);
  for (const char* name : {"cPcbbbiht", "cPcbbbihq", "eLPkbcdddhggcv", "eLAkbbcddbulxn", "fLLQccceddehwhwww",
                           "dLQbcccdero", "eLAkbccddhlfir", "fLAMcbccdeeeejlhw"}) {
    const Decorated<double> start = decorated(from_signature(name));
    Decorated<double> lowest = start;
    REQUIRE(flip_to_hull(lowest).end == Flips::End::convex);
    const std::string expected = signature(lowest.tri);
    for (int k = 0; k < 50; ++k) {
      Decorated<double> m = support::scrambled(start, 1 + random.below(12), random);
      REQUIRE(m.tri.size() > start.tri.size());
      ++tried;
      const Decorated<double> high = m;
      if (flip_to_hull(m).end == Flips::End::convex) {
        CHECK(signature(m.tri) == expected);
        continue;
      }
      ++stuck;
      const Skeleton skeleton(high.tri);
      const auto structure = hyperbolic::hyperbolize_from(edge_lengths(high, skeleton), skeleton);
      if (structure.outcome != hyperbolic::Outcome::geometric) continue; // lengths beyond the solver's limit
      ++helped;
      const Canonical c = canonize(high.tri, structure);
      CHECK(c.isometry_signature == expected);
      CHECK(c.restarts == 0);
    }
  }
  CHECK(tried == 400);
  CHECK(stuck <= 40);
  CHECK(helped >= 15);
}

TEST_CASE("a move that does not fit its inner products is found out", "[canonical]") {
  Decorated<double> m = decorated(from_signature("eLAkbbcddbulxn"));
  for (Gram<double>& w : m.gram) {
    w[0][1] *= 1.01; // tetrahedra no longer agree about their common edges
    w[1][0] *= 1.01;
  }
  CHECK(flip_to_hull(m).end == Flips::End::inexact);
}
