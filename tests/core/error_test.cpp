// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <string>

using tetrarch::in_quotes;
using tetrarch::Lines;
using tetrarch::printable;

namespace {

/// So many question marks. (Written out, some are trigraphs.)
std::string marks(std::size_t count) {
  return "'" + std::string(count, '?') + "'";
}

} // namespace

TEST_CASE("what is quoted keeps its letters", "[error]") {
  CHECK(in_quotes("fig8") == "'fig8'");
  // Labels of Regina's own sample file.
  CHECK(in_quotes("Poincar\u00e9 Homology Sphere") == "'Poincar\u00e9 Homology Sphere'");
  CHECK(in_quotes("RP\u00b2 x S\u00b9") == "'RP\u00b2 x S\u00b9'");
  CHECK(in_quotes("\u4e09\U0001D54A") == "'\u4e09\U0001D54A'"); // three bytes, four bytes
}

TEST_CASE("what is no letter is a question mark", "[error]") {
  CHECK(in_quotes("a\nb\x1b[2J") == "'a?b?[2J'");
  CHECK(in_quotes("\x7f") == "'?'");
  CHECK(in_quotes("\xc2\x9b") == marks(2));             // U+009B begins escape sequences as ESC [ does
  CHECK(in_quotes("caf\xe9") == "'caf?'");              // Latin-1
  CHECK(in_quotes("\xc3") == "'?'");                    // cut off
  CHECK(in_quotes("\xc0\xaf\xe0\x80\xaf") == marks(5)); // overlong spellings of "/"
  CHECK(in_quotes("\xed\xa0\x80") == marks(3));         // half of a surrogate pair
  CHECK(in_quotes("\xf4\x90\x80\x80") == marks(4));     // beyond U+10FFFF
}

TEST_CASE("what is quoted is cut after forty letters, not inside of one", "[error]") {
  std::string forty;
  for (int k = 0; k < 40; ++k) forty += "\u00e9";
  CHECK(in_quotes(forty) == "'" + forty + "'");
  CHECK(in_quotes(forty + "x") == "'" + forty + "...'");
  std::string wide;
  for (int k = 0; k < 40; ++k) wide += "\u4e09";
  CHECK(in_quotes(wide) == "'" + wide.substr(0, 27 * 3) + "...'"); // eighty bytes are enough
}

TEST_CASE("a text for a terminal keeps its letters and loses its commands", "[error]") {
  CHECK(printable("W\u00fcrfel, RP\u00b2 x S\u00b9, \u4e09") == "W\u00fcrfel, RP\u00b2 x S\u00b9, \u4e09");
  CHECK(printable("a\nb\tc\x1b[2J\r\x7f\xc2\x9b") == "a?b?c?[2J????");
  CHECK(printable("a\nb\tc\x1b[2J\r\x7f\xc2\x9b", Lines::many) == "a\nb\tc?[2J????");
  CHECK(printable("caf\xe9") == "caf?"); // Latin-1
  CHECK(printable("").empty());
}
