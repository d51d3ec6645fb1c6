// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The vertex merge of the dissertation: an edge shrinks to a point, and the tetrahedra around it are pressed
/// flat.
///
///     v2 ------ v1        The v2-to-v1 merge deletes the tetrahedra T_II that contain the edge, glues each
///      \  T_II  /         T_I across it to a T_III, and pulls the T_IV along by their corner at v2.
///       \      /
///         x  y            The text leaves out when this is legal. Here it is if
///
///   1. the ends differ, and one of them is an interior vertex (its link a sphere), or the edge lies on the
///      real boundary and both links are disks;
///   2. no tetrahedron contains the edge twice;
///   3. identifying, for each interior triangle (v1,v2,x) on the edge, v1x with v2x closes no circle of
///      edges, where all boundary edges and all reversed ones count as one; a boundary edge's component of
///      the boundary has more than two triangles;
///   4. identifying, for each T_II, its two faces that do not contain the edge closes no circle of faces,
///      where all boundary faces count as one.
///
/// Sufficient, not necessary. Then the manifold, its boundary and the types of all vertex links stay what
/// they were. T_II is read as "contains the edge": in a gluing a tetrahedron can meet both vertices without
/// that. Source: Yin, section 4.2.2, figures 4.5 and 4.6.

#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

namespace tetrarch::moves {

/// Why `e.from` cannot be merged into `e.to` along e. O(d log d) for an edge of valence d.
[[nodiscard]] MaybeObstacle why_not_merge(const Complex& complex, DirectedTetEdge e);

/// Merges e.from into e.to, or changes nothing and says why. O(d log d).
[[nodiscard]] MaybeObstacle merge(Complex& complex, DirectedTetEdge e);

/// The last resort if no merge is legal: pinching an edge from a finite vertex. The complex is opened along
/// the left triangle of the tetrahedron held by e, and two tetrahedra are blown in, one between the two sides
/// of the triangle, one folded into it, in which both ends of the edge are one point: two tetrahedra more,
/// one vertex less, the same manifold. The edge becomes a loop. Needs different ends, `e.from` or `e.to` an
/// interior vertex, and an interior triangle; nothing else. O(1). (The existence of a pinch by two tetrahedra
/// is folklore; a search through all cases found these two.)
[[nodiscard]] MaybeObstacle pinch(Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle why_not_pinch(const Complex& complex, DirectedTetEdge e);

/// The dissertation's four sets, each in increasing order.
struct MergeSets {
  std::vector<int> hosting;              ///< T_I: meet v1 but not v2, a face glued to T_II
  std::vector<int> deleted;              ///< T_II: contain the edge
  std::vector<int> deformed_at_faces;    ///< T_III: meet v2 but not v1, a face glued to T_II
  std::vector<int> deformed_at_vertices; ///< T_IV: the others that meet v2 but not v1
};
/// O(number of t-vertices at both ends).
MergeSets merge_sets(const Complex& complex, DirectedTetEdge e);

} // namespace tetrarch::moves
