// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/tet_mesh.hpp"

#include "face_sweep.hpp"
#include "findings.hpp"
#include "gluing.hpp"

namespace tetrarch::mesh {
namespace {

/// Duplicates can be repaired, but a mesh cannot have them.
bool keeps_from_meshing(Kind kind) {
  return (severity_of(kind) == Severity::fatal && kind != Kind::non_manifold_vertex) ||
         kind == Kind::duplicate;
}

} // namespace

TetMesh build(format::Soup soup) {
  const Report report = validate(soup, 1);
  return build(std::move(soup), report);
}

TetMesh build(format::Soup soup, const Report& report) {
  refuse(soup, report, keeps_from_meshing);
  refuse(
      soup, report, [](Kind kind) { return kind == Kind::non_manifold_vertex; }, "; --repair splits it");
  return {std::move(soup.points), std::move(soup.tetrahedra)};
}

Triangulation triangulation_of(const TetMesh& mesh) {
  Triangulation tri(static_cast<int>(mesh.tetrahedra.size()));
  FaceSweep sweep(mesh.tetrahedra, mesh.points.size(), [](std::size_t) { return true; });
  sweep.for_each_class([&](std::span<const SortedFace> shared) {
    if (shared.size() == 2) glue_shared_face(tri, mesh.tetrahedra, shared[0].at(), shared[1].at());
  });
  return tri;
}

} // namespace tetrarch::mesh
