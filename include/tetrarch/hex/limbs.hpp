// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Limbs and gaps of a solid that are thinner than the cells of a grid.
///
///      +--+--+--+--+     No cell of a thin limb is half full, and none is taken. So a way of cells is laid
///      |##|  |  |  |     through what the solid touches, from where it is lost farthest to where it is
///      |##|==:==:=~|     not: the fullest ones, joined by faces. Cells there become as thin as the limb
///      |##|  |  |  |     when they are fitted. A gap is a limb of the outside.
///      +--+--+--+--+

#include "tetrarch/hex/grid.hpp"

#include <functional>
#include <vector>

namespace tetrarch::hex {

/// Cells that the solid meets, 1 each: those with a sample point inside, and those on edges of tetrahedra.
/// O(n) for n cells that are met.
std::vector<char> met_cells(const product::Solid& solid, const Grid& grid, const std::vector<float>& filled,
                            const Progress& progress = {});

/// Asked whether cells can be chosen from these fractions.
using CanBeChosen = std::function<bool(const std::vector<float>&)>;

/// `filled` with 1 along ways to limbs that would be lost, and 0 along ways to gaps that would be closed,
/// where cells are taken that are `full`. A cell is lost if neither it nor one that touches it is in the
/// largest piece. Of a way that spoils the choice the first part is laid that does not, if any. O(n log n)
/// and up to four questions for each way.
std::vector<float> with_limbs(const Grid& grid, std::vector<float> filled, const std::vector<char>& met,
                              double full, const CanBeChosen& can_be_chosen, const Progress& progress = {});

} // namespace tetrarch::hex
