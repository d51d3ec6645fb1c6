// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Drilling: the exterior of a set K of edges of a triangulation.
///
/// Two constructions, each a witness of the other. *Crushing* shrinks every component of K to a point, which
/// becomes an ideal vertex: a tetrahedron on an edge of K is pressed flat, so that fewer are left than there
/// were. It is legal where no tetrahedron has two edges of K and no circle of faces or of edges would close
/// up, the same conditions as of a vertex merge (merge.hpp), which shrinks one edge; then what shrinks to a
/// point outside K is a tree, and the quotient is the same manifold (a cell-like map).
///
/// *Cutting* always works. Near K every simplex is divided by its center (vertices excepted), which leaves
/// flags of positions 0 = vertex, 1 = edge, 2 = face, 3 = tetrahedron; faces away from K stay whole. A flag
/// meets K in nothing, in its vertex or in its edge. With x_i its corners and m_ij the middles between them:
///
///     in the vertex   (x1 x2 x3 m03) (x1 x2 m02 m03) (x1 m01 m02 m03)
///     in the edge     (x2 x3 m03 m13) (x2 m02 m03 m13) (x2 m02 m12 m13)
///
/// Every quadrilateral has the diagonal that starts at x_i of smaller i, so that neighbors agree. The new
/// boundary is real. Tetrahedra that do not touch K stay as they are.
///
/// K may touch the boundary and contain ideal vertices: an arc that ends there is a tunnel.

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/obstacle.hpp"
#include "tetrarch/moves/subdivide.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace tetrarch::moves {

/// By crushing; or why not. `edges` says of each edge class whether it is drilled. The exterior of a tree is
/// that of a point: the vertex that it becomes is finite, and a ball is left where the tree was. Throws
/// PreconditionError for a stale skeleton. O(n).
[[nodiscard]] std::variant<Triangulation, Obstacle>
crushed(const Triangulation& tri, const Skeleton& skeleton, const Table<EdgeId, bool>& edges);

/// What cutting gives.
struct CutOut {
  Triangulation tri;
  std::vector<int> origin; ///< the tetrahedron of before that each one lies in
  /// For each drilled edge, in the order of classes, a closed path of edges on the new boundary that runs
  /// once round it: its meridian. Each entry ends where the next one starts, up to gluing.
  std::vector<std::vector<DirectedTetEdge>> meridians;
};
/// By cutting. At most 72 pieces for each tetrahedron that touches K. A meridian is given for interior edges;
/// it is empty for an edge on the real boundary. Throws PreconditionError for a stale skeleton, or if a
/// drilled edge is reversed. O(n).
[[nodiscard]] CutOut cut_out(const Triangulation& tri, const Skeleton& skeleton,
                             const Table<EdgeId, bool>& edges);

/// Balls round vertices cut out, and what is left of some edges.
struct Punctured {
  Triangulation tri; ///< a real boundary component in place of each vertex: its link, subdivided
  /// The edges that the given ones have become, one t-edge of each.
  std::vector<TetEdge> edges;
};
/// Cuts vertices out as above, and follows edges (none of which is drilled). Where an edge ended at such a
/// vertex it now ends at the boundary. Throws PreconditionError for a stale skeleton. O(n).
[[nodiscard]] Punctured punctured(const Triangulation& tri, const Skeleton& skeleton,
                                  const Table<VertexId, bool>& vertices, const Table<EdgeId, bool>& followed);

/// Two copies, glued along their real boundary: tetrahedron t of the second is n + t. O(n).
[[nodiscard]] Triangulation doubled(const Triangulation& tri);

/// By crushing where that is legal, else by cutting: with ideal or with real boundary.
struct Drilling {
  Triangulation tri;
  bool crushed = false;
};
[[nodiscard]] Drilling drill(const Triangulation& tri, const Skeleton& skeleton,
                             const Table<EdgeId, bool>& edges);

} // namespace tetrarch::moves
