// SPDX-License-Identifier: GPL-2.0-or-later
#include "patterns.hpp"
#include "words.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Word;

int generator_of(int letter) {
  return std::abs(letter) - 1;
}

/// How often each generator occurs in a relator.
std::vector<std::vector<int>> occurrences(const Presentation& group) {
  std::vector<std::vector<int>> count;
  for (const Word& relator : group.relators) {
    count.emplace_back(static_cast<std::size_t>(group.generators), 0);
    for (const int letter : relator) ++count.back()[static_cast<std::size_t>(generator_of(letter))];
  }
  return count;
}

/// The greatest common divisor of the exponents with which a generator occurs, each as long as it goes.
int common_exponent(const Presentation& group, int generator) {
  int divisor = 0;
  for (const Word& relator : group.relators) {
    const std::size_t n = relator.size();
    const auto is_it = [&](std::size_t k) { return generator_of(relator[k % n]) == generator; };
    std::size_t start = 0;
    while (start < n && is_it(start)) ++start;
    if (start == n) {
      divisor = std::gcd(divisor, static_cast<int>(n)); // reduced: all letters are the same
      continue;
    }
    int run = 0;
    for (std::size_t k = start; k <= start + n; ++k) {
      if (k < start + n && is_it(k)) {
        ++run;
        continue;
      }
      divisor = std::gcd(divisor, run);
      run = 0;
    }
  }
  return divisor;
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
  // One claim for each choice of a generator in the first two factors; factors are few and small.
  const std::vector<int> first = members(part, *numbers.begin());
  const std::vector<int> second = members(part, *std::next(numbers.begin()));
  for (const int a : first)
    for (const int b : second) {
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

void add_stable_letters(const Presentation& group, std::vector<Claim>& claims) {
  for (int g = 0; g < group.generators; ++g)
    for (const int t : {g + 1, -(g + 1)}) {
      Claim claim;
      claim.kind = Kind::stable_letter;
      claim.generators = {g};
      claim.elements.emplace_back();
      if (is_stable_letter(group, t, claim.elements.front())) claims.push_back(claim);
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
  const auto count = occurrences(group);
  add_stable_letters(group, claims);
  for (int g = 0; g < group.generators; ++g) {
    const int exponent = common_exponent(group, g);
    if (exponent != 1) add(Kind::root, {g}, exponent);
    int relators = 0;
    int total = 0;
    for (const auto& in : count) {
      relators += in[static_cast<std::size_t>(g)] > 0 ? 1 : 0;
      total += in[static_cast<std::size_t>(g)];
    }
    if (relators == 1 && total == 2) add(Kind::twice, {g}, 0);
  }
  add_free_product(group, claims);
  add_amalgams(group, claims);
  return claims;
}

bool is_stable_letter(const Presentation& group, int t, Word& v) {
  CommonRoot root;
  for (const Word& relator : group.relators) {
    const std::size_t n = relator.size();
    std::size_t start = 0;
    while (start < n && relator[start] != t) ++start;
    if (start == n) {
      if (std::find(relator.begin(), relator.end(), -t) != relator.end()) return false;
      continue;
    }
    bool inside = false;
    Word word;
    for (std::size_t k = start; k < start + n; ++k) {
      const int letter = relator[k % n];
      if (letter == (inside ? t : -t)) return false;
      if (letter == t) {
        inside = true;
        word.clear();
      } else if (letter == -t) {
        inside = false;
        root.add(word);
        if (!root.exists) return false;
      } else if (inside) {
        word.push_back(letter);
      }
    }
    if (inside) return false;
  }
  v = root.root;
  return !v.empty();
}

} // namespace tetrarch::reasons
