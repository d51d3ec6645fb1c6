// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Words of free groups: inverses and roots.

#include "tetrarch/algebra/group.hpp"

namespace tetrarch::reasons {

algebra::Word inverse(algebra::Word word);

/// The shortest word of which this one is a power, letter by letter, and the exponent.
struct Power {
  algebra::Word root;
  int exponent = 1;
};
Power power(const algebra::Word& word);

} // namespace tetrarch::reasons
