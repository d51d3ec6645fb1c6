// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells as polyhedra: corners, edges, walls; and the symmetries of all of them at once.

#include "tetrarch/canonical/cells.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetrarch::canonical {

/// A polyhedron with corners 0, 1, ...; pairs of corners are in increasing order.
struct CellShape {
  std::vector<int> tets;
  int corners = 0;
  std::vector<VertexId> vertex;                       ///< of each corner, the vertex class
  std::vector<std::vector<int>> edge_class;           ///< of each pair of corners, or -1 where no edge is
  std::vector<std::vector<int>> walls;                ///< corners, sorted
  std::vector<std::vector<std::array<int, 2>>> drawn; ///< of each wall, its diagonals, sorted
  std::vector<std::pair<int, int>> partner;           ///< of each wall, the cell and wall it is glued to
};

struct CellShapes {
  std::vector<CellShape> cells;
  std::vector<std::array<int, 4>> corner; ///< of each tetrahedron's vertices, in its cell
  std::vector<int> cell_of;               ///< of each tetrahedron
};

/// The cells of a closed gluing by their first tetrahedra. O(n log n).
CellShapes cell_shapes(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat);

/// A map of corners to corners.
using CornerMap = std::vector<int>;

/// Where a cell goes.
struct PlacedCell {
  int cell = -1;
  CornerMap corners;
};
/// Of each cell.
using Symmetry = std::vector<PlacedCell>;

/// For each map of this cell to itself that extends to a symmetry of all cells as certify.hpp has it one such
/// symmetry (classes of vertices go to classes, if that is asked for). The maps form a group. Nothing if the
/// search is longer than its budget.
std::optional<std::vector<Symmetry>> symmetries_of_cell(const CellShapes& shapes, int cell,
                                                        bool classes_of_vertices);

} // namespace tetrarch::canonical
