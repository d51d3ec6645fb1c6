// SPDX-License-Identifier: GPL-2.0-or-later
/// Every disk with up to 8 triangles and every boundary assignment: brute force, the dual graph and the
/// dissertation's algorithms agree on what is possible, and every pattern is one.
#include "tetrarch/bundle/cut.hpp"
#include "tetrarch/bundle/direct.hpp"

#include "bundle/disks.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

/// Boundary value k is +1 where bit k is set.
BoundaryValues values_of(unsigned bits, std::size_t count) {
  BoundaryValues values;
  for (std::size_t k = 0; k < count; ++k) values.push_back((bits >> k & 1U) != 0 ? 1 : -1);
  return values;
}

unsigned bits_of(const BoundaryValues& values) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < values.size(); ++k) bits |= values[k] > 0 ? 1U << k : 0U;
  return bits;
}

/// Tries both values on side k, if it is open, and all later ones; counts the patterns of each boundary
/// assignment.
void count_patterns(const Disk& disk, CuttingPattern& pattern, int k, std::vector<long>& patterns) {
  if (k % 3 == 0 && k > 0) {
    const int sum = pattern[Side(k - 1)] + pattern[Side(k - 2)] + pattern[Side(k - 3)];
    if (sum == 3 || sum == -3) return;
  }
  if (k == 3 * disk.triangle_count()) {
    ++patterns[bits_of(boundary_of(disk, pattern))];
    return;
  }
  const Side s(k);
  if (!disk.is_boundary(s) && disk.mate(s).value < k) {
    count_patterns(disk, pattern, k + 1, patterns);
    return;
  }
  for (const int value : {1, -1}) {
    pattern.set(disk, s, value);
    count_patterns(disk, pattern, k + 1, patterns);
  }
}

std::vector<long> brute_force(const Disk& disk) {
  std::vector<long> patterns(std::size_t{1} << disk.boundary().size(), 0);
  CuttingPattern pattern(disk);
  count_patterns(disk, pattern, 0, patterns);
  return patterns;
}

/// Why a result is wrong; empty if it is right.
std::string mistake(const Disk& disk, const BoundaryValues& boundary, const CuttingResult& result,
                    bool possible) {
  if (const auto* pattern = std::get_if<CuttingPattern>(&result)) {
    if (boundary_of(disk, *pattern) != boundary) return "the boundary was changed";
    return why_not_valid(disk, *pattern);
  }
  if (possible) return "an obstruction where there is a pattern";
  const auto& obstruction = std::get<Obstruction>(result);
  if (static_cast<int>(obstruction.triangles.size()) != disk.triangle_count()) return "not the whole disk";
  return obstruction.forbidding == boundary.front() ? "" : "the wrong forbidding value";
}

/// Algorithm I throws if and only if the boundary is not restricted, by the words of Definition 5.1.3.
bool is_restricted(const Disk& disk, const CuttingPattern& pattern) {
  for (int t = 0; t < disk.triangle_count(); ++t) {
    std::vector<int> values;
    for (const Side s : sides_of(t))
      if (disk.is_boundary(s)) values.push_back(pattern[s]);
    if (values.size() >= 2 &&
        std::count(values.begin(), values.end(), values[0]) == static_cast<long>(values.size()))
      return false;
  }
  return true;
}

struct Count {
  long disks = 0;
  long assignments = 0;
  std::string mistake;
};

std::string mistake_on(const Disk& disk, const BoundaryValues& boundary, bool possible) {
  std::string broken;
  const Watch audit = [&](const Round& round) {
    if (broken.empty()) broken = broken_invariant(round);
  };
  std::string found = mistake(disk, boundary, cut_by_dual_graph(disk, boundary), possible);
  if (!found.empty()) return "dual graph: " + found;
  found = mistake(disk, boundary, cut_general(disk, boundary, audit), possible);
  if (!found.empty() || !broken.empty()) return "algorithm II: " + found + broken;
  try {
    found = mistake(disk, boundary, cut_restricted(disk, boundary, audit), possible);
    if (!is_restricted(disk, with_boundary(disk, boundary))) found = "not restricted, but taken";
  } catch (const PreconditionError&) {
    if (is_restricted(disk, with_boundary(disk, boundary))) found = "restricted, but refused";
  }
  return found.empty() && broken.empty() ? "" : "algorithm I: " + found + broken;
}

Count compare(int most) {
  Count count;
  for (const Disk& disk : small_disks(most)) {
    ++count.disks;
    const std::vector<long> patterns = brute_force(disk);
    for (unsigned bits = 0; bits < patterns.size() && count.mistake.empty(); ++bits) {
      ++count.assignments;
      count.mistake = mistake_on(disk, values_of(bits, disk.boundary().size()), patterns[bits] > 0);
    }
    if (count.mistake.empty()) count.mistake = why_not_valid(disk, cut_free(disk));
  }
  return count;
}

} // namespace

TEST_CASE("All disks with up to 6 triangles, all assignments", "[bundle]") {
  CHECK(compare(6).mistake == "");
}

TEST_CASE("All disks with up to 8 triangles, all assignments", "[bundle][slow]") {
  const Count count = compare(8);
  CHECK(count.mistake == "");
  // Counted by another program: disks.hpp.
  CHECK(count.disks == disks_up_to_8);
  CHECK(count.assignments == assignments_up_to_8);
}

TEST_CASE("Any order of the vertices gives a pattern", "[bundle]") {
  Random random(2);
  const Disk disk = random_disk({6, 5, 12, 20, true}, random);
  std::vector<int> rank(static_cast<std::size_t>(disk.vertex_count()));
  std::iota(rank.begin(), rank.end(), 0);
  for (int round = 0; round < 20; ++round) {
    random.shuffle(rank);
    CHECK(why_not_valid(disk, cut_by_order(disk, rank)) == "");
  }
  rank[disk.corners(0)[0]] = rank[disk.corners(0)[1]];
  CHECK_THROWS_AS(cut_by_order(disk, rank), PreconditionError);
}

TEST_CASE("Boundary values are one +1 or -1 for each boundary edge", "[bundle]") {
  const Disk square(4, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_AS(cut_general(square, {1, 1, -1}), PreconditionError);
  CHECK_THROWS_AS(cut_general(square, {1, 1, 0, -1}), PreconditionError);
  CHECK_THROWS_AS(cut_restricted(square, {1, 1, 1, -1}), PreconditionError);
}

TEST_CASE("What is wrong with a pattern is told", "[bundle]") {
  const Disk square(4, {{0, 1, 2}, {0, 2, 3}});
  CuttingPattern pattern = cut_free(square);
  CHECK(why_not_valid(square, pattern) == "");
  pattern.set(square, Side(1, 0), pattern[Side(1, 2)]);
  pattern.set(square, Side(1, 1), pattern[Side(1, 2)]);
  CHECK(why_not_valid(square, pattern) == "triangle 1: the three sides have equal values");
  CHECK(why_not_valid(square, CuttingPattern(square)) == "triangle 0: side 0 is open");
}
