// SPDX-License-Identifier: GPL-2.0-or-later
#include "patterns.hpp"
#include "words.hpp"

#include <algorithm>
#include <cstdlib>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Renamed;
using algebra::Word;

constexpr int greatest_value = 2;

/// The value of each generator.
using Character = std::vector<int>;

bool kills_relators(const Presentation& group, const Character& character) {
  return std::all_of(group.relators.begin(), group.relators.end(), [&character](const Word& relator) {
    int sum = 0;
    for (const int letter : relator)
      sum += letter > 0 ? character[static_cast<std::size_t>(letter - 1)]
                        : -character[static_cast<std::size_t>(-letter - 1)];
    return sum == 0;
  });
}

/// Adds 1 to the last digit of a number whose digits run from `least` to `most`; false at its end.
bool next(std::vector<int>& digits, int least, int most) {
  for (std::size_t k = digits.size(); k-- > 0;) {
    if (++digits[k] <= most) return true;
    digits[k] = least;
  }
  return false;
}

Word power_of(int letter, int exponent) {
  return Word(static_cast<std::size_t>(std::abs(exponent)), exponent > 0 ? letter : -letter);
}

} // namespace

std::optional<Renamed> with_stable_letter(const Renamed& group, int most, Claim& claim) {
  const int n = group.presentation.generators;
  constexpr int most_generators = 6;
  if (n < 2 || n > most_generators) return std::nullopt;
  Character character(static_cast<std::size_t>(n), -greatest_value);
  do {
    if (!kills_relators(group.presentation, character)) continue;
    for (int t = 0; t < n; ++t) {
      if (character[static_cast<std::size_t>(t)] != 1) continue;
      // x = t^shift x' t^(value - shift)
      std::vector<int> shift(static_cast<std::size_t>(n), -1);
      do {
        if (shift[static_cast<std::size_t>(t)] != -1) continue;
        if (--most < 0) return std::nullopt;
        std::vector<Word> word_of;
        for (int x = 0; x < n; ++x) {
          const auto at = static_cast<std::size_t>(x);
          if (x == t) {
            word_of.push_back({t + 1});
            continue;
          }
          Word word = power_of(t + 1, shift[at]);
          word.push_back(x + 1);
          const Word right = power_of(t + 1, character[at] - shift[at]);
          word.insert(word.end(), right.begin(), right.end());
          word_of.push_back(std::move(word));
        }
        Renamed other = substituted(group, word_of);
        for (const int letter : {t + 1, -(t + 1)}) {
          claim.elements.assign(1, {});
          if (!is_stable_letter(other.presentation, letter, claim.elements.front())) continue;
          claim.kind = Kind::stable_letter;
          claim.generators = {t};
          return other;
        }
      } while (next(shift, -1, 1));
    }
  } while (next(character, -greatest_value, greatest_value));
  return std::nullopt;
}

} // namespace tetrarch::reasons
