// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/boundary.hpp"

namespace tetrarch {
BoundarySurface boundary_surface(const Triangulation& tri, const Skeleton& skeleton) {
  skeleton.require_current(tri);
  BoundarySurface out;
  Table<FaceId, int> triangle(skeleton.face_count(), -1);
  for (const FaceId f : all<FaceId>(skeleton.face_count())) {
    if (!skeleton.is_boundary(f)) continue;
    triangle[f] = static_cast<int>(out.faces.size());
    out.faces.push_back(skeleton.preimages(f)[0]);
  }
  out.surface = TriangulatedSurface(static_cast<int>(out.faces.size()));
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (!skeleton.is_boundary(e)) continue;
    const Walk first = skeleton.around(e).front();
    const Walk last = skeleton.around(e).back();
    const TetFace right = first.right_face();
    const TetFace left = last.left_face();
    std::array<int, 3> corner{};
    corner[face_corner(right.face, first.hold[0])] = face_corner(left.face, last.hold[0]);
    corner[face_corner(right.face, first.hold[1])] = face_corner(left.face, last.hold[1]);
    corner[face_corner(right.face, first.hold[3])] = face_corner(left.face, last.hold[2]);
    out.surface.glue(triangle[skeleton.face(right)], face_corner(right.face, first.hold[3]),
                     triangle[skeleton.face(left)], corner);
  }
  return out;
}

std::vector<BoundaryComponent> boundary_components(const Triangulation& tri, const Skeleton& skeleton) {
  const BoundarySurface boundary = boundary_surface(tri, skeleton);
  const SurfaceComponents parts = classify(boundary.surface);
  std::vector<BoundaryComponent> out;
  for (const SurfaceType& type : parts.type)
    out.push_back({BoundaryComponent::Kind::real, type, VertexId(), {}});
  for (std::size_t k = 0; k < boundary.faces.size(); ++k) out[parts.of[k]].faces.push_back(boundary.faces[k]);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.is_ideal(v)) out.push_back({BoundaryComponent::Kind::ideal, skeleton.link(v), v, {}});
  return out;
}

} // namespace tetrarch
