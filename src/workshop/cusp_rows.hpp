// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is said of the cusps of a structure.

#include "tetrarch/workshop/structure.hpp"

namespace tetrarch::workshop {

/// "cusp 0", "torus, shape ..."
void add_cusps(const Structure& s, Rows& rows);
/// The same for JSON, and where the structure is certified the intervals that hold the shape.
Tree cusps_tree(const Structure& s);
/// Of that tree.
Type cusps_type();

} // namespace tetrarch::workshop
