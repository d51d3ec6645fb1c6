// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The cells with which a filling begins.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/grid.hpp"
#include "tetrarch/hex/targets.hpp"

#include <optional>

namespace tetrarch::hex {

/// Cells of a grid with about such edges, of the solid's genus, with planes in its flat sides and ways into
/// its thin limbs; nothing where none were found.
std::optional<SizedHexahedra> cells_in(const product::Solid& solid, const Targets& targets, double edge,
                                       const Progress& progress);

} // namespace tetrarch::hex
