// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Gluing two tetrahedra of a mesh along the face that they share.

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/solid/face_sweep.hpp"

namespace tetrarch::solid {

/// Glues f to g, faces of `tetrahedra` on the same three points, by the map that keeps the points.
inline void glue_shared_face(Triangulation& tri, const std::vector<std::array<int, 4>>& tetrahedra, TetFace f,
                             TetFace g) {
  const auto& from = tetrahedra[static_cast<std::size_t>(f.tet)];
  const auto& to = tetrahedra[static_cast<std::size_t>(g.tet)];
  std::array<int, 4> image{};
  for (int v = 0; v < 4; ++v) {
    image[v] = g.face; // unless it lies on the shared face
    for (int w = 0; w < 4; ++w)
      if (v != f.face && to[w] == from[v]) image[v] = w;
  }
  tri.glue(f, g.tet, Perm4(image[0], image[1], image[2], image[3]));
}

} // namespace tetrarch::solid
