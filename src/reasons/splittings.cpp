// SPDX-License-Identifier: GPL-2.0-or-later
#include "patterns.hpp"
#include "words.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>
#include <span>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Word;

int generator_of(int letter) {
  return std::abs(letter) - 1;
}

/// Where a generator stands.
struct Occurrences {
  int relators = 0; ///< in how many of them
  int letters = 0;
  int exponent = 0; ///< the greatest common divisor of its powers, each as long as it goes
  int last = -1;    ///< the last relator that holds it
};

/// Of each generator, in one pass.
std::vector<Occurrences> occurrences(const Presentation& group) {
  std::vector<Occurrences> of(static_cast<std::size_t>(group.generators));
  for (std::size_t r = 0; r < group.relators.size(); ++r) {
    const Word& relator = group.relators[r];
    const std::size_t n = relator.size();
    for (const int letter : relator) {
      Occurrences& in = of[static_cast<std::size_t>(generator_of(letter))];
      in.relators += in.last == static_cast<int>(r) ? 0 : 1;
      in.last = static_cast<int>(r);
      ++in.letters;
    }
    std::size_t start = 0; // of a power
    while (start < n && generator_of(relator[start]) == generator_of(relator[(start + n - 1) % n])) ++start;
    if (start == n) { // reduced: all letters are the same
      int& exponent = of[static_cast<std::size_t>(generator_of(relator.front()))].exponent;
      exponent = std::gcd(exponent, static_cast<int>(n));
      continue;
    }
    int run = 0;
    for (std::size_t k = start; k < start + n; ++k) {
      ++run;
      if (generator_of(relator[(k + 1) % n]) == generator_of(relator[k % n])) continue;
      int& exponent = of[static_cast<std::size_t>(generator_of(relator[k % n]))].exponent;
      exponent = std::gcd(exponent, run);
      run = 0;
    }
  }
  return of;
}

/// The relators that hold each generator.
std::vector<std::vector<int>> relators_of_generators(const Presentation& group) {
  std::vector<std::vector<int>> of(static_cast<std::size_t>(group.generators));
  for (std::size_t r = 0; r < group.relators.size(); ++r)
    for (const int letter : group.relators[r]) {
      std::vector<int>& held = of[static_cast<std::size_t>(generator_of(letter))];
      if (held.empty() || held.back() != static_cast<int>(r)) held.push_back(static_cast<int>(r));
    }
  return of;
}

bool is_commutator(const Word& w) {
  return w.size() == 4 && w[0] == -w[2] && w[1] == -w[3];
}

bool is_visibly_abelian(const Presentation& group) {
  std::set<std::pair<int, int>> commute;
  for (const Word& w : group.relators)
    if (is_commutator(w))
      commute.emplace(std::min(generator_of(w[0]), generator_of(w[1])),
                      std::max(generator_of(w[0]), generator_of(w[1])));
  return static_cast<int>(commute.size()) == group.generators * (group.generators - 1) / 2;
}

/// Generators that relators join, by a number for each.
std::vector<int> joined(const Presentation& group) {
  std::vector<int> part(static_cast<std::size_t>(group.generators));
  std::iota(part.begin(), part.end(), 0);
  for (const Word& relator : group.relators)
    for (const int letter : relator) {
      const int a = part[static_cast<std::size_t>(generator_of(letter))];
      const int b = part[static_cast<std::size_t>(generator_of(relator.front()))];
      if (a != b) std::replace(part.begin(), part.end(), std::max(a, b), std::min(a, b));
    }
  return part;
}

std::vector<int> members(const std::vector<int>& part, int number) {
  std::vector<int> in;
  for (std::size_t g = 0; g < part.size(); ++g)
    if (part[g] == number) in.push_back(static_cast<int>(g));
  return in;
}

/// Each two generators of a set.
std::vector<std::pair<Word, Word>> pairs(const std::vector<int>& generators) {
  std::vector<std::pair<Word, Word>> all;
  for (const int a : generators)
    for (const int b : generators)
      if (a < b) all.push_back({{a + 1}, {b + 1}});
  return all;
}

/// Two or more sets of generators that no relator joins. A factor might be trivial, if it has relators; then
/// some generator of each is not 1.
void add_free_product(const Presentation& group, std::vector<Claim>& claims) {
  const std::vector<int> part = joined(group);
  const std::set<int> numbers(part.begin(), part.end());
  if (numbers.size() < 2) return;
  // One claim for each choice of a generator in the first two factors, of so many of them.
  const std::vector<int> first = members(part, *numbers.begin());
  const std::vector<int> second = members(part, *std::next(numbers.begin()));
  constexpr std::size_t most = 30;
  for (const int a : std::span(first).first(std::min(most, first.size())))
    for (const int b : std::span(second).first(std::min(most, second.size()))) {
      Claim claim;
      claim.kind = Kind::free_product;
      claim.generators = first;
      claim.not_one = {{a + 1}, {b + 1}};
      claims.push_back(claim);
    }
}

/// Whether all these words are powers of one; its root, or the empty word if there are none.
struct CommonRoot {
  bool exists = true;
  Word root;
  void add(const Word& word) {
    if (!exists) return;
    const Word of = power(word).root;
    if (root.empty()) root = of;
    exists = of == root || of == inverse(root);
  }
};

/// The generators of a set occur, except in relators of their own, in powers of one word u only: an amalgam
/// over u if neither side is that cyclic group.
void add_amalgam(const Presentation& group, const std::vector<bool>& in_set, std::vector<Claim>& claims) {
  const auto is_in = [&in_set](int letter) { return in_set[static_cast<std::size_t>(generator_of(letter))]; };
  CommonRoot u;
  for (const Word& relator : group.relators) {
    const std::size_t n = relator.size();
    std::size_t start = 0;
    while (start < n && is_in(relator[start])) ++start;
    if (start == n) continue;
    Word run;
    for (std::size_t k = start; k <= start + n && u.exists; ++k) {
      const int letter = relator[k % n];
      if (is_in(letter)) {
        run.push_back(letter);
        continue;
      }
      if (!run.empty()) u.add(run);
      run.clear();
    }
  }
  if (!u.exists || u.root.empty()) return; // without u it is a free product
  Claim claim;
  claim.kind = Kind::amalgam;
  claim.elements = {u.root};
  std::vector<std::pair<Word, Word>> beside;
  for (int g = 0; g < group.generators; ++g) {
    if (in_set[static_cast<std::size_t>(g)])
      claim.generators.push_back(g);
    else
      beside.push_back({{g + 1}, u.root});
  }
  claim.one_not_commuting = {pairs(claim.generators), beside};
  claims.push_back(std::move(claim));
}

/// All sets of two or more generators, not all of them. From eight generators on, pairs alone.
void add_amalgams(const Presentation& group, std::vector<Claim>& claims) {
  const int n = group.generators;
  constexpr int most_generators = 7;
  std::vector<bool> in(static_cast<std::size_t>(n));
  if (n > most_generators) return;
  for (int set = 1; set + 1 < 1 << n; ++set) {
    int size = 0;
    for (int g = 0; g < n; ++g) {
      in[static_cast<std::size_t>(g)] = (set >> g & 1) != 0;
      size += set >> g & 1;
    }
    if (size > 1) add_amalgam(group, in, claims);
  }
}

/// The root of what stands between t and T in a relator, if each t is followed by a T before the next t and
/// each T by a t; it does not exist otherwise.
void add_between(const Word& relator, int t, CommonRoot& root) {
  const std::size_t n = relator.size();
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < n; ++k)
    if (generator_of(relator[k]) == generator_of(t)) at.push_back(k);
  // Signs first, which cost nothing and mostly decide.
  for (std::size_t k = 0; k < at.size(); ++k)
    if (relator[at[k]] == relator[at[(k + 1) % at.size()]]) root.exists = false;
  for (std::size_t k = 0; k < at.size() && root.exists; ++k) {
    if (relator[at[k]] != t) continue;
    const std::size_t end = k + 1 < at.size() ? at[k + 1] : at.front() + n;
    Word word;
    for (std::size_t i = at[k] + 1; i < end; ++i) word.push_back(relator[i % n]);
    root.add(word);
  }
}

/// Only relators in `holding` hold the letter or its inverse.
bool is_stable_letter_in(const Presentation& group, const std::vector<int>& holding, int t, Word& v) {
  CommonRoot root;
  for (std::size_t k = 0; k < holding.size() && root.exists; ++k)
    add_between(group.relators[static_cast<std::size_t>(holding[k])], t, root);
  v = root.root;
  return root.exists && !v.empty();
}

void add_stable_letters(const Presentation& group, std::vector<Claim>& claims) {
  const std::vector<std::vector<int>> holding = relators_of_generators(group);
  for (int g = 0; g < group.generators; ++g)
    for (const int t : {g + 1, -(g + 1)}) {
      Claim claim;
      claim.kind = Kind::stable_letter;
      claim.generators = {g};
      claim.elements.emplace_back();
      if (is_stable_letter_in(group, holding[static_cast<std::size_t>(g)], t, claim.elements.front()))
        claims.push_back(claim);
    }
}

} // namespace

std::vector<Claim> splittings(const Presentation& group) {
  std::vector<Claim> claims;
  const auto add = [&claims](Kind kind, std::vector<int> generators, int p) {
    Claim claim;
    claim.kind = kind;
    claim.generators = std::move(generators);
    claim.p = p;
    claims.push_back(std::move(claim));
  };
  if (group.generators <= 1) {
    add(Kind::cyclic_group, {}, 0);
    return claims;
  }
  if (is_visibly_abelian(group)) {
    add(Kind::abelian_group, {}, 0);
    return claims;
  }
  const std::vector<Occurrences> of = occurrences(group);
  add_stable_letters(group, claims);
  for (int g = 0; g < group.generators; ++g) {
    const Occurrences& in = of[static_cast<std::size_t>(g)];
    if (in.exponent != 1) add(Kind::root, {g}, in.exponent);
    if (in.relators == 1 && in.letters == 2) add(Kind::twice, {g}, 0);
  }
  add_free_product(group, claims);
  add_amalgams(group, claims);
  return claims;
}

bool is_stable_letter(const Presentation& group, int t, Word& v) {
  return is_stable_letter_in(group, relators_of_generators(group)[static_cast<std::size_t>(generator_of(t))],
                             t, v);
}

} // namespace tetrarch::reasons
