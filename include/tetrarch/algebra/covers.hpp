// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Covers of small degree: the transitive actions of a finitely presented group on 0, ..., degree - 1.
///
/// An action is the table of a connected cover: sheet p goes to `sheet[g][p]` along generator g. The
/// stabiliser of sheet 0 is a subgroup of that index, another base sheet gives a conjugate subgroup. The
/// search fills the table row by row; each relator must return to its sheet, and where one entry is missing
/// on the way, that entry follows. A full table counts once: among the numberings that start at any of its
/// sheets, only the one with the least table is kept. Source: Sims, "Computation with Finitely Presented
/// Groups" (1994), chapter 5.6.

#include "tetrarch/algebra/cover.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/progress.hpp"

#include <functional>
#include <vector>

namespace tetrarch::algebra {

/// What a word does with the sheets: read from left to right.
std::vector<int> action(const Cover& cover, const Word& word);

struct CoverOptions {
  int degree = 5;                    ///< greatest number of sheets
  long long most_steps = 10'000'000; ///< entries that may be tried; about a microsecond each
};

/// Calls `visit` for each connected cover of 2 to `options.degree` sheets, one for each class of conjugate
/// subgroups, until it returns false. True if all were visited; false if the budget ended the search, or the
/// visitor. Throws PreconditionError if a letter names no generator.
bool for_each_cover(const Presentation& group, const std::function<bool(const Cover&)>& visit,
                    const CoverOptions& options = {}, const Progress& progress = {});

/// The fundamental group of a cover, by Reidemeister and Schreier: a generator for each generator and sheet,
/// those of a spanning tree being trivial. Not simplified.
Presentation group_of(const Cover& cover, const Presentation& group);

/// The first homology of all covers of exactly `degree` sheets, as sorted texts: an invariant of the group.
/// Nothing if the budget was too small.
struct CoverHomology {
  bool complete = false;
  std::vector<std::string> of; ///< one for each class of conjugate subgroups
};
CoverHomology homology_of_covers(const Presentation& group, int degree, long long most_steps = 1'000'000,
                                 const Progress& progress = {});

/// Two groups told apart by their covers, if they can be.
struct CoverDifference {
  int compared = 1; ///< all covers of up to so many sheets were compared
  std::string
      what; ///< a clause that says in which number of sheets they differ, and how; empty: no difference
};
/// Compares `homology_of_covers` of 2, 3, ... up to `most_sheets` sheets, until they differ or the steps of one
/// number of sheets do not do.
CoverDifference difference_of_covers(const Presentation& x, const Presentation& y, int most_sheets,
                                     long long most_steps, const Progress& progress = {});

} // namespace tetrarch::algebra
