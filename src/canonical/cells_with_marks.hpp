// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells where some edges are marked.

#include "tetrarch/canonical/cells.hpp"

namespace tetrarch::canonical {

/// As the function of three arguments (cells.hpp), but edges that are kept are edges of cells even where one
/// or two walls are around: the angles at a null edge are 0, and then a wall or two close up around it.
CellDecomposition cell_decomposition(const Triangulation& tri, const Skeleton& skeleton,
                                     const FlatFaces& flat, const Table<EdgeId, bool>& kept);

} // namespace tetrarch::canonical
