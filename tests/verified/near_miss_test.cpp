// SPDX-License-Identifier: GPL-2.0-or-later

/// What has no structure is not certified, however near it comes.

#include "certified.hpp"

#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <string>

using namespace tetrarch;
using hyperbolic::Outcome;

namespace {

/// Newton's last state with nothing that stops a length from growing, taken for a structure.
hyperbolic::Hyperbolization<double> taken_for_geometric(const Triangulation& tri, const Skeleton& skeleton) {
  hyperbolic::HyperbolizeOptions lax;
  lax.tolerance = 1e-6;
  lax.step_tolerance = HUGE_VAL;
  lax.length_limit = 40;
  auto found = hyperbolic::hyperbolize(tri, skeleton, lax);
  found.outcome = Outcome::geometric;
  return found;
}

} // namespace

TEST_CASE("false convergence is never certified", "[verified]") {
  // dLQacccjcog and its like; the first has a residual below 1e-6 with all tetrahedra there.
  int refused = 0;
  int small_residual = 0;
  for (const int tets : {3, 4}) {
    std::ifstream in(std::string(TETRARCH_SOURCE_DIR) + "/tests/oracle/false_convergence_" +
                     std::to_string(tets) + ".txt");
    for (std::string line; std::getline(in, line);) {
      const Triangulation tri = from_signature(line);
      const Skeleton skeleton(tri);
      if (hyperbolic::hyperbolize(tri, skeleton).outcome == Outcome::geometric) continue;
      const auto near_miss = taken_for_geometric(tri, skeleton);
      if (near_miss.lengths.size() != skeleton.edge_count()) continue;
      CAPTURE(line);
      const auto result = verified::certify(tri, skeleton, near_miss);
      CHECK_FALSE(result.proof);
      CHECK_FALSE(result.why_not.empty());
      ++refused;
      small_residual += near_miss.residual < 1e-6 ? 1 : 0;
    }
  }
  // As tests/hyperbolic/false_convergence_test.cpp counts them.
  CHECK(refused == 203);
  CHECK(small_residual >= 100);
}

TEST_CASE("a start far from the structure is not certified, or leads to it", "[verified]") {
  const support::Certified good("dLQbcccdero");
  REQUIRE(good.result.proof);
  int refused = 0;
  for (int k = 1; k <= 40; ++k) {
    auto moved = good.found;
    for (const EdgeId e : all<EdgeId>(moved.lengths.size()))
      moved.lengths[e] += 0.05 * k * (e.value % 2 == 0 ? 1 : -1);
    const auto result = verified::certify(good.tri, good.skeleton, moved);
    if (!result.proof) {
      ++refused;
      continue;
    }
    CHECK(numeric::overlap(result.proof->volume, good.result.proof->volume));
  }
  CHECK(refused > 0);
}

TEST_CASE("only what was solved is certified", "[verified]") {
  const support::Certified good("cPcbbbihq");
  const support::Certified other("cPcbbbiht");
  CHECK_THROWS_AS(verified::certify(other.tri, other.skeleton, good.found), PreconditionError);
  auto failed = good.found;
  failed.outcome = Outcome::degenerate;
  CHECK_THROWS_AS(verified::certify(good.tri, good.skeleton, failed), PreconditionError);
}

TEST_CASE("more unknown lengths than asked for are not certified, and that is said", "[verified]") {
  verified::CertifyOptions options;
  options.most_unknowns = 1; // of the knotted Y, which has one edge
  CHECK(support::Certified("cPcbbbihq", options).result.proof);
  options.most_unknowns = 0;
  const auto refused = support::Certified("cPcbbbihq", options).result;
  CHECK_FALSE(refused.proof);
  CHECK(refused.why_not == "it has 1 unknown lengths, and at most 0 are certified");
}

TEST_CASE("digests are those of FIPS 180-4", "[verified]") {
  CHECK(verified::digest("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(verified::digest("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(verified::digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(verified::digest(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}
