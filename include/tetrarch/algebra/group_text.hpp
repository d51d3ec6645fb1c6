// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Presentations of groups as people write them.
///
///     < a, b | abAB, a^3, a*b^-2 >     a generator is a lower-case letter, digits may follow it;
///     < g1, g2 | g1G2 >                its capital is its inverse; 1 is the empty word
///     < a, b | a^2 = b^3 >             equal words: the first times the inverse of each other one is 1

#include "tetrarch/algebra/group.hpp"

#include <string>
#include <string_view>

namespace tetrarch::algebra {

/// The generators are numbered in the order in which they are listed, whatever they are called; what
/// `Presentation::str` writes comes back the same. Throws InputError that names `source`, the line, what was
/// found and what was expected; also for words of more than a million letters. O(length).
Presentation parse_presentation(std::string_view text, const std::string& source);

} // namespace tetrarch::algebra
