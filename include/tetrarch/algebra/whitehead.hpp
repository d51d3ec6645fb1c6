// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Whitehead's automorphisms of free groups: other generators of the same group, in which relators are short.
///
/// Choose a letter a and a set S of letters that holds a and not its inverse A. The automorphism (S, a) keeps
/// a and takes every other letter x to x, with A before it if X lies in S and a behind it if x does. Draw
/// Whitehead's graph: its points are the letters, and wherever y follows x in a cyclic relator there is a
/// line from x to Y. Then the relators become longer by
///
///     (lines between S and its complement) - (lines at a),
///
/// so that the best S for a is a smallest cut between a and A. If no automorphism makes the relators shorter,
/// none at all does (Whitehead), and one relator that uses all generators of a shortest presentation belongs
/// to no free product (Shenitzer). Sources: Whitehead, "On equivalent sets of elements in a free group"
/// (1936); Lyndon and Schupp, "Combinatorial Group Theory" (1977), I.4.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/progress.hpp"

#include <vector>

namespace tetrarch::algebra {

/// The same group in other generators.
struct Renamed {
  Presentation presentation;
  std::vector<Word> image; ///< of each given generator, the word in the new ones
};

/// The presentation itself, its relators cyclically reduced, the empty ones left out.
Renamed unchanged(const Presentation& group);
/// The generators replaced by words, which must be an automorphism of the free group; relators come out
/// cyclically reduced. O(length).
Renamed substituted(const Renamed& before, const std::vector<Word>& word_of);

/// Whitehead automorphisms until none makes the relators shorter; they come out cyclically reduced. O(g^3 n)
/// for each letter that goes, with g generators and relators of n letters, and at most `most_steps`, some
/// 10^9 a second: what is reached by then is short, perhaps not shortest.
Renamed shortest(const Presentation& group, const Progress& progress = {},
                 long long most_steps = 200'000'000);

/// Further presentations that are as short: `from` first, then those that automorphisms lead to, at most
/// `most`. Generators are not permuted. From eight generators on, `from` alone.
std::vector<Renamed> as_short(const Renamed& from, int most, const Progress& progress = {});

} // namespace tetrarch::algebra
