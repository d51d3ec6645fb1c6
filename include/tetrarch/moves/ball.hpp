// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Replacing a ball of tetrahedra by another ball with the same boundary: what every Pachner move is.
///
/// Draw the ball on its own and number its corners 0, 1, 2, ... . Each tetrahedron of the triangulation
/// inside it is `Placed`: its vertex v sits at corner `corners[v]`. A filling lists the corners of the new
/// tetrahedra. Faces inside the ball are those that two tetrahedra share, by corners; the others form its
/// boundary, and the new boundary takes over the gluings of the old one, also where the ball is glued to
/// itself.
///
///     2-3: corners 0,1,2 of the shared face, apices 3 and 4;  {0123, 0124}  ->  {0134, 1234, 2034}
///     4-4: axis 4,5 and the ring 0,1,2,3 around it; the new axis is 0,2

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <variant>
#include <vector>

namespace tetrarch::moves {

using Corners = std::array<int, 4>;

struct Placed {
  int tet = -1;
  Corners corners{};
};

/// The two sides of a move.
struct Ball {
  std::vector<Placed> before;
  std::vector<Corners> after;
};

/// The new triangulation, and how tetrahedra were renamed: image[t] of an old one (-1: removed). The new
/// tetrahedra are numbered from `first_new` on, in the order of the filling, vertex v at corner after[k][v].
struct Replaced {
  Triangulation tri;
  std::vector<int> image;
  int first_new = 0;
};

/// Replaces the ball. Throws PreconditionError if the two sides do not have the same boundary. O(n).
Replaced replace(const Triangulation& tri, const Ball& ball);

/// Why a move cannot be made.
enum class Obstacle {
  boundary_face,       ///< the face or the edge lies on the boundary
  wrong_valence,       ///< the edge does not have the valence that the move needs
  repeated_tetrahedron ///< one tetrahedron would be needed twice
};
const char* to_string(Obstacle obstacle);

/// A move that can be made, or the reason why not.
using BallOrObstacle = std::variant<Ball, Obstacle>;

/// The two tetrahedra at face f make room for three around a new edge from corner 3 to corner 4. Vertex
/// f.face of f.tet is corner 3; the vertices of face f are corners 0,1,2 in increasing order. O(1).
[[nodiscard]] BallOrObstacle two_three(const Triangulation& tri, TetFace f);

/// The three tetrahedra around the edge, corners 3 (from) and 4 (to), make room for two with the common face
/// 0,1,2. O(1).
[[nodiscard]] BallOrObstacle three_two(const Triangulation& tri, DirectedTetEdge e);

/// The four tetrahedra around the edge, corners 4 (from) and 5 (to), are replaced by four around the edge
/// that joins two opposite corners of the ring 0,1,2,3; the third vertex of the first tetrahedron (the left
/// one when held by e) is corner 0. `axis` 0 joins corners 0 and 2, `axis` 1 joins 1 and 3. O(1).
[[nodiscard]] BallOrObstacle four_four(const Triangulation& tri, DirectedTetEdge e, int axis);

} // namespace tetrarch::moves
