// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Moves at the real boundary; all keep the manifold.
///
///     open    unglues an interior triangle that has exactly two edges on the boundary, like a book lying on
///             its two outer edges; the boundary gains two triangles
///     close   the inverse: folds the two boundary triangles at a boundary edge onto one another
///     shell   takes a tetrahedron away that meets the boundary in one, two or three faces
///     cone    closes a whole boundary component by a cone to one new vertex: step [2] of the conversion of
///             section 4.2.2
///
/// Source: Yin, section 4.2.2; the first three are folklore.

#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

namespace tetrarch::moves {

/// O(degree of the vertex where the two boundary edges meet).
[[nodiscard]] MaybeObstacle open_book(Complex& complex, TetFace f);
/// O(valence).
[[nodiscard]] MaybeObstacle close_book(Complex& complex, DirectedTetEdge e);
/// O(1).
[[nodiscard]] MaybeObstacle shell(Complex& complex, int tet);

[[nodiscard]] MaybeObstacle why_not_open_book(const Complex& complex, TetFace f);
[[nodiscard]] MaybeObstacle why_not_close_book(const Complex& complex, DirectedTetEdge e);
[[nodiscard]] MaybeObstacle why_not_shell(const Complex& complex, int tet);

/// The boundary triangles by component, components and triangles in the order of slots. O(n + sum of the
/// valences of boundary edges).
std::vector<std::vector<TetFace>> boundary_faces(const Complex& complex);

/// Cones the component that these triangles make up, one tetrahedron on each, triangle k on tetrahedron
/// `last_change().new_tets[k]`; the new vertex is `last_change().new_vertices[0]`: finite on a sphere, else
/// ideal. Refused if a vertex link is no disk. Throws PreconditionError if the triangles are not a whole
/// component. O(sum of the valences of the boundary edges).
[[nodiscard]] MaybeObstacle cone(Complex& complex, const std::vector<TetFace>& component);
[[nodiscard]] MaybeObstacle why_not_cone(const Complex& complex, const std::vector<TetFace>& component);

} // namespace tetrarch::moves
