// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Flatness of a cell from linear relations between its inner products (certify.hpp, L).

#include "flatness.hpp"

#include <vector>

namespace tetrarch::canonical {

/// Entry (i, j): a number, equal where inner products are for a reason. Symmetric; the diagonal holds the
/// norms themselves, 0 or 1.
using SymbolMatrix = std::vector<std::vector<int>>;

/// Whether (1, ..., 1) is in the column space of G, a matrix of rank 4 exactly, of which `gram` holds the
/// entries. O(n^4) candidates of O(n^2) each for n corners.
bool is_flat_by_relations(const SymbolMatrix& symbols, const BallMatrix& gram);

} // namespace tetrarch::canonical
