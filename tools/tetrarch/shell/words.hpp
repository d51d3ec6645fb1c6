// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::program {

/// The words of a line: parted by blanks, a blank or a # inside kept by '...', "..." or a backslash. From a #
/// at the beginning of a word on, the line is a comment. Throws InputError for a quote that does not end.
std::vector<std::string> words_of(std::string_view line);

/// The word so that `words_of` gives it back: quoted if it must be.
std::string quoted(const std::string& word);

} // namespace tetrarch::program
