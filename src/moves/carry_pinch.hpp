// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Pinching (merge.hpp) with the words of the links.

#include "tetrarch/moves/monodromy.hpp"

namespace tetrarch::moves {

/// False, and nothing is changed: the pinch is illegal, or not all words of the new crossings follow from
/// those around.
bool carry_pinch(Complex& complex, Monodromy& monodromy, DirectedTetEdge e);

} // namespace tetrarch::moves
