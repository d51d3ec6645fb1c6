// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Patterns in the relators of a presentation, and what they claim.

#include "tetrarch/algebra/whitehead.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <optional>
#include <vector>

namespace tetrarch::reasons {

/// A pattern, and what must hold besides for it to be a proof. With nothing besides, it is one.
struct Claim {
  Kind kind = Kind::cyclic_group;
  std::vector<int> generators;
  std::vector<algebra::Word> elements;
  int p = 0, q = 0;
  std::vector<algebra::Word> not_one;                              ///< each is not 1
  std::vector<std::pair<algebra::Word, algebra::Word>> not_cyclic; ///< each pair generates no cyclic group
  std::vector<std::pair<algebra::Word, algebra::Word>> not_commuting;
  /// From each list one pair does not commute: the sides of an amalgam are not cyclic.
  std::vector<std::vector<std::pair<algebra::Word, algebra::Word>>> one_not_commuting;

  bool is_proof() const {
    return not_one.empty() && not_cyclic.empty() && not_commuting.empty() && one_not_commuting.empty();
  }
};

/// The group is cyclic, abelian, a free product, or splits over a cyclic group: what the letters alone say.
/// Relators are cyclically reduced and not empty. O(length), and for each generator that might be a stable
/// letter the length of the relators that hold it.
std::vector<Claim> splittings(const algebra::Presentation& group);

/// Whether the letter t occurs in subwords t v^k T only, with one word v, which it tells.
bool is_stable_letter(const algebra::Presentation& group, int t, algebra::Word& v);

/// Other generators in which one is a stable letter: a homomorphism to the integers takes some generator t to
/// 1, and every other generator is multiplied by powers of t until it goes to 0. Homomorphisms with values
/// from -2 to 2 and `most` choices of generators are tried.
std::optional<algebra::Renamed> with_stable_letter(const algebra::Renamed& group, int most, Claim& claim);

/// What powers and commutators claim of a discrete group of isometries that preserve orientation. O(n^3) for
/// a relator of n letters; longer ones than 60 are passed over.
std::vector<Claim> relations(const algebra::Presentation& group, bool has_cusps);

} // namespace tetrarch::reasons
