// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The identification functions phi_f, phi_e, phi_v of the dissertation (section 4.2.1), with their
/// pre-images.
///
/// A `Skeleton` is an immutable value computed once from a triangulation. It remembers the revision of this
/// triangulation. A function that takes both calls `require_current`, so a stale skeleton is an error at
/// once. Classes are numbered by their first local simplex in the order of (tetrahedron, local number). Cost:
/// O(n) time, about 200 bytes per tetrahedron.

#include "tetrarch/core/ids.hpp"
#include "tetrarch/core/surface.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/core/walk.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetrarch {

/// The classes of faces, edges and vertices, with their pre-images.
class Skeleton {
public:
  explicit Skeleton(const Triangulation& tri);

  int tetrahedron_count() const { return tets_; }
  int face_count() const { return static_cast<int>(faces_.size()); }
  int edge_count() const { return static_cast<int>(edge_start_.size()) - 1; }
  int vertex_count() const { return static_cast<int>(vertex_start_.size()) - 1; }

  /// phi_f, phi_e, phi_v.
  FaceId face(TetFace f) const { return FaceId(face_of_[index(f.tet, 4) + f.face]); }
  EdgeId edge(TetEdge e) const { return EdgeId(edge_of_[index(e.tet, 6) + e.edge] / 2); }
  VertexId vertex(TetVertex v) const { return VertexId(vertex_of_[index(v.tet, 4) + v.vertex]); }

  /// Each edge class has the direction of its first walk. True if e runs along it; for a reversed class, the
  /// answer of one of the two readings.
  bool runs_along(DirectedTetEdge e) const {
    const int code = edge_of_[index(e.tet, 6) + edge_number[e.from][e.to]];
    return (code % 2 == 0) == (e.from < e.to);
  }

  /// The one or two t-faces of a face.
  std::span<const TetFace> preimages(FaceId f) const;
  /// The t-edges of an edge in cyclic order, each held along the class's direction, each next one a left step
  /// away. A boundary edge starts with its right face on the boundary and ends with its left face on the
  /// boundary.
  std::span<const Walk> around(EdgeId e) const;
  std::span<const TetVertex> preimages(VertexId v) const;

  int valence(EdgeId e) const { return static_cast<int>(around(e).size()); }
  /// The vertices at the start and at the end of the class's direction.
  std::pair<VertexId, VertexId> ends(EdgeId e) const;
  bool is_boundary(FaceId f) const { return preimages(f).size() == 1; }
  bool is_boundary(EdgeId e) const { return edge_flags_[e.value] & boundary_flag; }
  /// The edge is identified with itself backwards: the triangulation is no manifold there.
  bool is_reversed(EdgeId e) const { return edge_flags_[e.value] & reversed_flag; }
  bool is_boundary(VertexId v) const { return link(v).boundary_curves > 0; }
  /// The type of the vertex link. Found by counting; `vertex_link` builds the surface, an independent route.
  const SurfaceType& link(VertexId v) const { return links_[v.value]; }
  /// A closed link that is no sphere.
  bool is_ideal(VertexId v) const { return link(v).is_closed() && !link(v).is_sphere(); }

  bool is_orientable() const { return orientable_; }
  bool is_connected() const { return component_count_ <= 1; }
  int component_count() const { return component_count_; }
  bool has_boundary_faces() const { return boundary_faces_ > 0; }
  int boundary_face_count() const { return boundary_faces_; }

  /// Throws PreconditionError unless this is the skeleton of `tri` as it is now. O(1).
  void require_current(const Triangulation& tri) const;

private:
  static constexpr std::uint8_t boundary_flag = 1;
  static constexpr std::uint8_t reversed_flag = 2;
  static std::size_t index(int tet, int width) { return static_cast<std::size_t>(tet) * width; }

  void find_components(const Triangulation& tri);
  void find_faces(const Triangulation& tri);
  void find_edges(const Triangulation& tri);
  void add_edge(const Triangulation& tri, TetEdge first);
  void append_walk(const Walk& w);
  void find_vertices(const Triangulation& tri);
  void flood_link(const Triangulation& tri);
  void count_edge_ends();
  void count_boundary_curves();
  int edge_end(TetVertex at, int towards) const;

  int tets_;
  std::uint64_t revision_;
  std::vector<int> face_of_;
  std::vector<int> edge_of_; ///< 2 * class + (0 if the t-edge from its smaller vertex runs along, else 1)
  std::vector<int> vertex_of_;
  std::vector<std::array<TetFace, 2>> faces_; ///< the second one with tet -1 on the boundary
  std::vector<int> edge_start_;
  std::vector<Walk> edge_walks_;
  std::vector<std::uint8_t> edge_flags_;
  std::vector<int> vertex_start_;
  std::vector<TetVertex> vertex_preimages_;
  std::vector<SurfaceType> links_;
  int boundary_faces_ = 0;
  int component_count_ = 0;
  bool orientable_ = true;
};

/// The link of v: triangle k sits at t-vertex `skeleton.preimages(v)[k]`; its corner c lies on the t-edge to
/// the c-th of the other three t-vertices (in increasing order), its side c in the face opposite that
/// t-vertex. O(k log k) for k triangles.
TriangulatedSurface vertex_link(const Triangulation& tri, const Skeleton& skeleton, VertexId v);

} // namespace tetrarch
