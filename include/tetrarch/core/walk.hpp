// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A tetrahedron held in the hand, and a step into the next one.
///
/// Hold a tetrahedron by the edge from hold[0] to hold[1], with hold[2] to the left and hold[3] to the right.
/// The left face contains hold[0], hold[1], hold[2] (so it lies opposite hold[3]); the right face contains
/// hold[3]. Stepping left crosses the left face: what was to the left becomes the right. Law: `step_left`
/// then `step_right` changes nothing, and stepping left until home visits the t-edges around the edge in
/// cyclic order.

#include "tetrarch/core/triangulation.hpp"

namespace tetrarch {

/// A tetrahedron held in the hand.
struct Walk {
  int tet = -1;
  Perm4 hold;

  int from() const { return hold[0]; }
  int to() const { return hold[1]; }
  TetEdge edge() const { return {tet, edge_number[hold[0]][hold[1]]}; }
  TetFace left_face() const { return {tet, hold[3]}; }
  TetFace right_face() const { return {tet, hold[2]}; }

  /// False, and nothing happens, if the left face is on the boundary. `tri` is whatever knows its gluings: a
  /// Triangulation, or a moves::Complex.
  template <class Gluings>
  bool step_left(const Gluings& tri) {
    return cross(tri, left_face());
  }
  template <class Gluings>
  bool step_right(const Gluings& tri) {
    return cross(tri, right_face());
  }

  friend constexpr bool operator==(Walk, Walk) = default;

private:
  template <class Gluings>
  bool cross(const Gluings& tri, TetFace f) {
    const Gluing g = tri.gluing(f);
    if (g.tet < 0) return false;
    *this = {g.tet, g.perm * hold * Perm4::swap(2, 3)};
    return true;
  }
};

} // namespace tetrarch
