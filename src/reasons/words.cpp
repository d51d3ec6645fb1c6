// SPDX-License-Identifier: GPL-2.0-or-later
#include "words.hpp"

#include <algorithm>

namespace tetrarch::reasons {

using algebra::Word;

Word inverse(Word word) {
  std::reverse(word.begin(), word.end());
  for (int& letter : word) letter = -letter;
  return word;
}

Power power(const Word& word) {
  const std::size_t n = word.size();
  for (std::size_t d = 1; d < n; ++d) {
    const auto second = word.begin() + static_cast<std::ptrdiff_t>(d);
    if (n % d == 0 && std::equal(second, word.end(), word.begin()))
      return {{word.begin(), second}, static_cast<int>(n / d)};
  }
  return {word, 1};
}

} // namespace tetrarch::reasons
