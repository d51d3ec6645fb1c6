// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/tet_mesh.hpp"

#include "tetrarch/solid/face_sweep.hpp"
#include "tetrarch/solid/gluing.hpp"

namespace tetrarch::solid {

Triangulation triangulation_of(const TetMesh& mesh) {
  Triangulation tri(static_cast<int>(mesh.tetrahedra.size()));
  FaceSweep sweep(mesh.tetrahedra, mesh.points.size(), [](std::size_t) { return true; });
  sweep.for_each_class([&](std::span<const SortedFace> shared) {
    if (shared.size() == 2) glue_shared_face(tri, mesh.tetrahedra, shared[0].at(), shared[1].at());
  });
  return tri;
}

} // namespace tetrarch::solid
