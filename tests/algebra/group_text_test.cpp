// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/group_text.hpp"

#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

using namespace tetrarch;
using namespace tetrarch::algebra;

namespace {

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_presentation(text, "group.txt"));
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

} // namespace

TEST_CASE("a presentation is read as people write it", "[group_text]") {
  // By hand: a is 1, b is 2, inverses are negative.
  const Presentation torus{2, {{1, 2, -1, -2}}};
  CHECK(parse_presentation("< a, b | abAB >", "") == torus);
  CHECK(parse_presentation("<a,b|a*b*a^-1*b^-1>", "") == torus);
  CHECK(parse_presentation("\n< x1,\n  y |\n x1 y X1 Y >\n", "") == torus);
  CHECK(parse_presentation("< g2, g1 | g2g1G2G1 >", "") == torus);
  CHECK(parse_presentation("< a | a^3, A^-2, a^0, 1 >", "") == Presentation{1, {{1, 1, 1}, {1, 1}, {}, {}}});
  CHECK(parse_presentation("< | >", "") == Presentation{});
  // The trefoil, and the quaternion group with its three equal squares.
  CHECK(parse_presentation("< a, b | a^2 = b^3 >", "") == Presentation{2, {{1, 1, -2, -2, -2}}});
  CHECK(parse_presentation("< i, j | i^2 = j^2 = ijIJ, i^4 = 1 >", "") ==
        Presentation{2, {{1, 1, -2, -2}, {1, 1, 2, 1, -2, -1}, {1, 1, 1, 1}}});
  CHECK(parse_presentation("< a | >", "") == Presentation{1, {}});
}

TEST_CASE("what is written is read back, also with more than 26 generators", "[group_text]") {
  std::mt19937 random(8);
  for (const int generators : {1, 2, 25, 26, 27, 130}) {
    Presentation group{generators, {}};
    for (int r = 0; r < 20; ++r) {
      Word& word = group.relators.emplace_back();
      for (unsigned k = random() % 12; k > 0; --k) {
        const int letter = 1 + static_cast<int>(random() % static_cast<unsigned>(generators));
        word.push_back(random() % 2 == 0 ? letter : -letter);
      }
    }
    CHECK(parse_presentation(group.str(), "") == group);
  }
}

TEST_CASE("what is no presentation is refused with its place", "[group_text]") {
  CHECK(complaint("") == "group.txt:1: the text ends, expected '<'");
  CHECK(complaint("< a, b\n| abc >") ==
        "group.txt:2: found 'c', expected a generator that is listed before the bar");
  CHECK(complaint("< a, a | >") == "group.txt:1: found 'a', expected a generator that is not listed yet");
  CHECK(complaint("< A | >") ==
        "group.txt:1: found 'A', expected a generator (a lower-case letter, perhaps with digits)");
  CHECK(complaint("< a | a,, >") == "group.txt:1: found ',', expected a word");
  CHECK(complaint("< a | a^b >") == "group.txt:1: found 'b', expected an exponent");
  CHECK(complaint("< a | a* >") == "group.txt:1: found '>', expected a letter after '*'");
  CHECK(complaint("< a | a = >") == "group.txt:1: found '>', expected a word");
  CHECK(complaint("< a | = a >") == "group.txt:1: found '=', expected a word");
  CHECK(complaint("< a | a") == "group.txt:1: the text ends, expected '>'");
  CHECK(complaint("< a | a > x") == "group.txt:1: found 'x', expected the end of the presentation");
  CHECK(complaint("< a | a^1000001 >") ==
        "group.txt:1: found '>', expected no word of more than a million letters");
  CHECK(complaint("< a | a^-2147483648 >") ==
        "group.txt:1: found '>', expected no word of more than a million letters");
  CHECK(complaint("< a | a^99999999999999999999 >") == "group.txt:1: found '9', expected an exponent");
}

TEST_CASE("no beginning of a presentation is taken for one", "[group_text]") {
  const std::string text = "< a, b2 | a^12*B2, 1, aab2 >";
  for (std::size_t n = 0; n < text.size(); ++n) CHECK(complaint(text.substr(0, n)) != "none");
}
