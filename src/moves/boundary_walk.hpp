// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Walking on the boundary of a Complex, from triangle to triangle.

#include "tetrarch/moves/complex.hpp"

namespace tetrarch::moves {

/// The boundary triangle on the other side of an edge of a boundary triangle.
struct Beside {
  TetFace face;
  /// Takes the ends of the shared edge to themselves, the third corner to the third corner, and the t-vertex
  /// off the one triangle to the one off the other.
  Perm4 map;
};

/// Across the side of the boundary triangle f that lies opposite its corner `opposite`. O(valence).
inline Beside boundary_beside(const Complex& complex, TetFace f, int opposite) {
  std::array<int, 2> ends{};
  int k = 0;
  for (const int v : face_vertex[f.face])
    if (v != opposite) ends[k++] = v;
  const Walk start{f.tet, Perm4(ends[0], ends[1], f.face, opposite)};
  Walk w = start;
  while (w.step_left(complex)) {
  }
  return {w.left_face(), w.hold * Perm4::swap(2, 3) * start.hold.inverse()};
}

/// Whether two neighbouring boundary triangles make up their whole component, a sphere if all is well.
/// O(valence).
inline bool are_whole_component(const Complex& complex, TetFace first, TetFace second) {
  for (const TetFace f : {first, second})
    for (const int v : face_vertex[f.face]) {
      const TetFace next = boundary_beside(complex, f, v).face;
      if (next != first && next != second) return false;
    }
  return true;
}

} // namespace tetrarch::moves
