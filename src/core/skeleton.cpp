// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/skeleton.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <numeric>

namespace tetrarch {
Skeleton::Skeleton(const Triangulation& tri) : tets_(tri.size()), revision_(tri.revision()) {
  find_components(tri);
  find_faces(tri);
  find_edges(tri);
  find_vertices(tri);
  count_edge_ends();
  if (boundary_faces_ > 0) count_boundary_curves();
}

void Skeleton::require_current(const Triangulation& tri) const {
  if (tri.revision() != revision_)
    throw PreconditionError("stale skeleton: the triangulation was changed after the skeleton was computed");
}

std::span<const TetFace> Skeleton::preimages(FaceId f) const {
  const auto& side = faces_[f.value];
  return {side.data(), side[1].tet < 0 ? 1U : 2U};
}

std::span<const Walk> Skeleton::around(EdgeId e) const {
  const Walk* data = edge_walks_.data();
  return {data + edge_start_[e.value], data + edge_start_[e.value + 1]};
}

std::span<const TetVertex> Skeleton::preimages(VertexId v) const {
  const TetVertex* data = vertex_preimages_.data();
  return {data + vertex_start_[v.value], data + vertex_start_[v.value + 1]};
}

std::pair<VertexId, VertexId> Skeleton::ends(EdgeId e) const {
  const Walk& w = edge_walks_[edge_start_[e.value]];
  return {vertex({w.tet, w.from()}), vertex({w.tet, w.to()})};
}

/// Counts components and tries to orient them, in one flood (`components` and `orientation` would be two).
/// Breadth first: a front keeps to tetrahedra that are near each other in memory too, a stack does not.
void Skeleton::find_components(const Triangulation& tri) {
  std::vector<std::int8_t> sign(index(tets_, 1), 0);
  std::vector<int> queue;
  queue.reserve(sign.size());
  for (int root = 0; root < tets_; ++root) {
    if (sign[root] != 0) continue;
    ++component_count_;
    sign[root] = 1;
    queue.push_back(root);
    for (std::size_t next = queue.size() - 1; next < queue.size(); ++next) {
      const int t = queue[next];
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri.gluing({t, f});
        if (g.tet < 0) continue;
        const int wanted = -g.perm.sign() * sign[t];
        if (sign[g.tet] == 0) {
          sign[g.tet] = static_cast<std::int8_t>(wanted);
          queue.push_back(g.tet);
        } else if (sign[g.tet] != wanted) {
          orientable_ = false;
        }
      }
    }
  }
}

void Skeleton::find_faces(const Triangulation& tri) {
  face_of_.assign(index(tets_, 4), -1);
  faces_.reserve(index(tets_, 2) + 16);
  for (int t = 0; t < tets_; ++t) {
    for (int f = 0; f < 4; ++f) {
      if (face_of_[index(t, 4) + f] >= 0) continue;
      const int id = static_cast<int>(faces_.size());
      face_of_[index(t, 4) + f] = id;
      if (tri.is_boundary({t, f})) {
        faces_.push_back({TetFace{t, f}, TetFace{}});
        ++boundary_faces_;
        continue;
      }
      const TetFace g = tri.partner({t, f});
      face_of_[index(g.tet, 4) + g.face] = id;
      faces_.push_back({TetFace{t, f}, g});
    }
  }
}

void Skeleton::find_edges(const Triangulation& tri) {
  edge_of_.assign(index(tets_, 6), -1);
  edge_walks_.reserve(index(tets_, 6));
  edge_start_.assign(1, 0);
  for (int t = 0; t < tets_; ++t)
    for (int e = 0; e < 6; ++e)
      if (edge_of_[index(t, 6) + e] < 0) add_edge(tri, {t, e});
}

/// Walks left until home or the boundary; from the boundary, what lies to the right of the start is walked
/// too and put in front. On the way home a class that is identified with itself backwards shows itself: the
/// first t-edge is met with its ends exchanged.
void Skeleton::add_edge(const Triangulation& tri, TetEdge first) {
  const auto [a, b] = edge_vertex[first.edge];
  const Walk start{first.tet, edge_frame(a, b)};
  std::uint8_t flags = 0;
  Walk w = start;
  bool glued = true;
  do {
    append_walk(w);
    glued = w.step_left(tri);
  } while (glued && w.edge() != first);
  if (!glued) {
    flags = boundary_flag;
    const std::size_t begin = static_cast<std::size_t>(edge_start_.back());
    const std::size_t middle = edge_walks_.size();
    for (w = start; w.step_right(tri);) append_walk(w);
    std::reverse(edge_walks_.begin() + begin, edge_walks_.begin() + middle);
    std::reverse(edge_walks_.begin() + begin, edge_walks_.end());
  } else if (w.from() != a) {
    flags = reversed_flag;
  }
  edge_flags_.push_back(flags);
  edge_start_.push_back(static_cast<int>(edge_walks_.size()));
}

/// Adds a t-edge to the class under construction.
void Skeleton::append_walk(const Walk& w) {
  const int id = static_cast<int>(edge_flags_.size());
  edge_of_[index(w.tet, 6) + w.edge().edge] = 2 * id + (w.from() < w.to() ? 0 : 1);
  edge_walks_.push_back(w);
}

void Skeleton::find_vertices(const Triangulation& tri) {
  vertex_of_.assign(index(tets_, 4), -1);
  vertex_preimages_.reserve(index(tets_, 4));
  vertex_start_.assign(1, 0);
  for (int t = 0; t < tets_; ++t) {
    for (int v = 0; v < 4; ++v) {
      if (vertex_of_[index(t, 4) + v] >= 0) continue;
      const int id = static_cast<int>(links_.size());
      vertex_of_[index(t, 4) + v] = 2 * id;
      vertex_preimages_.push_back({t, v});
      flood_link(tri);
      vertex_start_.push_back(static_cast<int>(vertex_preimages_.size()));
    }
  }
  for (int& code : vertex_of_) code /= 2;
}

/// Floods the link of the last t-vertex found, orients it on the way and counts its triangles and sides.
/// While the flood lasts, `vertex_of_` holds 2 * class + (0 or 1: a turning sense of the triangle): one place
/// in memory to look up instead of two. An odd gluing carries a sense along, because a triangle's own sense
/// is its tetrahedron's handedness.
void Skeleton::flood_link(const Triangulation& tri) {
  SurfaceType link{0, 0, true};
  const std::size_t first = vertex_preimages_.size() - 1;
  int sides = 0; // a glued side is met twice, a boundary side counts as two at once
  std::size_t next = first;
  for (; next < vertex_preimages_.size(); ++next) {
    const TetVertex at = vertex_preimages_[next];
    const int here = vertex_of_[index(at.tet, 4) + at.vertex];
    for (int f = 0; f < 4; ++f) {
      if (f == at.vertex) continue;
      const Gluing g = tri.gluing({at.tet, f});
      sides += g.tet < 0 ? 2 : 1;
      if (g.tet < 0) continue;
      const int wanted = here ^ (g.perm.sign() < 0 ? 0 : 1);
      int& there = vertex_of_[index(g.tet, 4) + g.perm[at.vertex]];
      if (there < 0) {
        there = wanted;
        vertex_preimages_.push_back({g.tet, g.perm[at.vertex]});
      } else if (there != wanted) {
        link.orientable = false;
      }
    }
  }
  link.euler = static_cast<int>(next - first) - sides / 2;
  links_.push_back(link);
}

/// The vertices of the links are the ends of edge classes; a reversed edge has one end only.
void Skeleton::count_edge_ends() {
  for (const EdgeId e : all<EdgeId>(edge_count())) {
    const auto [p, q] = ends(e);
    ++links_[p.value].euler;
    if (!is_reversed(e)) ++links_[q.value].euler;
  }
}

/// A number for the end, at t-vertex `at`, of the edge class that leads `towards` there: the vertices of all
/// links.
int Skeleton::edge_end(TetVertex at, int towards) const {
  const EdgeId e = edge({at.tet, edge_number[at.vertex][towards]});
  if (is_reversed(e)) return 2 * e.value;
  return 2 * e.value + (runs_along({at.tet, at.vertex, towards}) ? 0 : 1);
}

/// The corners of boundary faces are the boundary sides of links; joined at their ends they make the curves.
void Skeleton::count_boundary_curves() {
  std::vector<int> curve(index(edge_count(), 2));
  std::iota(curve.begin(), curve.end(), 0);
  std::vector<int> link_at(curve.size(), -1); // of the ends on the boundary
  for (const auto& [face, partner] : faces_) {
    if (partner.tet >= 0) continue;
    for (const int v : face_vertex[face.face]) {
      const int c = face_corner(face.face, v);
      const TetVertex at{face.tet, v};
      const int a = edge_end(at, face_vertex[face.face][(c + 1) % 3]);
      const int b = edge_end(at, face_vertex[face.face][(c + 2) % 3]);
      link_at[a] = link_at[b] = vertex(at).value;
      curve[numeric::find_root(curve, a)] = numeric::find_root(curve, b);
    }
  }
  for (std::size_t x = 0; x < curve.size(); ++x)
    if (link_at[x] >= 0 && curve[x] == static_cast<int>(x)) ++links_[link_at[x]].boundary_curves;
}

TriangulatedSurface vertex_link(const Triangulation& tri, const Skeleton& skeleton, VertexId v) {
  skeleton.require_current(tri);
  const auto at = skeleton.preimages(v);
  std::vector<std::pair<TetVertex, int>> triangle;
  triangle.reserve(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) triangle.emplace_back(at[k], static_cast<int>(k));
  std::sort(triangle.begin(), triangle.end());
  const auto triangle_at = [&](TetVertex w) {
    return std::lower_bound(triangle.begin(), triangle.end(), std::pair(w, 0))->second;
  };
  TriangulatedSurface link(static_cast<int>(at.size()));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto [t, u] = at[k];
    for (int f = 0; f < 4; ++f) {
      if (f == u || tri.is_boundary({t, f})) continue;
      const Gluing g = tri.gluing({t, f});
      std::array<int, 3> corner{};
      for (int c = 0; c < 3; ++c) corner[c] = face_corner(g.perm[u], g.perm[face_vertex[u][c]]);
      link.glue(static_cast<int>(k), face_corner(u, f), triangle_at({g.tet, g.perm[u]}), corner);
    }
  }
  return link;
}

} // namespace tetrarch
