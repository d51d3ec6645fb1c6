// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The mutable form of a triangulation: gluings, together with the classes of edges and vertices, which
/// follow every change.
///
/// Tetrahedra live in slots that a move frees and reuses; a slot is one cache line of gluings and labels.
/// Classes are labels in union-find forests: a move that identifies two edges links two labels and touches no
/// tetrahedron for it, however large the classes. An id names its class until the class is absorbed by
/// another one (`edge`, `vertex` and `current` then give the other's id). Only the kind of a vertex link is
/// kept, which every move knows beforehand; `Skeleton` computes the whole link anew and serves as the audit.
///
/// Moves are free functions (merge.hpp, pachner.hpp, flat.hpp, boundary_moves.hpp, cone.hpp). Each asks
/// `why_not_...` first and then happens whole; `last_change()` describes the result. Cost: construction O(n),
/// about 80 bytes per tetrahedron. A look-up shortens the way to the root of a class, so threads must not
/// share even a const Complex.

#include "tetrarch/core/ids.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/core/walk.hpp"

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetrarch::moves {

/// The kind of a vertex link, as far as moves need it.
enum class LinkKind : std::uint8_t {
  sphere, ///< an interior vertex
  disk,   ///< a vertex on the real boundary
  closed, ///< an ideal (truncated) vertex: a closed surface that is no sphere
  bad     ///< has boundary and is no disk: the triangulation is no manifold there
};

/// What one move did. Slots and classes are named as after the move, except in the lists of what is gone.
struct Change {
  std::vector<int> removed_tets;
  std::vector<int> new_tets;
  std::vector<std::pair<VertexId, VertexId>> merged_vertices; ///< (gone, the one it is now part of)
  std::vector<std::pair<EdgeId, EdgeId>> merged_edges;
  std::vector<std::pair<VertexId, VertexId>> split_vertices; ///< (whole, the new part)
  std::vector<std::pair<EdgeId, EdgeId>> split_edges;
  std::vector<VertexId> removed_vertices;
  std::vector<EdgeId> removed_edges;
  std::vector<VertexId> new_vertices;
  std::vector<EdgeId> new_edges;
  /// Survivors with a face glued otherwise than before, some of them twice; a tetrahedron removed later in
  /// the same move may be among them.
  std::vector<int> touched_tets;

  void clear();
};

/// Walks around an edge; the usual valences need no heap.
using Ring = boost::container::small_vector<Walk, 32>;

/// The mutable form of a triangulation.
class Complex {
public:
  explicit Complex(const Triangulation& tri);

  /// Living tetrahedra, and the number of slots: 0 .. slot_count()-1, some of them empty.
  int size() const { return size_; }
  int slot_count() const { return static_cast<int>(tets_.size()); }
  bool is_alive(int tet) const { return tets_[index(tet)].vertex[0] >= 0; }
  int boundary_face_count() const { return boundary_faces_; }
  int vertex_count() const { return vertex_count_; }
  int edge_count() const { return edge_count_; }

  Gluing gluing(TetFace f) const {
    const Tet& t = tets_[index(f.tet)];
    return {t.across[f.face], t.perm[f.face]};
  }
  bool is_boundary(TetFace f) const { return tets_[index(f.tet)].across[f.face] < 0; }
  TetFace partner(TetFace f) const {
    const Gluing g = gluing(f);
    return {g.tet, g.perm[f.face]};
  }

  VertexId vertex(TetVertex v) const {
    return VertexId(root(vertices_, tets_[index(v.tet)].vertex[v.vertex]));
  }
  EdgeId edge(TetEdge e) const { return EdgeId(root(edges_, tets_[index(e.tet)].edge[e.edge])); }
  EdgeId edge(DirectedTetEdge e) const { return edge(TetEdge{e.tet, edge_number[e.from][e.to]}); }
  /// The class that an id of earlier has become part of.
  VertexId current(VertexId v) const { return VertexId(root(vertices_, v.value)); }
  EdgeId current(EdgeId e) const { return EdgeId(root(edges_, e.value)); }

  /// Every vertex id there is, with the class it is part of now (-1: the vertex is gone).
  Table<VertexId, VertexId> all_vertices() const;

  /// Of ids that are current. A valence counts t-edges, a degree t-vertices.
  LinkKind link(VertexId v) const { return vertices_[index(v.value)].link; }
  int degree(VertexId v) const { return vertices_[index(v.value)].size; }
  int valence(EdgeId e) const { return edges_[index(e.value)].size; }
  bool is_boundary(EdgeId e) const { return edges_[index(e.value)].boundary; }
  bool is_reversed(EdgeId e) const { return edges_[index(e.value)].reversed; }

  /// The tetrahedra around an edge, each held along `e`, each one a left step from the one before. A boundary
  /// edge starts with its right face on the boundary. Not for reversed edges. O(valence).
  Ring around(DirectedTetEdge e) const;

  /// The living tetrahedra in the order of their slots, and which slot became which tetrahedron (-1: none).
  struct Compact {
    Triangulation tri;
    std::vector<int> image;
  };
  Compact compact() const;
  Triangulation triangulation() const { return compact().tri; }

  /// Renumbers slots, edges and vertices from 0 in the order of slots, so that empty slots take no room;
  /// earlier ids get new names. O(slots + ids).
  struct Renaming {
    std::vector<int> tet;             ///< -1: an empty slot
    Table<VertexId, VertexId> vertex; ///< -1: gone; a merged vertex has the new name of what it is part of
    Table<EdgeId, EdgeId> edge;
  };
  Renaming pack();

  /// What the last move did.
  const Change& last_change() const { return change_; }

  // For moves: every one of these keeps sizes, counts and `last_change` true; that classes fit the gluings
  // once the move is done is the move's affair.

  void begin_change() { change_.clear(); }
  /// For a move made of two.
  void set_last_change(Change change) { change_ = std::move(change); }
  /// A tetrahedron with four free faces.
  int add_tet(const std::array<VertexId, 4>& vertices, const std::array<EdgeId, 6>& edges);
  /// Frees the slot; what was glued to it becomes boundary and counts as touched.
  void remove_tet(int tet);
  void glue(TetFace f, int other, Perm4 p);
  void unglue(TetFace f);
  VertexId add_vertex(LinkKind link);
  EdgeId add_edge(bool boundary);
  /// For classes that no tetrahedron has any more.
  void remove_vertex(VertexId v);
  void remove_edge(EdgeId e);
  /// Merges the two; the union lies on the boundary or is reversed if one of the two was.
  void merge_vertices(VertexId a, VertexId b, LinkKind link);
  void merge_edges(EdgeId a, EdgeId b);
  void relabel(TetVertex v, VertexId part);
  void relabel(TetEdge e, EdgeId part);
  void note_split(VertexId whole, VertexId part) { change_.split_vertices.emplace_back(whole, part); }
  void note_split(EdgeId whole, EdgeId part) { change_.split_edges.emplace_back(whole, part); }
  void set_link(VertexId v, LinkKind link) { vertices_[index(v.value)].link = link; }
  void set_boundary(EdgeId e, bool boundary) { edges_[index(e.value)].boundary = boundary; }

private:
  struct alignas(64) Tet {
    std::array<int, 4> across; ///< -1: boundary
    std::array<Perm4, 4> perm;
    std::array<int, 4> vertex; ///< -1 in an empty slot
    std::array<int, 6> edge;
  };
  static_assert(sizeof(Tet) == 64, "one cache line");
  struct VertexClass {
    mutable int parent;
    int size;
    LinkKind link;
  };
  struct EdgeClass {
    mutable int parent;
    int size : 30;
    bool boundary : 1;
    bool reversed : 1;
  };

  template <class Classes, class Names>
  static void rename_classes(Classes& classes, Names& names);
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  template <class Classes>
  static int root(const Classes& classes, int id) {
    while (classes[index(id)].parent != id) {
      const int up = classes[index(id)].parent;
      id = classes[index(id)].parent = classes[index(up)].parent;
    }
    return id;
  }
  template <class Classes>
  static std::pair<int, int> link_roots(Classes& classes, int a, int b);

  void part(TetFace f);
  void find_vertices();
  void find_edges();
  void label_edge(TetEdge first);
  void find_links();

  std::vector<Tet> tets_;
  std::vector<int> free_;
  std::vector<VertexClass> vertices_;
  std::vector<EdgeClass> edges_;
  int size_ = 0;
  int boundary_faces_ = 0;
  int vertex_count_ = 0;
  int edge_count_ = 0;
  Change change_;
};

} // namespace tetrarch::moves
