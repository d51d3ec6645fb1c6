// SPDX-License-Identifier: GPL-2.0-or-later
#include "tietze.hpp"

#include <cstdlib>
#include <numeric>

namespace tetrarch::algebra {
namespace {

/// What each generator has become: 1, or a letter. A union-find forest with signs.
class Equations {
public:
  explicit Equations(int generators) : parent_(static_cast<std::size_t>(generators)) {
    std::iota(parent_.begin(), parent_.end(), 1);
  }

  /// The letter that stands for this one, 0 if it is 1.
  int now(int letter) {
    int g = generator_of(letter);
    bool inverted = letter < 0;
    while (parent_[g] != 0 && parent_[g] != g + 1) {
      const int up = generator_of(parent_[g]);
      const int above = parent_[up];
      if (above != up + 1) parent_[g] = parent_[g] < 0 ? -above : above; // halve the path
      if (parent_[g] == 0) break;
      inverted ^= parent_[g] < 0;
      g = generator_of(parent_[g]);
    }
    if (parent_[g] == 0) return 0;
    return inverted ? -(g + 1) : g + 1;
  }
  /// Sets a letter that stands for itself to 1, or to another such letter.
  void set(int letter, int value) { parent_[generator_of(letter)] = letter < 0 ? -value : value; }

private:
  std::vector<int> parent_;
};

/// Finds the generators that die by relators of which only one letter is left. Counting letters, rather than
/// rewriting words, keeps this linear even where one relator is very long. The last letter of a relator is
/// found by keeping the exclusive or of all its generators.
class Killing {
public:
  explicit Killing(const Presentation& p);
  void run(Equations& equations);

private:
  std::vector<int> start_;   ///< of a generator's stretch in `place_`
  std::vector<int> place_;   ///< the relators that it occurs in, repeated as often as it does
  std::vector<int> left_;    ///< letters left in a relator
  std::vector<int> mixture_; ///< of the generators of these letters
  std::vector<int> ready_;
};

Killing::Killing(const Presentation& p)
    : start_(static_cast<std::size_t>(p.generators) + 1, 0), left_(p.relators.size(), 0),
      mixture_(p.relators.size(), 0) {
  for (const Word& word : p.relators)
    for (const int letter : word) ++start_[generator_of(letter) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  place_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (std::size_t r = 0; r < p.relators.size(); ++r) {
    for (const int letter : p.relators[r]) {
      place_[next[generator_of(letter)]++] = static_cast<int>(r);
      mixture_[r] ^= generator_of(letter);
    }
    left_[r] = static_cast<int>(p.relators[r].size());
    if (left_[r] == 1) ready_.push_back(static_cast<int>(r));
  }
}

void Killing::run(Equations& equations) {
  while (!ready_.empty()) {
    const int r = ready_.back();
    ready_.pop_back();
    if (left_[r] != 1) continue;
    const int g = mixture_[r];
    equations.set(g + 1, 0);
    for (int i = start_[g]; i < start_[g + 1]; ++i) {
      mixture_[place_[i]] ^= g;
      if (--left_[place_[i]] == 1) ready_.push_back(place_[i]);
    }
  }
}

Word rewritten(const Word& word, Equations& equations) {
  Word out;
  out.reserve(word.size());
  for (const int letter : word) {
    const int now = equations.now(letter);
    if (now == 0) continue;
    if (!out.empty() && out.back() == -now)
      out.pop_back();
    else
      out.push_back(now);
  }
  return cyclically_reduced(out);
}

/// One pass over all relators; true if an equation was found, so that relators passed already may change.
bool merge_pass(std::vector<Word>& relators, Equations& equations) {
  bool found = false;
  for (Word& word : relators) {
    word = rewritten(word, equations);
    const bool kills = word.size() == 1;
    const bool merges = word.size() == 2 && std::abs(word[0]) != std::abs(word[1]);
    if (!kills && !merges) continue;
    if (kills)
      equations.set(word[0], 0);
    else if (std::abs(word[0]) > std::abs(word[1])) // the generator that came first stays
      equations.set(word[0], -word[1]);
    else
      equations.set(word[1], -word[0]);
    word.clear();
    found = true;
  }
  std::erase_if(relators, [](const Word& word) { return word.empty(); });
  return found;
}

} // namespace

Kept without_short_relators(const Presentation& presentation) {
  Kept result{presentation, {}};
  Presentation& out = result.presentation;
  for (Word& word : out.relators) word = cyclically_reduced(word);
  Equations equations(out.generators);
  Killing(out).run(equations);
  while (merge_pass(out.relators, equations)) {
  }
  std::vector<int> number(static_cast<std::size_t>(out.generators), 0);
  int kept = 0;
  for (int g = 0; g < out.generators; ++g) {
    if (equations.now(g + 1) != g + 1) continue;
    number[g] = ++kept;
    result.generator.push_back(g);
  }
  for (Word& word : out.relators)
    for (int& letter : word) letter = letter > 0 ? number[letter - 1] : -number[-letter - 1];
  out.generators = kept;
  return result;
}

} // namespace tetrarch::algebra
