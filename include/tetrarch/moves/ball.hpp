// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Replacing a ball of tetrahedra by another ball with the same boundary, as every Pachner move does.
///
/// Draw the ball on its own and number its corners 0, 1, 2, ... . Each tetrahedron of the triangulation
/// inside it is `Placed`: its vertex v sits at corner `corners[v]`. A filling lists the corners of the new
/// tetrahedra. Faces inside the ball are those that two tetrahedra share, by corners; the others form its
/// boundary, and the new boundary takes over the gluings of the old one, also where the ball is glued to
/// itself.
///
///     2-3: corners 0,1,2 of the shared face, apices 3 and 4;  {0123, 0124}  ->  {0134, 1234, 2034}
///     4-4: axis 4,5 and the ring 0,1,2,3 around it; the new axis is 0,2

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <array>
#include <boost/container/static_vector.hpp>
#include <variant>
#include <vector>

namespace tetrarch::moves {

using Corners = std::array<int, 4>;

/// A tetrahedron, and the corners of the ball at which its vertices sit.
struct Placed {
  int tet = -1;
  Corners corners{};
};

/// The two sides of a move: at most six corners, drawn as a simplicial complex.
struct Ball {
  boost::container::static_vector<Placed, 4> before;
  boost::container::static_vector<Corners, 4> after;
};

/// Replaces the ball in place: `last_change().new_tets` are in the order of the filling, vertex v at corner
/// after[k][v]. Throws PreconditionError, before anything is changed, if the two sides do not have the same
/// boundary. O(1).
void replace(Complex& complex, const Ball& ball);

/// The new triangulation, and how tetrahedra were renamed: image[t] of an old one (-1: removed). The new
/// tetrahedra are numbered from `first_new` on, in the order of the filling.
struct Replaced {
  Triangulation tri;
  std::vector<int> image;
  int first_new = 0;
};
/// The same of a triangulation that stays as it is. O(n).
Replaced replace(const Triangulation& tri, const Ball& ball);

/// A legal move, or the reason why it is illegal.
using BallOrObstacle = std::variant<Ball, Obstacle>;

// The makers below take a Triangulation or a Complex. O(1).

/// One tetrahedron makes room for four around a new vertex at corner 4; its vertices are corners 0..3.
template <class Gluings>
[[nodiscard]] BallOrObstacle one_four_ball(const Gluings& tri, int tet);

/// The four tetrahedra around a vertex, corner 4, make room for one with corners 0..3.
template <class Gluings>
[[nodiscard]] BallOrObstacle four_one_ball(const Gluings& tri, TetVertex v);

/// The two tetrahedra at face f make room for three around a new edge from corner 3 to corner 4. Vertex
/// f.face of f.tet is corner 3; the vertices of face f are corners 0,1,2 in increasing order.
template <class Gluings>
[[nodiscard]] BallOrObstacle two_three_ball(const Gluings& tri, TetFace f);

/// The three tetrahedra around the edge, corners 3 (from) and 4 (to), make room for two with the common face
/// 0,1,2.
template <class Gluings>
[[nodiscard]] BallOrObstacle three_two_ball(const Gluings& tri, DirectedTetEdge e);

/// The four tetrahedra around the edge, corners 4 (from) and 5 (to), are replaced by four around the edge
/// that joins two opposite corners of the ring 0,1,2,3; the third vertex of the first tetrahedron (the left
/// one when held by e) is corner 0. `axis` 0 joins corners 0 and 2, `axis` 1 joins 1 and 3.
template <class Gluings>
[[nodiscard]] BallOrObstacle four_four_ball(const Gluings& tri, DirectedTetEdge e, int axis);

} // namespace tetrarch::moves
