// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Finite presentations of groups.
///
/// Letters are non-zero integers: generator g is the letter g+1, its inverse -(g+1). A word reads from left
/// to right: first the first letter's loop, then the next one's.

#include <string>
#include <vector>

namespace tetrarch::algebra {

using Word = std::vector<int>;

/// Generators and relators; for the letters of a word see above.
struct Presentation {
  int generators = 0;
  std::vector<Word> relators;

  /// For instance "< a, b | abAB >", "< a | >", "< | >": up to 26 generators are called a to z and their
  /// inverses A to Z. Of more, all are called g1, g2, ... and their inverses G1, G2, ....
  std::string str() const;
  friend bool operator==(const Presentation&, const Presentation&) = default;
};

/// The word in the letters that `Presentation::str` uses for so many generators.
std::string word_str(const Word& word, int generators);

/// Removes letters next to their inverses; `cyclically_reduced` also where the end meets the start.
/// O(length).
Word freely_reduced(const Word& word);
Word cyclically_reduced(const Word& word);

} // namespace tetrarch::algebra
