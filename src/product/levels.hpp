// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A solid refined along level lines of a function on its boundary, so that patches get smooth rims.
///
///       + / +         Where an edge of the boundary crosses the level, it is split there; vertices that are
///      --/------      almost on the level count as on it, which spares slivers.
///       / -  -

#include "tetrarch/product/solid.hpp"
#include "tetrarch/solid/split_edges.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// Linear on each triangle of the boundary, given at its corners: triangles may differ at a vertex, as along
/// a cut.
using CornerValues = std::vector<std::array<double, 3>>;

struct Levelled {
  Solid solid;
  CornerValues values;                  ///< no triangle has the level between its values
  std::vector<solid::EdgePoint> splits; ///< split k made vertex n + k of a solid with n
};
/// The values must agree along edges that cross the level. A vertex counts as on the level if it does for
/// some triangle. O(n log n).
Levelled split_at_level(const Solid& solid, CornerValues values, double level);

} // namespace tetrarch::product
