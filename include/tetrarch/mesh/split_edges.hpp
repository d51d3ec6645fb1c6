// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Edges of a tetrahedral mesh split, as many as one likes at once.
///
///          d                 d            A tetrahedron with several edges to be split is halved at one of
///         /|\               /|\           them, its halves at the next, and so on. Which edge comes first is
///        / | \             / | \          the same everywhere: the longest, of equal ones the one of least
///       a--|--b    -->    a--m--b         vertices. So the two sides of a face are cut alike, and nothing
///        \ | /             \ | /          needs to be looked up in a neighbour.
///          c                 c
///
/// Where every edge is split at which a function changes its sign, no tetrahedron has both signs afterwards.

#include "tetrarch/mesh/tet_mesh.hpp"

#include <array>
#include <vector>

namespace tetrarch::mesh {

/// A point on the edge between two vertices: `part` of the way from the first to the second, in (0, 1).
struct EdgePoint {
  int from = 0;
  int to = 0;
  double part = 0.5;
};

struct SplitTets {
  /// Vertices keep their numbers; that of split k is the number of vertices before plus k. The pieces of a
  /// tetrahedron follow one another, all as it is handed.
  TetMesh mesh;
  std::vector<int> origin; ///< of each tetrahedron, the one that it is a piece of
  /// Of face f of tetrahedron t, at 4 t + f: the face of its origin that it lies in, or -1 inside.
  std::vector<int> face_of;
};

/// Throws `PreconditionError` if an edge is given twice, has no ends, or is none of the mesh. O(n log n).
SplitTets split_edges(const TetMesh& mesh, const std::vector<EdgePoint>& splits);

} // namespace tetrarch::mesh
