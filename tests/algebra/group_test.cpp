// SPDX-License-Identifier: GPL-2.0-or-later
#include "naive_algebra.hpp"

#include "support/enumeration.hpp"
#include "support/laws.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <ctime>
#include <functional>

using namespace tetrarch;
using namespace tetrarch::algebra;
using namespace tetrarch::support;
using Catch::Matchers::Contains;

namespace {

Presentation group_of(const Triangulation& tri) {
  return dual_presentation(tri, Skeleton(tri)).presentation;
}

Presentation random_presentation(Random& random, int generators, int relators, int length) {
  Presentation p{generators, {}};
  for (int r = 0; r < relators; ++r) {
    Word word;
    for (int k = 1 + random.below(length); k > 0; --k) {
      const int letter = 1 + random.below(generators);
      word.push_back(random.below(2) == 0 ? letter : -letter);
    }
    p.relators.push_back(word);
  }
  return p;
}

/// What `simplified` promises of the shape of its result.
bool is_tidy(const Presentation& p) {
  for (std::size_t r = 0; r < p.relators.size(); ++r) {
    if (p.relators[r].empty() || cyclically_reduced(p.relators[r]) != p.relators[r]) return false;
    if (r > 0 && p.relators[r - 1].size() > p.relators[r].size()) return false;
    if (r > 0 && p.relators[r - 1] == p.relators[r]) return false;
  }
  return true;
}

/// A punctured torus bundle: a ring of tetrahedra, each laid over two triangles of the torus below so that
/// one of two edges is covered (Floyd and Hatcher, 1982). The letters say which.
Triangulation torus_bundle(int size, const std::string& letters) {
  Triangulation tri(size);
  for (int t = 0; t < size; ++t) {
    const int next = (t + 1) % size;
    const bool first = letters[static_cast<std::size_t>(next) % letters.size()] == 'A';
    tri.glue({next, 3}, t, first ? Perm4(0, 3, 1, 2) : Perm4(0, 1, 3, 2));
    tri.glue({next, 1}, t, first ? Perm4(3, 0, 2, 1) : Perm4(1, 0, 2, 3));
  }
  return tri;
}

} // namespace

TEST_CASE("presentations as text", "[group]") {
  CHECK(Presentation{0, {}}.str() == "< | >");
  CHECK(Presentation{1, {}}.str() == "< a | >");
  CHECK(Presentation{2, {{1, 2, -1, -2}}}.str() == "< a, b | abAB >");
  CHECK(Presentation{2, {{1, 1}, {}, {-2}}}.str() == "< a, b | aa, 1, B >");
  CHECK(word_str({26, -26}, 26) == "zZ");
  CHECK(word_str({27, -1, 10}, 27) == "g27G1g10");
  CHECK(Presentation{27, {}}.str().substr(0, 16) == "< g1, g2, g3, g4");
}

TEST_CASE("free and cyclic reduction", "[group]") {
  CHECK(freely_reduced({1, 2, -2, 3, -3, -1, 4}) == Word{4});
  CHECK(freely_reduced({1, 2, -1}) == Word{1, 2, -1});
  CHECK(cyclically_reduced({1, 2, -1}) == Word{2});
  CHECK(cyclically_reduced({1, 1, -1}) == Word{1});
  CHECK(cyclically_reduced({1, 2, -2, -1}).empty());
  CHECK(cyclically_reduced({}).empty());
}

TEST_CASE("a dual presentation counts faces and edges", "[group]") {
  for (const ZooEntry& entry : zoo()) {
    const Triangulation tri = entry.triangulation();
    const Skeleton s(tri);
    const DualPresentation dual = dual_presentation(tri, s);
    INFO(entry.name);
    // A spanning tree of T nodes has T - 1 arcs.
    CHECK(dual.presentation.generators == s.face_count() - s.boundary_face_count() - tri.size() + 1);
    CHECK(static_cast<int>(dual.generator_face.size()) == dual.presentation.generators);
    CHECK(dual.relator_edge.size() == dual.presentation.relators.size());
    for (const TetFace f : dual.generator_face) CHECK(s.preimages(s.face(f))[0] == f);
    for (std::size_t r = 0; r < dual.relator_edge.size(); ++r)
      CHECK(static_cast<int>(dual.presentation.relators[r].size()) <= s.valence(dual.relator_edge[r]));
  }
}

TEST_CASE("groups of well-known manifolds come out in their usual form", "[group]") {
  const auto text = [](const std::string& name) {
    return simplified(group_of(zoo(name).triangulation())).str();
  };
  CHECK(text("S^3, Bing's house") == "< | >");
  CHECK(text("S^2 x S^1") == "< a | >");
  CHECK(text("L(7,2)") == "< a | aaaaaaa >");
  CHECK(text("RP^3 # RP^3") == "< a, b | aa, bb >");
  CHECK(text("3-torus") == "< a, b, c | abAB, acAC, bcBC >");
  CHECK(text("genus 2 handlebody") == "< a, b | >");
  CHECK(text("trefoil complement") == "< a, b | abaBAB >"); // the braid relation
}

TEST_CASE("group order by hand: homomorphisms into S_3 and S_4", "[group]") {
  // A homomorphism from Z/8 is an element of order dividing 8: in S_3 the identity and three transpositions,
  // in S_4 the identity, 6 + 3 involutions and 6 four-cycles. One from Z^3 is a commuting triple: for each
  // element of S_3 the commuting pairs in its centraliser, 18 for the identity, 4 for each of three
  // transpositions, 9 for each of two 3-cycles, which makes 48.
  const Presentation lens = simplified(group_of(zoo("L(8,3)").triangulation()));
  CHECK(naive::representations(lens, 3).all == 4);
  CHECK(naive::representations(lens, 4).all == 16);
  CHECK(naive::representations(simplified(group_of(zoo("3-torus").triangulation())), 3).all == 48);
}

TEST_CASE("simplifying keeps the group", "[group]") {
  // Equal abelianisations and equal numbers of homomorphisms into S_3: two invariants, computed on the
  // presentation as read and as simplified.
  const auto compare = [](const Presentation& before, const TietzeOptions& options) {
    const Presentation after = simplified(before, options);
    CHECK(is_tidy(after));
    CHECK(after.generators <= before.generators);
    CHECK(abelianized(after) == abelianized(before));
    if (before.generators <= 5)
      CHECK(naive::representations(after, 3).all == naive::representations(before, 3).all);
  };
  TietzeOptions starved;
  starved.max_letters = 30;
  TietzeOptions generous;
  generous.max_growth = 10;
  for (const ZooEntry& entry : zoo()) {
    const Presentation p = group_of(entry.triangulation());
    INFO(entry.name);
    for (const TietzeOptions& options : {TietzeOptions(), starved, generous}) compare(p, options);
  }
  Random random(21);
  for (int round = 0; round < 600; ++round) {
    const int generators = 1 + random.below(4);
    const Presentation p = random_presentation(random, generators, random.below(5), 12);
    INFO(p.str());
    for (const TietzeOptions& options : {TietzeOptions(), starved, generous}) compare(p, options);
  }
  for (int round = 0; round < 100; ++round) {
    const int generators = 5 + random.below(40);
    const Presentation p = random_presentation(random, generators, 3 + random.below(60), 6);
    INFO(p.str());
    for (const TietzeOptions& options : {TietzeOptions(), starved, generous}) compare(p, options);
  }
}

TEST_CASE("simplifying keeps the groups of two tetrahedra", "[group]") {
  long at = 0;
  for_each_gluing(2, [&](const Triangulation& tri) {
    if (at++ % 13 != 0) return;
    const Skeleton s(tri);
    if (!is_valid(s) || !s.is_connected()) return;
    const Presentation before = dual_presentation(tri, s).presentation;
    const Presentation after = simplified(before);
    if (!is_tidy(after) || naive::representations(after, 3).all != naive::representations(before, 3).all)
      FAIL(before.str() + " became " + after.str() + " in " + gluing_text(tri));
  });
}

TEST_CASE("short relators are solved exactly", "[group]") {
  // By hand: a = b, b = C, c = d^-1 with d free; e = 1; the rest says d^4 = 1.
  CHECK(simplified({5, {{1, -2}, {2, 3}, {3, 4}, {5}, {1, 2, -3, 5, 4}}}).str() == "< a | aaaa >");
  // By hand: a = a^-1 is no reason to drop a.
  CHECK(simplified({1, {{1, 1}}}).str() == "< a | aa >");
  // By hand: gcd(4, 6) = 2.
  CHECK(simplified({1, {{1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}}}).str() == "< a | aa >");
  // By hand: the same relator, turned and inverted.
  CHECK(simplified({2, {{1, 2, -1, -2}, {2, -1, -2, 1}, {2, 1, -2, -1}}}).str() == "< a, b | abAB >");
}

TEST_CASE("a part of a relator is found where its rarest generator is not", "[group]") {
  // By hand: b c^2 d^2 = (a^2 b)^-1 by the first relator, so the second one says (a^2 b)^2 = 1. Generator a
  // occurs in the first relator alone.
  CHECK(simplified({4, {{1, 1, 2, 2, 3, 3, 4, 4}, {2, 3, 3, 4, 4, 2, 3, 3, 4, 4}}}).str() ==
        "< a, b, c, d | aabaab, aabbccdd >");
}

TEST_CASE("killing chains are linear", "[group]") {
  // g1 = 1, g1 g2 = 1, ..., and one relator with all letters: nothing is left. A quadratic method would look
  // at 10^10 letters.
  const int n = 200000;
  Presentation p{n, {{1}}};
  Word everything;
  for (int g = 1; g <= n; ++g) {
    if (g > 1) p.relators.push_back({g - 1, g});
    everything.push_back(g);
  }
  p.relators.push_back(everything);
  CHECK(simplified(p) == Presentation{});
}

TEST_CASE("the generators that are left are among those given, and generate", "[group]") {
  for (const ZooEntry& entry : zoo()) {
    INFO(entry.name);
    const Presentation before = group_of(entry.triangulation());
    const Kept kept = simplified_keeping(before);
    CHECK(kept.presentation == simplified(before));
    REQUIRE(static_cast<int>(kept.generator.size()) == kept.presentation.generators);
    CHECK(std::is_sorted(kept.generator.begin(), kept.generator.end(), std::less_equal<>()));
    // Where they are 1, everything is.
    Presentation killed = before;
    for (const int g : kept.generator) killed.relators.push_back({g + 1});
    CHECK(simplified(killed) == Presentation{});
    // Their relators hold in the group given: as further relators they leave it as it is. (The order of the
    // abelianised group and the homomorphisms into S_3 would become fewer.)
    Presentation more = before;
    for (const Word& relator : kept.presentation.relators) {
      Word word;
      for (const int letter : relator)
        word.push_back(letter > 0 ? kept.generator[letter - 1] + 1 : -kept.generator[-letter - 1] - 1);
      more.relators.push_back(word);
    }
    CHECK(abelianized(more) == abelianized(before));
    const Presentation least = simplified(more);
    if (least.generators <= 4)
      CHECK(naive::representations(least, 3).all == naive::representations(kept.presentation, 3).all);
  }
}

TEST_CASE("groups with thousands of relators in chains take no time", "[group]") {
  // By hand: the edges (A, B) of the torus become (A, B - A) and then (B - A, 2A - B), so that twelve
  // tetrahedra make the sixth power of M = (-1 2, 1 -1). H1 is Z and the cokernel of M^6 - 1, which is
  // (98 -140, -70 98): the common divisor of the entries is 14, the determinant -196.
  const Presentation small = simplified(group_of(torus_bundle(12, "AB")));
  CHECK(abelianized(small).str() == "Z + Z/14 + Z/14");
  // Every elimination looked at every relator: 27 seconds for this one.
  const std::clock_t start = std::clock();
  const Presentation large = simplified(group_of(torus_bundle(8000, "AB")));
  CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 5);
  CHECK(large.generators < 2500);
  CHECK(static_cast<int>(large.relators.size()) == large.generators - 1);
}

TEST_CASE("groups of large triangulations", "[group]") {
  CHECK(simplified(group_of(cubical_ball(12, 12, 12))) == Presentation{});
  const Presentation torus = simplified(group_of(cubical_torus(12, 12, 12)));
  // Z^3: three generators that commute, and nothing else in the abelianised group. Which redundant relators
  // stay depends on the labelling.
  CHECK(torus.generators == 3);
  CHECK(abelianized(torus) == AbelianGroup(3));
  REQUIRE(torus.relators.size() >= 3);
  CHECK(Presentation{3, {torus.relators.begin(), torus.relators.begin() + 3}}.str() ==
        "< a, b, c | abAB, acAC, bcBC >");
}

TEST_CASE("presentations refuse what they cannot mean", "[group]") {
  const Triangulation two = from_signature("baabaa");
  CHECK_THROWS_WITH(dual_presentation(two, Skeleton(two)), Contains("2 components"));
  const Triangulation none;
  CHECK_THROWS_WITH(dual_presentation(none, Skeleton(none)), Contains("0 components"));
  const Triangulation reversed = from_signature("bkaagd"); // Regina calls it invalid
  CHECK_THROWS_WITH(dual_presentation(reversed, Skeleton(reversed)),
                    Contains("identified with itself reversed"));
  CHECK_THROWS_WITH(simplified({1, {{1, 2}}}), Contains("letter 2 of relator 0"));
  CHECK_THROWS_AS(abelianized({1, {{0}}}), PreconditionError);
}

TEST_CASE("simplifying can be stopped", "[group]") {
  std::stop_source source;
  source.request_stop();
  const Presentation p = group_of(zoo("Weber-Seifert space").triangulation());
  CHECK_THROWS_AS(simplified(p, {}, Progress({}, source.get_token())), Stopped);
}
