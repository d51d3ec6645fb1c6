// SPDX-License-Identifier: GPL-2.0-or-later
#include "quotients.hpp"
#include "span.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <set>

namespace tetrarch::reasons {
namespace {

using algebra::Cover;
using algebra::Presentation;
using algebra::Word;
using Pairs = std::vector<std::pair<Word, Word>>;

using Permutation = std::vector<int>;

Permutation after(const Permutation& first, const Permutation& second) {
  Permutation both;
  for (const int p : first) both.push_back(second[static_cast<std::size_t>(p)]);
  return both;
}

Permutation identity(int degree) {
  Permutation id(static_cast<std::size_t>(degree));
  std::iota(id.begin(), id.end(), 0);
  return id;
}

int order_of(const Permutation& p) {
  int order = 1;
  for (Permutation power = p; power != identity(static_cast<int>(p.size())); power = after(power, p)) ++order;
  return order;
}

/// Of the group that two permutations generate which commute: it is cyclic iff it has an element of its
/// order.
bool is_cyclic(const Permutation& a, const Permutation& b) {
  std::set<Permutation> group;
  Permutation row = identity(static_cast<int>(a.size()));
  do {
    Permutation at = row;
    do {
      group.insert(at);
      at = after(at, a);
    } while (at != row);
    row = after(row, b);
  } while (row != identity(static_cast<int>(a.size())));
  return static_cast<int>(group.size()) == std::lcm(order_of(a), order_of(b));
}

/// Groups that are not abelian are not cyclic either.
bool generate_more_than_a_cycle(const Cover& cover, const Word& x, const Word& y) {
  const Permutation a = action(cover, x);
  const Permutation b = action(cover, y);
  return after(a, b) != after(b, a) || !is_cyclic(a, b);
}

bool do_not_commute(const Cover& cover, const Word& x, const Word& y) {
  const Permutation a = action(cover, x);
  const Permutation b = action(cover, y);
  return after(a, b) != after(b, a);
}

bool shown_by(const Cover& cover, const Claim& claim) {
  const auto commute_not = [&cover](const auto& pair) {
    return do_not_commute(cover, pair.first, pair.second);
  };
  for (const Word& word : claim.not_one)
    if (action(cover, word) == identity(cover.degree)) return false;
  for (const auto& [x, y] : claim.not_cyclic)
    if (!generate_more_than_a_cycle(cover, x, y)) return false;
  if (!std::all_of(claim.not_commuting.begin(), claim.not_commuting.end(), commute_not)) return false;
  return std::all_of(claim.one_not_commuting.begin(), claim.one_not_commuting.end(), [&](const Pairs& pairs) {
    return std::any_of(pairs.begin(), pairs.end(), commute_not);
  });
}

/// In homology everything commutes.
bool shown_modulo(int prime, const Presentation& group, const Claim& claim) {
  if (!claim.not_commuting.empty() || !claim.one_not_commuting.empty()) return false;
  Span relations(group.generators, prime);
  for (const Word& relator : group.relators) relations.add(relations.vector_of(relator));
  for (const Word& word : claim.not_one) {
    Span with = relations;
    if (!with.add(with.vector_of(word))) return false;
  }
  for (const auto& [x, y] : claim.not_cyclic) {
    Span with = relations;
    if (!with.add(with.vector_of(x)) || !with.add(with.vector_of(y))) return false;
  }
  return true;
}

} // namespace

bool shows(const Quotient& quotient, const Presentation& group, const Claim& claim) {
  if (quotient.modulus > 0) return shown_modulo(quotient.modulus, group, claim);
  if (!quotient.cover) return claim.is_proof();
  const Cover& cover = *quotient.cover;
  const bool acts = std::all_of(group.relators.begin(), group.relators.end(), [&cover](const Word& relator) {
    return action(cover, relator) == identity(cover.degree);
  });
  return acts && shown_by(cover, claim);
}

std::optional<Proved> first_proved(const std::vector<Claim>& claims, const Presentation& group, int degree,
                                   long long cover_steps, const Progress& progress) {
  for (const Claim& claim : claims)
    if (claim.is_proof()) return Proved{claim, std::nullopt};
  constexpr std::array primes{2, 3, 5, 7, 11, 13};
  for (const Claim& claim : claims)
    for (const int prime : primes)
      if (shown_modulo(prime, group, claim)) return Proved{claim, Quotient{prime, std::nullopt}};
  if (claims.empty()) return std::nullopt;
  std::optional<Proved> found;
  for_each_cover(
      group,
      [&](const Cover& cover) {
        for (const Claim& claim : claims)
          if (shown_by(cover, claim)) {
            found = Proved{claim, Quotient{0, cover}};
            return false;
          }
        return true;
      },
      {degree, cover_steps}, progress);
  return found;
}

} // namespace tetrarch::reasons
