// SPDX-License-Identifier: GPL-2.0-or-later
#include "patterns.hpp"
#include "words.hpp"

#include <algorithm>

namespace tetrarch::reasons {
namespace {

using algebra::Presentation;
using algebra::Word;

constexpr std::size_t longest_relator = 60;

Word part(const Word& word, std::size_t from, std::size_t to) {
  return {word.begin() + static_cast<std::ptrdiff_t>(from), word.begin() + static_cast<std::ptrdiff_t>(to)};
}

/// Two elements that commute.
struct Pair {
  Word x, y;
};

/// Of one relator, for each of its rotations.
class Reader {
public:
  Reader(std::vector<Claim>& claims, std::vector<Pair>& commuting) : claims_(claims), commuting_(commuting) {}

  void read(Word word) {
    const Power whole = power(word);
    if (whole.exponent > 1) {
      Claim claim;
      claim.kind = Kind::torsion;
      claim.elements = {whole.root};
      claim.p = whole.exponent;
      claim.not_one = {whole.root};
      claims_.push_back(claim);
    }
    for (std::size_t k = 0; k < word.size(); ++k) {
      std::rotate(word.begin(), word.begin() + 1, word.end());
      read_powers(word);
      read_conjugates(word);
    }
  }

private:
  /// word = u^p v^q
  void read_powers(const Word& word) {
    for (std::size_t i = 2; i + 2 <= word.size(); ++i) {
      const Power u = power(part(word, 0, i));
      if (u.exponent == 1) continue;
      const Power v = power(part(word, i, word.size()));
      if (v.exponent == 1 || u.root == v.root || u.root == inverse(v.root)) continue;
      Claim claim;
      claim.kind = Kind::common_power;
      claim.elements = {u.root, inverse(v.root)};
      claim.p = u.exponent;
      claim.q = v.exponent;
      claim.not_commuting = {{u.root, v.root}};
      claims_.push_back(claim);
    }
  }

  /// word = u v^p U v^-q
  void read_conjugates(const Word& word) {
    const std::size_t n = word.size();
    for (std::size_t m = 1; 2 * m + 2 <= n; ++m)
      for (std::size_t j = m + 1; j + m + 1 <= n; ++j) {
        bool inverted = true;
        for (std::size_t k = 0; k < m && inverted; ++k) inverted = word[j + k] == -word[m - 1 - k];
        if (!inverted) continue;
        const Power v = power(part(word, m, j));
        const Power w = power(part(word, j + m, n));
        const bool same = w.root == v.root;
        if (!same && w.root != inverse(v.root)) continue;
        note_conjugates(part(word, 0, m), v.root, v.exponent, same ? -w.exponent : w.exponent);
      }
  }

  void note_conjugates(const Word& u, const Word& v, int p, int q) {
    if (p == 1 && q == 1) {
      commuting_.push_back({u, v});
      return;
    }
    Claim claim;
    claim.kind = Kind::conjugate_powers;
    claim.elements = {u, v};
    claim.p = p;
    claim.q = q;
    if (p == q)
      claim.not_commuting = {{u, v}}; // v^p commutes with u and v
    else
      claim.not_one = {v}; // lengths of translations would differ, or u turn an axis around
    claims_.push_back(claim);
  }

  std::vector<Claim>& claims_;
  std::vector<Pair>& commuting_;
};

void add_planes(const std::vector<Pair>& commuting, std::vector<Claim>& claims) {
  for (const auto& [x, y] : commuting) {
    Claim claim;
    claim.kind = Kind::plane;
    claim.elements = {x, y};
    claim.not_cyclic = {{x, y}};
    claims.push_back(claim);
  }
}

/// Elements that commute with one and the same.
void add_chains(const std::vector<Pair>& commuting, std::vector<Claim>& claims) {
  constexpr std::size_t most_claims = 400;
  std::vector<Pair> both = commuting;
  for (const auto& [x, y] : commuting) both.push_back({y, x});
  for (std::size_t i = 0; i < both.size(); ++i)
    for (std::size_t j = 0; j < i && claims.size() < most_claims; ++j) {
      if (both[i].x != both[j].x && both[i].x != inverse(both[j].x)) continue;
      const Word& y = both[i].y;
      const Word& z = both[j].y;
      if (y == z || y == inverse(z)) continue;
      Claim claim;
      claim.kind = Kind::commuting;
      claim.elements = {both[i].x, y, z};
      claim.not_one = {both[i].x};
      claim.not_commuting = {{y, z}};
      claims.push_back(claim);
    }
}

} // namespace

std::vector<Claim> relations(const Presentation& group, bool has_cusps) {
  std::vector<Claim> claims;
  std::vector<Pair> commuting;
  for (const Word& relator : group.relators)
    if (relator.size() <= longest_relator) Reader(claims, commuting).read(relator);
  if (!has_cusps) add_planes(commuting, claims);
  add_chains(commuting, claims);
  return claims;
}

} // namespace tetrarch::reasons
