// SPDX-License-Identifier: GPL-2.0-or-later
/// Random disks: deep ones, and trees of strips on which few boundary values relieve everything.
#include "bundle/disks.hpp"
#include "tetrarch/bundle/cut.hpp"
#include "tetrarch/bundle/direct.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

/// What was met while Algorithm II ran under audit.
struct Met {
  std::string mistake;
  int rounds = 0;
  int obstructions = 0;
  int without_values = 0; ///< extremely dangerous pieces without forbidding value
};

void run(const Disk& disk, const BoundaryValues& boundary, Met& met) {
  const Watch watch = [&](const Round& round) {
    if (met.mistake.empty()) met.mistake = broken_invariant(round);
    met.rounds = std::max(met.rounds, round.number);
    if (round.stage != Round::Stage::begun) return;
    for (const Piece& piece : round.partition.pieces())
      if (classify(round.partition, round.pattern, piece) == Assignment{Danger::extreme, 0})
        ++met.without_values;
  };
  const CuttingResult result = cut_general(disk, boundary, watch);
  const CuttingResult direct = cut_by_dual_graph(disk, boundary);
  if (result.index() != direct.index()) met.mistake = "the routes do not agree";
  for (const CuttingResult& one : {result, direct}) {
    const auto* pattern = std::get_if<CuttingPattern>(&one);
    if (pattern == nullptr || !met.mistake.empty()) continue;
    met.mistake = why_not_valid(disk, *pattern);
    if (boundary_of(disk, *pattern) != boundary) met.mistake = "the boundary was changed";
  }
  if (const auto* obstruction = std::get_if<Obstruction>(&result)) {
    ++met.obstructions;
    const auto& expected = std::get<Obstruction>(direct);
    if (obstruction->triangles != expected.triangles || obstruction->forbidding != expected.forbidding)
      met.mistake = "another obstruction";
  }
}

/// Algorithm I, with random values where a triangle has one boundary edge.
void run_restricted(const Disk& disk, Random& random, Met& met) {
  BoundaryValues boundary = restricted_boundary(disk);
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const Side s = disk.boundary()[k];
    if (!disk.is_boundary(s.next()) && !disk.is_boundary(s.previous()) && random.below(2) == 0)
      boundary[k] *= -1;
  }
  const CuttingPattern pattern = cut_restricted(disk, boundary, [&](const Round& round) {
    if (met.mistake.empty()) met.mistake = broken_invariant(round);
  });
  if (met.mistake.empty()) met.mistake = why_not_valid(disk, pattern);
  if (boundary_of(disk, pattern) != boundary) met.mistake = "the boundary was changed";
}

} // namespace

TEST_CASE("Deep disks with random boundaries", "[bundle]") {
  Random random(4);
  Met met;
  for (int k = 0; k < 40; ++k) {
    const Disk disk = random_disk({8 + random.below(12), 8 + random.below(12), 40, 80, true}, random);
    run(disk, random_boundary(disk, random), met);
    run(disk, BoundaryValues(disk.boundary().size(), 1), met);
    run_restricted(disk, random, met);
  }
  CHECK(met.mistake == "");
  CHECK(met.rounds >= 4); // an aggregated piece of three layers, and what is within
  CHECK(met.obstructions == 0);
}

TEST_CASE("Trees of triangles with few boundary values of one sign", "[bundle]") {
  Random random(5);
  Met met;
  for (int k = 0; k < 3000; ++k) {
    const Disk disk = random_disk({1, 1, 0, random.below(60), true}, random);
    BoundaryValues boundary(disk.boundary().size(), k % 2 == 0 ? 1 : -1);
    run(disk, boundary, met);
    for (int flips = 1 + random.below(2); flips > 0; --flips)
      boundary[random.below(static_cast<int>(boundary.size()))] *= -1;
    run(disk, boundary, met);
  }
  CHECK(met.mistake == "");
  CHECK(met.rounds == 1);
  CHECK(met.obstructions >= 3000);
  CHECK(met.without_values > 100);
}

TEST_CASE("Small aggregated pieces among many branches", "[bundle]") {
  Random random(6);
  Met met;
  for (int k = 0; k < 500; ++k) {
    const Disk disk = random_disk({2, 2, random.below(3), random.below(80), true}, random);
    run(disk, BoundaryValues(disk.boundary().size(), 1), met);
    run(disk, random_boundary(disk, random), met);
  }
  CHECK(met.mistake == "");
}

TEST_CASE("A piece without boundary values is relieved by two neighbours of opposite values", "[bundle]") {
  // By hand: strips of three triangles stand on the sides of the triangle 0 1 2, each with its middle one,
  // and it comes last, so that the strips are joined before it could be; it is left over as a singular piece.
  const Disk disk(12, {{1, 0, 3},
                       {3, 0, 4},
                       {1, 3, 5},
                       {2, 1, 6},
                       {6, 1, 7},
                       {2, 6, 8},
                       {0, 2, 9},
                       {9, 2, 10},
                       {0, 9, 11},
                       {0, 1, 2}});
  for (unsigned signs = 0; signs < 8; ++signs) {
    BoundaryValues boundary;
    for (const Side s : disk.boundary()) boundary.push_back((signs >> (s.triangle() / 3) & 1U) != 0 ? 1 : -1);
    const CuttingResult result = cut_general(disk, boundary);
    INFO("signs " << signs);
    REQUIRE(std::holds_alternative<Obstruction>(result) == (signs == 0 || signs == 7));
    if (const auto* pattern = std::get_if<CuttingPattern>(&result))
      CHECK(why_not_valid(disk, *pattern) == "");
  }
}

TEST_CASE("A fan of 200,000 triangles about one vertex, and a strip as long", "[bundle]") {
  const int n = 200000;
  std::vector<Disk::Triangle> fan;
  std::vector<Disk::Triangle> strip;
  for (int k = 0; k < n; ++k) {
    fan.push_back({0, k + 1, (k + 1) % n + 1});
    if (k % 2 == 0)
      strip.push_back({k, k + 1, k + 2});
    else
      strip.push_back({k + 1, k, k + 2});
  }
  for (const Disk& disk : {Disk(n + 1, fan), Disk(n + 2, strip)}) {
    BoundaryValues boundary(disk.boundary().size(), 1);
    boundary.back() = -1;
    const CuttingResult result = cut_general(disk, boundary);
    REQUIRE(std::holds_alternative<CuttingPattern>(result));
    CHECK(why_not_valid(disk, std::get<CuttingPattern>(result)) == "");
    CHECK(why_not_valid(disk, cut_free(disk)) == "");
  }
}

TEST_CASE("The audit names the invariant that is broken", "[bundle]") {
  Random random(8);
  const Disk disk = random_disk({4, 4, 0, 3, false}, random);
  const CuttingPattern open(disk);
  std::vector<std::string> found;
  const CuttingPattern pattern = cut_free(disk, [&](const Round& round) {
    if (round.number == 1)
      found.push_back(broken_invariant({1, round.stage, false, round.mesh, round.partition, open}));
  });
  REQUIRE(found.size() == 3);
  CHECK(found[0] == "safeness: the unsolved mesh of round 1 is not safe");
  CHECK(found[1].rfind("safeness: ", 0) == 0);
  CHECK(found[2].rfind("completeness: ", 0) == 0);
}
