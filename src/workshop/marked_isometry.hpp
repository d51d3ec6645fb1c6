// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells and isometries of manifolds with marked edges; the promises stand in canonical.hpp.

#include "tetrarch/workshop/canonical.hpp"

namespace tetrarch::workshop {

Cells cells_with_marks(const Triangulation& tri, const CanonicalOptions& options, const Progress& progress);
Isometry isometry_with_marks(const Compared& x, const Compared& y, const CanonicalOptions& options,
                             const Progress& progress);

/// "orders 2, 2, null"
std::string orders_text(const Marks& marks);

} // namespace tetrarch::workshop
