// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the tabulator key offers.

#include "../describe.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::program {

struct Completions {
  std::size_t start = 0;          ///< where the word begins that is to be completed
  std::vector<std::string> words; ///< sorted; each begins with what stands there; folders end with "/"
};

/// For the text left of the cursor. `table` is what `declared` gives. A command word becomes a verb or a
/// value's name; after "-", an option; after an option with a few choices, those; after the value of `move`,
/// names of moves; else values' names, census names and files.
Completions complete(std::string_view text, const std::vector<Declared>& table, const Values& values);

/// What all the words begin with.
std::string common_beginning(const std::vector<std::string>& words);

/// The words in columns from top to bottom, of files their last part only; lines of at most `width`
/// characters where words allow it.
std::string in_columns(const std::vector<std::string>& words, std::size_t width);

} // namespace tetrarch::program
