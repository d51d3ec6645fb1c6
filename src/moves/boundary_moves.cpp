// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/boundary_moves.hpp"

#include "boundary_walk.hpp"

#include "tetrarch/core/error.hpp"

#include <set>

namespace tetrarch::moves {
namespace {

std::pair<int, int> other_corners(TetFace f, int corner) {
  std::array<int, 2> others{};
  int k = 0;
  for (const int v : face_vertex[f.face])
    if (v != corner) others[k++] = v;
  return {others[0], others[1]};
}

/// The corner of an interior triangle where its two boundary edges meet; -1 if it has not exactly two.
int spine_corner(const Complex& complex, TetFace f) {
  int corner = -1;
  int on_boundary = 0;
  for (const int v : face_vertex[f.face]) {
    const auto [i, j] = other_corners(f, v);
    if (complex.is_boundary(complex.edge(DirectedTetEdge{f.tet, i, j})))
      ++on_boundary;
    else
      corner = v;
  }
  return on_boundary == 2 ? corner : -1;
}

/// Gives the part of a boundary edge at this side of a triangle that was just opened a class of its own,
/// unless it is all that is left of the class.
void split_boundary_edge(Complex& complex, TetFace f, int a, int b) {
  const EdgeId whole = complex.edge(DirectedTetEdge{f.tet, a, b});
  // f lies to the right: walk left, to the other end.
  const Walk start{f.tet, Perm4(a, b, f.face, 6 - a - b - f.face)};
  int piece = 1;
  for (Walk w = start; w.step_left(complex);) ++piece;
  if (piece == complex.valence(whole)) return;
  const EdgeId part = complex.add_edge(true);
  complex.note_split(whole, part);
  Walk w = start;
  do complex.relabel(w.edge(), part);
  while (w.step_left(complex));
}

/// The same for a vertex: the part of its link on this side.
void split_vertex(Complex& complex, TetVertex at) {
  const VertexId whole = complex.vertex(at);
  const VertexId part = complex.add_vertex(LinkKind::disk);
  complex.note_split(whole, part);
  std::vector<TetVertex> pending{at};
  complex.relabel(at, part);
  while (!pending.empty()) {
    const TetVertex v = pending.back();
    pending.pop_back();
    for (int f = 0; f < 4; ++f) {
      const Gluing g = complex.gluing({v.tet, f});
      if (f == v.vertex || g.tet < 0 || complex.vertex({g.tet, g.perm[v.vertex]}) == part) continue;
      complex.relabel(TetVertex{g.tet, g.perm[v.vertex]}, part);
      pending.push_back({g.tet, g.perm[v.vertex]});
    }
  }
}

/// The two boundary triangles at a boundary edge and the map that folds the first onto the second.
struct Book {
  TetFace first;
  TetFace second;
  Perm4 fold;
};

MaybeObstacle plan_close(const Complex& complex, DirectedTetEdge e, Book& book) {
  const EdgeId edge = complex.edge(e);
  if (complex.is_reversed(edge)) return Obstacle::reversed_edge;
  if (!complex.is_boundary(edge)) return Obstacle::no_boundary_face;
  const Ring ring = complex.around(e);
  const Walk& right = ring.front();
  const Walk& left = ring.back();
  book = {right.right_face(), left.left_face(), left.hold * Perm4::swap(2, 3) * right.hold.inverse()};
  if (book.first == book.second) return Obstacle::same_face;
  const VertexId one = complex.vertex({right.tet, right.hold[3]});
  const VertexId two = complex.vertex({left.tet, left.hold[2]});
  if (one == two) return Obstacle::same_ends;
  if (complex.link(one) != LinkKind::disk || complex.link(two) != LinkKind::disk) return Obstacle::bad_vertex;
  if (are_whole_component(complex, book.first, book.second)) return Obstacle::small_boundary_component;
  return std::nullopt;
}

/// The free faces of a tetrahedron, as a list.
std::vector<int> free_faces(const Complex& complex, int tet) {
  std::vector<int> faces;
  for (int f = 0; f < 4; ++f)
    if (complex.is_boundary({tet, f})) faces.push_back(f);
  return faces;
}

bool glued_to_itself(const Complex& complex, int tet) {
  for (int f = 0; f < 4; ++f)
    if (complex.gluing({tet, f}).tet == tet) return true;
  return false;
}

} // namespace

MaybeObstacle why_not_open_book(const Complex& complex, TetFace f) {
  if (complex.is_boundary(f)) return Obstacle::boundary_face;
  const int corner = spine_corner(complex, f);
  if (corner < 0) return Obstacle::no_boundary_face;
  const auto [i, j] = other_corners(f, corner);
  if (complex.is_reversed(complex.edge(DirectedTetEdge{f.tet, i, j}))) return Obstacle::reversed_edge;
  if (complex.link(complex.vertex({f.tet, corner})) != LinkKind::disk) return Obstacle::bad_vertex;
  return std::nullopt;
}

MaybeObstacle open_book(Complex& complex, TetFace f) {
  if (const auto obstacle = why_not_open_book(complex, f)) return obstacle;
  complex.begin_change();
  const int corner = spine_corner(complex, f);
  const auto [i, j] = other_corners(f, corner);
  const Gluing g = complex.gluing(f);
  const TetFace far = complex.partner(f);
  complex.set_boundary(complex.edge(DirectedTetEdge{f.tet, i, j}), true);
  complex.unglue(f);
  // The two edges may be one class, which falls into three parts: so every side is asked.
  for (const int v : {i, j}) {
    split_boundary_edge(complex, f, corner, v);
    split_boundary_edge(complex, far, g.perm[corner], g.perm[v]);
  }
  split_vertex(complex, {f.tet, corner});
  return std::nullopt;
}

MaybeObstacle why_not_close_book(const Complex& complex, DirectedTetEdge e) {
  Book book;
  return plan_close(complex, e, book);
}

MaybeObstacle close_book(Complex& complex, DirectedTetEdge e) {
  Book book;
  if (const auto obstacle = plan_close(complex, e, book)) return obstacle;
  const Walk right = complex.around(e).front();
  const int apex = right.hold[3];
  const VertexId one = complex.vertex({right.tet, apex});
  const VertexId two = complex.vertex({book.second.tet, book.fold[apex]});
  complex.begin_change();
  complex.set_boundary(complex.edge(e), false);
  for (const int end : {right.hold[0], right.hold[1]}) {
    const EdgeId a = complex.edge(DirectedTetEdge{right.tet, apex, end});
    const EdgeId b = complex.edge(DirectedTetEdge{book.second.tet, book.fold[apex], book.fold[end]});
    if (a != b) complex.merge_edges(a, b);
  }
  complex.merge_vertices(one, two, LinkKind::disk);
  complex.glue(book.first, book.second.tet, book.fold);
  return std::nullopt;
}

MaybeObstacle why_not_shell(const Complex& complex, int tet) {
  const std::vector<int> free = free_faces(complex, tet);
  if (free.empty()) return Obstacle::no_boundary_face;
  if (free.size() == 4) return Obstacle::small_boundary_component;
  if (glued_to_itself(complex, tet)) return Obstacle::repeated_tetrahedron;
  if (free.size() == 2) {
    // The edge away from the two free faces becomes boundary.
    const EdgeId opened = complex.edge(DirectedTetEdge{tet, free[0], free[1]});
    if (complex.is_boundary(opened)) return Obstacle::boundary_face;
    if (complex.is_reversed(opened)) return Obstacle::reversed_edge;
  }
  if (free.size() == 1) {
    const int apex = free[0];
    if (complex.link(complex.vertex({tet, apex})) != LinkKind::sphere) return Obstacle::bad_vertex;
    std::set<EdgeId> spokes;
    for (const int v : face_vertex[apex]) {
      const EdgeId spoke = complex.edge(DirectedTetEdge{tet, apex, v});
      if (complex.is_reversed(spoke)) return Obstacle::reversed_edge;
      spokes.insert(spoke);
    }
    if (spokes.size() != 3) return Obstacle::edges_form_cycle;
  }
  return std::nullopt;
}

MaybeObstacle shell(Complex& complex, int tet) {
  if (const auto obstacle = why_not_shell(complex, tet)) return obstacle;
  complex.begin_change();
  const std::vector<int> free = free_faces(complex, tet);
  std::array<VertexId, 4> vertices;
  std::array<EdgeId, 6> edges;
  for (int v = 0; v < 4; ++v) vertices[v] = complex.vertex({tet, v});
  for (int e = 0; e < 6; ++e) edges[e] = complex.edge(TetEdge{tet, e});
  complex.remove_tet(tet);
  // An edge between two free faces goes, and with three of them the vertex between; the others that were
  // inside come to lie on the boundary.
  for (int e = 0; e < 6; ++e) {
    if (complex.valence(edges[e]) == 0)
      complex.remove_edge(edges[e]);
    else
      complex.set_boundary(edges[e], true);
  }
  for (const VertexId v : vertices) {
    if (complex.degree(v) == 0)
      complex.remove_vertex(v);
    else if (complex.link(v) == LinkKind::sphere)
      complex.set_link(v, LinkKind::disk);
  }
  return std::nullopt;
}

} // namespace tetrarch::moves
