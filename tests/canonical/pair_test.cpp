// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/pair.hpp"

#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/names.hpp"
#include "tetrarch/diagram/read.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::canonical;
using moves::FreeWord;

namespace {

std::map<std::string, diagram::Diagram> handlebody_knots(bool hyperbolic_only) {
  std::map<std::string, diagram::Diagram> out;
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/data/handlebody_knots.txt");
  REQUIRE(file);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    std::string name;
    std::string code;
    std::string volume;
    std::getline(fields, name, '|');
    std::getline(fields, code, '|');
    std::getline(fields, volume, '|');
    if (!hyperbolic_only || volume != "-") out.emplace(name, diagram::read_diagram(code, name));
  }
  return out;
}

diagram::PairExterior pair_of(const diagram::Diagram& diagram, std::uint64_t seed = 1) {
  for (;; ++seed) {
    REQUIRE(seed < 20);
    if (auto found = diagram::pair_exterior(diagram, {seed})) return *std::move(found);
  }
}

MarkedCells cells_of(const diagram::Diagram& diagram, std::uint64_t seed = 1) {
  const diagram::PairExterior pair = pair_of(diagram, seed);
  return marked_cells(pair.tri, pair.monodromy);
}

} // namespace

TEST_CASE("words of a correspondence", "[pair]") {
  const auto answer = [](const std::vector<std::pair<FreeWord, FreeWord>>& pairs) {
    Correspondence c;
    for (const auto& [first, second] : pairs) c.add(first, second);
    return c.answer();
  };
  // a b -> x, a -> y: then b -> y^-1 x.
  const auto free = answer({{{1, 2}, {5}}, {{1}, {6}}});
  CHECK(free.exists);
  CHECK(free.generates);
  CHECK(free.images == std::vector<std::pair<int, FreeWord>>{{1, {6}}, {2, {-6, 5}}});
  // The same and a b a -> x y, which follows, or -> y x, which does not.
  CHECK(answer({{{1, 2}, {5}}, {{1}, {6}}, {{1, 2, 1}, {5, 6}}}).exists);
  CHECK_FALSE(answer({{{1, 2}, {5}}, {{1}, {6}}, {{1, 2, 1}, {6, 5}}}).exists);
  CHECK_FALSE(answer({{{}, {5}}}).exists);
  // a^2 and a^3 generate a; x^2 and x^3 fit, x^2 and x^4 do not, and a^2 alone does not generate.
  CHECK(answer({{{1, 1}, {2, 2}}, {{1, 1, 1}, {2, 2, 2}}}).images ==
        std::vector<std::pair<int, FreeWord>>{{1, {2}}});
  CHECK_FALSE(answer({{{1, 1}, {2, 2}}, {{1, 1, 1}, {2, 2, 2, 2}}}).exists);
  CHECK_FALSE(answer({{{1, 1}, {2}}}).generates);
  // Conjugation by a word is an automorphism.
  CHECK(answer({{{1}, {3, 1, -3}}, {{2, 1}, {3, 2, 1, -3}}, {{2, 2}, {3, 2, 2, -3}}, {{2}, {3, 2, -3}}})
            .exists);
}

TEST_CASE("moves carry the words, law by law", "[pair]") {
  for (const auto& [name, diagram] : handlebody_knots(false)) {
    INFO(name);
    const diagram::PairExterior pair = pair_of(diagram);
    CHECK(is_monodromy(pair.tri, Skeleton(pair.tri), pair.monodromy));
    const Triangulation usual = diagram::exterior(diagram);
    SplitMix64 random(7);
    moves::Complex complex(pair.tri);
    moves::Monodromy words = pair.monodromy;
    int made = 0;
    for (int k = 0; k < 60; ++k) {
      const int t = random.below(complex.slot_count());
      if (!complex.is_alive(t)) continue;
      const auto [a, b] = edge_vertex[random.below(6)];
      const std::array<moves::Move, 6> some{{{moves::MoveKind::two_three, t, random.below(4)},
                                             {moves::MoveKind::four_four, t, a, b, random.below(2)},
                                             {moves::MoveKind::three_two, t, a, b},
                                             {moves::MoveKind::two_zero_edge, t, a, b},
                                             {moves::MoveKind::two_one, t, a, b},
                                             {moves::MoveKind::pack}}};
      made += moves::carry(complex, words, some[static_cast<std::size_t>(random.below(6))]);
      const moves::Complex::Compact now = complex.compact();
      const moves::Monodromy compact = compacted(words, now);
      REQUIRE(is_monodromy(now.tri, Skeleton(now.tri), compact));
      // What is oriented stays so, and not the other way round in some part.
      const auto hands = orientation(now.tri).value();
      for (int s = 0; s < now.tri.size(); ++s)
        REQUIRE(compact.hand(s) * compact.hand(0) == hands[static_cast<std::size_t>(s)] * hands[0]);
    }
    CHECK(made > 10);
  }
}

TEST_CASE("every isometry of a hyperbolic knot's exterior extends", "[pair]") {
  // Gordon and Luecke (1989): knots are determined by their complements. The orders are those of the Knot
  // Atlas and of Kodama and Sakuma (1992): 4_1 has D4, 6_3 D4, 7_4 D4, 8_18 D8, 8_20 to 8_21 Z/2 or so.
  const std::map<std::string, int> order{{"4_1", 8}, {"5_2", 4}, {"6_1", 4}, {"6_2", 4},
                                         {"6_3", 8}, {"7_4", 8}, {"7_7", 8}, {"8_18", 16}};
  for (const std::string& name : diagram::diagram_names()) {
    if (name == "9_1") break;
    if (name == "0_1" || name == "3_1" || name == "5_1" || name == "7_1" || name == "8_19") continue; // tori
    INFO(name);
    const MarkedCells cells = cells_of(*diagram::named_diagram(name));
    REQUIRE(cells.why_not.empty());
    const PairIsometries found = pair_isometries(cells, cells);
    CHECK(found.extending.size() == found.all.size());
    if (order.count(name) > 0) CHECK(static_cast<int>(found.all.size()) == order.at(name));
  }
}

TEST_CASE("hyperbolic handlebody-knots to six crossings", "[pair]") {
  // Isometries of the exterior, and how many of them keep the orientation of space. All extend. The exteriors
  // differ, so that no two are equivalent. 6_6 and 6_7 are their own mirror images, the others are not.
  const std::map<std::string, std::pair<int, int>> expected{{"5_3", {6, 6}}, {"6_2", {2, 2}}, {"6_3", {2, 2}},
                                                            {"6_5", {2, 2}}, {"6_6", {2, 1}}, {"6_7", {4, 2}},
                                                            {"6_8", {2, 2}}, {"6_9", {2, 2}}};
  std::map<std::string, MarkedCells> cells;
  std::map<std::string, MarkedCells> mirrors;
  for (const auto& [name, diagram] : handlebody_knots(true)) {
    INFO(name);
    cells[name] = cells_of(diagram, 3);
    mirrors[name] = cells_of(mirrored(diagram));
    REQUIRE(cells[name].why_not.empty());
    REQUIRE(mirrors[name].why_not.empty());
  }
  REQUIRE(cells.size() == expected.size());
  for (const auto& [x, a] : cells) {
    for (const auto& [y, b] : cells) {
      INFO(x << " " << y);
      const PairIsometries found = pair_isometries(a, b);
      CHECK(found.all.size() == (x == y ? static_cast<std::size_t>(expected.at(x).first) : 0));
      CHECK(found.extending.size() == found.all.size());
      if (x == y) CHECK(std::count(found.hands.begin(), found.hands.end(), 1) == expected.at(x).second);
    }
    // To the mirror image as many, of the other hands.
    const PairIsometries mirror = pair_isometries(a, mirrors.at(x));
    CHECK(mirror.extending.size() == static_cast<std::size_t>(expected.at(x).first));
    CHECK(std::count(mirror.hands.begin(), mirror.hands.end(), -1) == expected.at(x).second);
  }
}

TEST_CASE("a full twist along an unknotted component changes the link and not the exterior", "[pair]") {
  // The closure of a braid of three strands together with its axis, which is the fourth strand. A full twist
  // of the three is a homeomorphism of the exterior of the axis. The closures are the unknot, the
  // figure-eight knot, and others: as they differ, no isometry extends.
  const std::string axis = " 3 2 1 1 2 3";
  const std::string twist = " 1 2 1 2 1 2";
  for (const std::string braid : {"1 -2", "1 -2 1 -2", "1 1 -2"}) {
    INFO(braid);
    const MarkedCells plain = cells_of(diagram::read_diagram("braid " + braid + axis, "test"));
    const MarkedCells twisted = cells_of(diagram::read_diagram("braid " + braid + twist + axis, "test"));
    REQUIRE(plain.why_not.empty());
    REQUIRE(twisted.why_not.empty());
    const PairIsometries found = pair_isometries(plain, twisted);
    CHECK(!found.all.empty());
    CHECK(found.extending.empty());
    CHECK(pair_isometries(plain, plain).extending.size() <= found.all.size());
    CHECK(!pair_isometries(twisted, twisted).extending.empty());
  }
}
