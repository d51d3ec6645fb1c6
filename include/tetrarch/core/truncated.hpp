// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The truncated view of a triangulation: every corner of every tetrahedron sliced off by a small triangle.
///
/// A truncated tetrahedron has four hexagonal faces, which are glued in pairs, and four triangular ones,
/// which make up the boundary and are glued to nothing. Its edges are those of the tetrahedron, shortened;
/// the sides of the triangles belong to no edge class. Laws: every hexagon has exactly two pre-images, every
/// edge at least one, and chi(boundary) = 2 (E - T). Source: Yin, section 4.2.1 ("truncated tetrahedral
/// meshes"), figure 4.2.

#include "tetrarch/core/skeleton.hpp"

#include <span>

namespace tetrarch {

/// A triangulation with its vertices sliced off.
class TruncatedTriangulation {
public:
  /// Truncates all vertices of a closed gluing. Throws PreconditionError if a face is on the boundary. O(n).
  explicit TruncatedTriangulation(Triangulation tri);

  const Triangulation& triangulation() const { return tri_; }
  const Skeleton& skeleton() const { return skeleton_; }

  int tetrahedron_count() const { return tri_.size(); }
  int hexagon_count() const { return skeleton_.face_count(); }
  int edge_count() const { return skeleton_.edge_count(); }
  int triangle_count() const { return 4 * tri_.size(); }

  /// phi_f and phi_e of the truncated mesh.
  FaceId hexagon(TetFace f) const { return skeleton_.face(f); }
  EdgeId edge(TetEdge e) const { return skeleton_.edge(e); }
  /// Exactly two.
  std::span<const TetFace> preimages(FaceId hexagon) const { return skeleton_.preimages(hexagon); }
  std::span<const Walk> preimages(EdgeId edge) const { return skeleton_.around(edge); }

  /// The boundary components: one for each vertex class, a sphere where the vertex was finite.
  int boundary_component_count() const { return skeleton_.vertex_count(); }
  VertexId boundary_component(TetVertex triangle) const { return skeleton_.vertex(triangle); }
  const SurfaceType& boundary_type(VertexId component) const { return skeleton_.link(component); }
  std::span<const TetVertex> triangles(VertexId component) const { return skeleton_.preimages(component); }
  /// Euler characteristic of the whole boundary; 2 (E - T) if no edge is reversed.
  int boundary_euler() const;

private:
  Triangulation tri_;
  Skeleton skeleton_;
};

} // namespace tetrarch
