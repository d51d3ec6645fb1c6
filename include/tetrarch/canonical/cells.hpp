// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells glued from tetrahedra, and a triangulation that depends on the cells alone.
///
/// Some faces of a triangulation are only drawn (flat): forget them, and tetrahedra grow together to
/// polyhedral cells. An edge with no wall around it vanishes inside a cell; an edge with exactly two walls
/// around it is a diagonal of a polygon and vanishes as well, because no two cells can meet at an edge with
/// angles of pi.
///
///     cell_center --- wall_center    One small tetrahedron for each side of each wall polygon of each cell:
///          \            /            the two ends of the side, the centre of the wall, the centre of the
///           side of a wall           cell.

#include "tetrarch/core/skeleton.hpp"

#include <array>
#include <string>
#include <vector>

namespace tetrarch::canonical {

/// flat[t][f]: face f of tetrahedron t is only drawn. Both sides of a face agree.
using FlatFaces = std::vector<std::array<bool, 4>>;

/// One cell: the numbers of corners of its wall polygons, in decreasing order.
struct Cell {
  std::vector<int> walls;
  /// "tetrahedron", "square pyramid", "octahedron", or for instance "cell with 6 walls (4,4,4,4,4,4)".
  std::string name() const;
};

/// The cells, and the triangulation that depends on them alone.
struct CellDecomposition {
  std::vector<Cell> cells; ///< by their first tetrahedron
  /// Coned from the centres of cells and walls, whatever the diagonals were: isomorphic for equal
  /// decompositions.
  Triangulation coned;
  /// Of each small tetrahedron, the wall's face that has its side, and the vertex of this face off the side.
  /// Its corners 0 and 1 are the face's other two vertices in increasing order, 2 and 3 the centers of wall
  /// and cell. Empty where the cells were not made of tetrahedra.
  struct Origin {
    TetFace wall;
    int off = 0;
  };
  std::vector<Origin> origin;
};

/// The decomposition of a closed gluing of which the flat faces are known. O(n).
CellDecomposition cell_decomposition(const Triangulation& tri, const Skeleton& skeleton,
                                     const FlatFaces& flat);

} // namespace tetrarch::canonical
