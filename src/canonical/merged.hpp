// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Lengths that are equal without a symmetry of classes (certify.hpp, B).

#include "cell_shapes.hpp"
#include "flatness.hpp"

#include <optional>

namespace tetrarch::canonical {

/// A structure whose lengths are proved to be equal in blocks.
struct MergedCells {
  CellShapes shapes;          ///< with the numbers of blocks for those of edge classes
  Decorated<numeric::Ball> m; ///< of the merged system's zero, which is the structure
};

/// Nothing where no lengths look equal, where walls carry diagonals, where there are cusps, or where the
/// proof fails.
std::optional<MergedCells> merge_equal_lengths(const Triangulation& tri, const Skeleton& skeleton,
                                               const hyperbolic::Metric<numeric::Ball>& lengths,
                                               const FlatFaces& flat, const CellShapes& shapes,
                                               const MergedSolver& solver);

} // namespace tetrarch::canonical
