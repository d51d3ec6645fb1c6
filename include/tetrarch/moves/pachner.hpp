// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Moves inside a triangulation, made in place: the Pachner moves 1-4, 4-1, 2-3, 3-2, the 4-4 move, and the
/// moves that press two tetrahedra flat or blow a pillow up.
///
///     2-0 edge     two tetrahedra around an edge of valence 2 become their two common outer sides
///     2-0 vertex   two tetrahedra around a vertex of degree 2 become one triangle
///     2-1          the tetrahedron folded around an edge of valence 1 melts into its neighbor
///     0-2          the inverse of the first (at an edge) and of the second (at a face)
///
/// Every function makes the move and returns nothing, or changes nothing and returns the reason;
/// `why_not_apply` in log.hpp only tests. All keep the manifold and its boundary. O(1) unless said otherwise.
/// Source: Pachner 1991; Matveev, "Algorithmic topology and classification of 3-manifolds", section 1.2.

#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <vector>

namespace tetrarch::moves {

[[nodiscard]] MaybeObstacle one_four(Complex& complex, int tet);
[[nodiscard]] MaybeObstacle four_one(Complex& complex, TetVertex v);
[[nodiscard]] MaybeObstacle two_three(Complex& complex, TetFace f);
[[nodiscard]] MaybeObstacle three_two(Complex& complex, DirectedTetEdge e);
/// The new axis joins the third vertex of the first tetrahedron to the one opposite (`axis` 0), or the two
/// others of the ring (1).
[[nodiscard]] MaybeObstacle four_four(Complex& complex, DirectedTetEdge e, int axis);

[[nodiscard]] MaybeObstacle two_zero_edge(Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle two_zero_vertex(Complex& complex, TetVertex v);
/// `e.from` is the end whose opposite face leads to the neighbor that takes the tetrahedron in: a 2-3 move
/// there and a 2-0 move.
[[nodiscard]] MaybeObstacle two_one(Complex& complex, DirectedTetEdge e);

/// Opens the complex along two triangles at the edge and blows two tetrahedra in: the left triangle of the
/// tetrahedron held by e, and the one `turn` left steps further; 0 < turn < valence. O(valence).
[[nodiscard]] MaybeObstacle zero_two_edge(Complex& complex, DirectedTetEdge e, int turn);
/// Opens the complex along a triangle and blows two tetrahedra with a common new vertex in.
[[nodiscard]] MaybeObstacle zero_two_face(Complex& complex, TetFace f);

// Asking.
[[nodiscard]] MaybeObstacle why_not_two_zero_edge(const Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle why_not_two_zero_vertex(const Complex& complex, TetVertex v);
[[nodiscard]] MaybeObstacle why_not_two_one(const Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle why_not_zero_two_edge(const Complex& complex, DirectedTetEdge e, int turn);
/// All turns for which there is no obstacle, increasing. O(valence), where asking about each takes its
/// square.
[[nodiscard]] std::vector<int> zero_two_turns(const Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle why_not_zero_two_face(const Complex& complex, TetFace f);

} // namespace tetrarch::moves
