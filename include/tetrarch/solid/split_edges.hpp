// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Splitting edges of a tetrahedral mesh, any number at once.
///
///          d                 d            A tetrahedron with several edges to be split is halved at one of
///         /|\               /|\           them, its halves at the next, and so on. Which edge comes first is
///        / | \             / | \          the same everywhere: the longest, of equal ones the one of least
///       a--|--b    -->    a--m--b         vertices. So the two sides of a face are cut alike, and nothing
///        \ | /             \ | /          needs to be looked up in a neighbor.
///          c                 c
///
/// Where every edge is split at which a function changes its sign, no tetrahedron has both signs afterwards.

#include "tetrarch/solid/tet_mesh.hpp"

#include <array>
#include <vector>

namespace tetrarch::solid {

/// A point on the edge between two vertices: `part` of the way from the first to the second, in (0, 1).
struct EdgePoint {
  int from = 0;
  int to = 0;
  double part = 0.5;
};

struct SplitTets {
  /// Vertices keep their numbers; split k makes vertex n + k, where n is the old number of vertices. The
  /// pieces of a tetrahedron follow one another and keep its handedness.
  TetMesh mesh;
  std::vector<int> origin; ///< of each tetrahedron, the one that it is a piece of
  /// Of face f of tetrahedron t, at 4 t + f: the face of its origin that it lies in, or -1 inside.
  std::vector<int> face_of;
};

/// Throws `PreconditionError` if an edge is given twice, has no ends, or is not in the mesh. O(n log n).
SplitTets split_edges(const TetMesh& mesh, const std::vector<EdgePoint>& splits);

} // namespace tetrarch::solid
