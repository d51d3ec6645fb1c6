// SPDX-License-Identifier: GPL-2.0-or-later
// Whitehead's automorphisms: random automorphisms are undone, and formulas agree with what is written out.
#include "support/random.hpp"
#include "tetrarch/algebra/group_text.hpp"
#include "tetrarch/algebra/whitehead.hpp"
#include "tetrarch/core/random.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::algebra;

namespace {

std::size_t letters(const Presentation& group) {
  std::size_t sum = 0;
  for (const Word& relator : group.relators) sum += relator.size();
  return sum;
}

/// Products of generators, by chance.
Renamed scrambled(const Presentation& group, int times, SplitMix64& random) {
  Renamed now = unchanged(group);
  for (int k = 0; k < times; ++k) {
    std::vector<Word> word_of;
    for (int g = 1; g <= group.generators; ++g) word_of.push_back({g});
    const int x = random.below(group.generators);
    const int y = (x + 1 + random.below(group.generators - 1)) % group.generators;
    word_of[static_cast<std::size_t>(x)] = random.below(2) == 0 ? Word{x + 1, y + 1} : Word{-(y + 1), x + 1};
    now = substituted(now, word_of);
  }
  return now;
}

} // namespace

TEST_CASE("Scrambled primitive words become one letter again") {
  // Whitehead 1936: a primitive element is shortened by his automorphisms to a single letter.
  SplitMix64 random(5);
  for (int n = 2; n <= 5; ++n)
    for (int k = 0; k < 20; ++k) {
      Presentation group{n, {{1}}};
      const Renamed long_one = scrambled(group, 25, random);
      CHECK(letters(shortest(long_one.presentation).presentation) == 1);
    }
}

TEST_CASE("Scrambled surface groups become as short as they are") {
  // The relator of a closed surface of genus 2 has Whitehead graph a cycle, so that nothing shortens it.
  SplitMix64 random(7);
  const Presentation surface = parse_presentation("< a, b, c, d | abABcdCD >", "test");
  CHECK(letters(shortest(surface).presentation) == 8);
  for (int k = 0; k < 20; ++k)
    CHECK(letters(shortest(scrambled(surface, 20, random).presentation).presentation) == 8);
}

TEST_CASE("Images tell the automorphism") {
  SplitMix64 random(11);
  const Presentation group = parse_presentation("< a, b, c | abcABcaab, bbCabA >", "test");
  const Renamed given = scrambled(group, 12, random);
  const Renamed found = shortest(given.presentation);
  const Renamed again = substituted(unchanged(given.presentation), found.image);
  CHECK(letters(again.presentation) == letters(found.presentation));
  CHECK(abelianized(again.presentation) == abelianized(group));
  for (const Renamed& other : as_short(found, 50)) {
    CHECK(letters(other.presentation) == letters(found.presentation));
    CHECK(letters(substituted(unchanged(given.presentation), other.image).presentation) ==
          letters(found.presentation));
  }
}

TEST_CASE("A spent budget leaves what is short so far") {
  SplitMix64 random(13);
  const Renamed long_one = scrambled({4, {{1}, {2}}}, 40, random);
  const Presentation& given = long_one.presentation;
  CHECK(letters(shortest(given, {}, 0).presentation) == letters(given));
  std::size_t before = letters(given);
  bool between = false;
  for (long long steps = 100; before > 2; steps *= 2) {
    const Renamed found = shortest(given, {}, steps);
    const std::size_t now = letters(found.presentation);
    CHECK(now <= before);
    CHECK(letters(substituted(unchanged(given), found.image).presentation) == now);
    between = between || (now < letters(given) && now > 2);
    before = now;
    REQUIRE(steps < 1'000'000'000);
  }
  CHECK(between);
}
