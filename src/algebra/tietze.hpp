// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The stages of `simplified`, from the cheapest to the dearest. Each takes a presentation and returns one of
/// the same group, whose generators are some of those given.

#include "tetrarch/algebra/group.hpp"

#include <cstdlib>

namespace tetrarch::algebra {

/// Removes generators that a relator equates to 1, to another generator or to its inverse, until no relator
/// of length 1 or 2 is left but squares g g. Relators come out cyclically reduced and not empty; generators
/// keep their order. Linear for the first kind, one pass over the rest for every level of consequences for
/// the other.
Kept without_short_relators(const Presentation& presentation);

/// The rest of what `simplified` promises.
Kept tietze_reduced(const Presentation& presentation, const TietzeOptions& options, const Progress& progress);

inline int generator_of(int letter) {
  return std::abs(letter) - 1;
}

/// The place of a letter in the order a < A < b < B < ...
inline int rank_of(int letter) {
  return 2 * std::abs(letter) + (letter < 0 ? 1 : 0);
}

/// The least word, in the order a < A < b < B < ..., among all rotations of a cyclically reduced word and of
/// its inverse. O(length).
Word least_rotation(const Word& word);
Word inverse(const Word& word);

/// Throws PreconditionError if some letter names no generator. O(length).
void require_letters(const Presentation& presentation);

} // namespace tetrarch::algebra
