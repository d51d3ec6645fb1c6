// SPDX-License-Identifier: GPL-2.0-or-later
/// Closures of braids.
#include "readers.hpp"

#include <algorithm>
#include <cstdlib>

namespace tetrarch::diagram {
namespace {

/// The letters, and the number of strands if the code says it (else 0).
struct Braid {
  int strands = 0;
  std::vector<int> letters;
};

/// Numbers in brackets or without any; or letters: a is generator 1, A its inverse.
std::vector<int> read_letters(CodeText& text) {
  std::vector<int> letters;
  const char c = text.next();
  const char end = c == '[' || c == '(' || c == '{' ? text.open("a list") : '\0';
  while (!text.at_end() && text.next() != end) {
    const int letter = text.integer("a generator of the braid group, a number other than 0");
    if (letter == 0) text.fail("a generator of the braid group is 0 (expected 1, 2, ... or -1, -2, ...)");
    letters.push_back(letter);
    text.skip(",;");
  }
  if (end != '\0') text.close(end);
  return letters;
}

/// "[3, {1, -2}]" or the letters alone.
Braid read_word(CodeText& text) {
  CodeText ahead = text;
  if (ahead.take('[') || ahead.take('(')) {
    const char end = text.next() == '[' ? ']' : ')';
    if (ahead.at_integer()) {
      const int strands = ahead.integer("the number of strands");
      ahead.take(',');
      if (ahead.next() == '{' || ahead.next() == '[' || ahead.next() == '(') {
        Braid braid{strands, read_letters(ahead)};
        ahead.close(end);
        text = ahead;
        return braid;
      }
    }
  }
  return {0, read_letters(text)};
}

} // namespace

Draft read_braid(CodeText& text) {
  Braid braid = read_word(text);
  if (!text.at_end()) text.fail_expected("the end");
  int strands = 1;
  for (const int letter : braid.letters) strands = std::max(strands, std::abs(letter) + 1);
  if (braid.strands != 0 && braid.strands < strands)
    text.fail("the braid has " + std::to_string(braid.strands) + " strands, and a generator needs " +
              std::to_string(strands));
  strands = std::max(strands, braid.strands);
  constexpr int most_strands = 100'000;
  if (strands > most_strands)
    text.fail("the braid has " + std::to_string(strands) + " strands (expected at most " +
              std::to_string(most_strands) + ")");
  return closed_braid(braid.letters, strands);
}

Draft closed_braid(const std::vector<int>& letters, int strands) {
  for (const int letter : letters) strands = std::max(strands, std::abs(letter) + 1);
  // Strands run upwards; each begins at a point of valence 2, so that a strand without letters is a circle.
  Draft draft;
  std::vector<int> end;
  std::vector<int> start;
  for (int s = 0; s < strands; ++s) {
    const int first = draft.add_node(2, false, 0);
    start.push_back(first);
    end.push_back(first + 1);
  }
  for (const int letter : letters) {
    const int s = std::abs(letter) - 1;
    // Darts to the southwest, southeast, northeast, northwest; a positive letter takes the strand from the
    // southwest over the other.
    const int southwest = draft.add_node(4, true, letter > 0 ? 0 : 1);
    draft.join(end[s], southwest);
    draft.join(end[s + 1], southwest + 1);
    end[s] = southwest + 3;
    end[s + 1] = southwest + 2;
  }
  for (int s = 0; s < strands; ++s) draft.join(end[s], start[s]);
  return draft;
}

} // namespace tetrarch::diagram
