// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/skeleton.hpp"

#include "tetrarch/core/error.hpp"

#include <numeric>
#include <unordered_map>

namespace tetrarch {
namespace {

int find(std::vector<int>& parent, int x) {
  while (parent[x] != x) x = parent[x] = parent[parent[x]];
  return x;
}

} // namespace

Skeleton::Skeleton(const Triangulation& tri) : tets_(tri.size()), revision_(tri.revision()) {
  component_count_ = components(tri).count;
  orientable_ = orientation(tri).has_value();
  find_faces(tri);
  find_edges(tri);
  find_vertices(tri);
  classify_links(tri);
}

void Skeleton::require_current(const Triangulation& tri) const {
  if (tri.revision() != revision_)
    throw PreconditionError("stale skeleton: the triangulation was changed after the skeleton was computed");
}

std::span<const TetFace> Skeleton::preimages(FaceId f) const {
  const FacePair& pair = faces_[f.value];
  return {pair.side.data(), static_cast<std::size_t>(pair.count)};
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

void Skeleton::find_faces(const Triangulation& tri) {
  face_of_.assign(index(tets_, 4), -1);
  faces_.reserve(index(tets_, 2) + 16);
  for (int t = 0; t < tets_; ++t) {
    for (int f = 0; f < 4; ++f) {
      if (face_of_[index(t, 4) + f] >= 0) continue;
      const int id = static_cast<int>(faces_.size());
      face_of_[index(t, 4) + f] = id;
      if (tri.is_boundary({t, f})) {
        faces_.push_back({{TetFace{t, f}, TetFace{}}, 1});
        ++boundary_faces_;
        continue;
      }
      const TetFace g = tri.partner({t, f});
      face_of_[index(g.tet, 4) + g.face] = id;
      faces_.push_back({{TetFace{t, f}, g}, 2});
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

/// Walks right until home or the boundary, then left over the whole class. On the way home a class that is
/// identified with itself backwards shows itself: the first t-edge is met with its ends exchanged.
void Skeleton::add_edge(const Triangulation& tri, TetEdge first) {
  const auto [a, b] = edge_vertex[first.edge];
  const Walk start{first.tet, edge_frame(a, b)};
  std::uint8_t flags = 0;
  Walk w = start;
  while (true) {
    if (!w.step_right(tri)) {
      flags |= boundary_flag;
      break;
    }
    if (w.edge() != first) continue;
    if (w.from() != a) flags |= reversed_flag;
    w = start;
    break;
  }
  const TetEdge home = w.edge();
  const int id = static_cast<int>(edge_flags_.size());
  do {
    edge_of_[index(w.tet, 6) + w.edge().edge] = 2 * id + (w.from() < w.to() ? 0 : 1);
    edge_walks_.push_back(w);
  } while (w.step_left(tri) && w.edge() != home);
  edge_flags_.push_back(flags);
  edge_start_.push_back(static_cast<int>(edge_walks_.size()));
}

void Skeleton::find_vertices(const Triangulation& tri) {
  vertex_of_.assign(index(tets_, 4), -1);
  vertex_preimages_.reserve(index(tets_, 4));
  vertex_start_.assign(1, 0);
  for (int t = 0; t < tets_; ++t) {
    for (int v = 0; v < 4; ++v) {
      if (vertex_of_[index(t, 4) + v] >= 0) continue;
      const int id = static_cast<int>(vertex_start_.size()) - 1;
      std::size_t next = vertex_preimages_.size();
      vertex_of_[index(t, 4) + v] = id;
      vertex_preimages_.push_back({t, v});
      while (next < vertex_preimages_.size()) {
        const TetVertex at = vertex_preimages_[next++];
        for (int f = 0; f < 4; ++f) {
          if (f == at.vertex) continue;
          const Gluing g = tri.gluing({at.tet, f});
          if (g.tet < 0) continue;
          int& other = vertex_of_[index(g.tet, 4) + g.perm[at.vertex]];
          if (other >= 0) continue;
          other = id;
          vertex_preimages_.push_back({g.tet, g.perm[at.vertex]});
        }
      }
      vertex_start_.push_back(static_cast<int>(vertex_preimages_.size()));
    }
  }
}

/// A number for the end, at t-vertex `at`, of the edge class that leads `towards` there: the vertices of all
/// links.
int Skeleton::edge_end(TetVertex at, int towards) const {
  const EdgeId e = edge({at.tet, edge_number[at.vertex][towards]});
  if (is_reversed(e)) return 2 * e.value;
  return 2 * e.value + (runs_along({at.tet, at.vertex, towards}) ? 0 : 1);
}

/// Counts the cells of every link (its vertices are edge ends, its sides corners of faces), and orients it by
/// flooding.
void Skeleton::classify_links(const Triangulation& tri) {
  const int count = vertex_count();
  std::vector<int> cells(static_cast<std::size_t>(count), 0); // 2 * euler
  links_.assign(static_cast<std::size_t>(count), SurfaceType{0, 0, true});
  for (int e = 0; e < edge_count(); ++e) {
    const auto [p, q] = ends(EdgeId(e));
    cells[p.value] += 2;
    if (!is_reversed(EdgeId(e))) cells[q.value] += 2;
  }
  std::vector<int> curve(index(edge_count(), 2));
  std::iota(curve.begin(), curve.end(), 0);
  std::vector<int> curve_vertex(curve.size(), -1);
  std::vector<std::int8_t> sign(vertex_of_.size(), 0);
  for (int v = 0; v < count; ++v) {
    const auto triangles = preimages(VertexId(v));
    cells[v] += 2 * static_cast<int>(triangles.size());
    sign[index(triangles[0].tet, 4) + triangles[0].vertex] = 1;
    for (const TetVertex& at : triangles) { // in the order of the flood, so a predecessor has set the sign
      const int here = sign[index(at.tet, 4) + at.vertex];
      for (int f = 0; f < 4; ++f) {
        if (f == at.vertex) continue;
        const Gluing g = tri.gluing({at.tet, f});
        if (g.tet < 0) {
          cells[v] -= 2;
          int x = 0;
          while (x == f || x == at.vertex) ++x;
          const int y = 6 - f - at.vertex - x;
          const int a = find(curve, edge_end(at, x));
          const int b = find(curve, edge_end(at, y));
          curve_vertex[a] = curve_vertex[b] = v;
          curve[a] = b;
          continue;
        }
        cells[v] -= 1;
        // A triangle's own turning sense is that of its tetrahedron's handedness at this vertex: an odd
        // gluing keeps it.
        const int wanted = g.perm.sign() < 0 ? here : -here;
        std::int8_t& there = sign[index(g.tet, 4) + g.perm[at.vertex]];
        if (there == 0) there = static_cast<std::int8_t>(wanted);
        if (there != wanted) links_[v].orientable = false;
      }
    }
    links_[v].euler = cells[v] / 2;
  }
  for (std::size_t x = 0; x < curve.size(); ++x)
    if (curve_vertex[x] >= 0 && curve[x] == static_cast<int>(x)) ++links_[curve_vertex[x]].boundary_curves;
}

TriangulatedSurface vertex_link(const Triangulation& tri, const Skeleton& skeleton, VertexId v) {
  skeleton.require_current(tri);
  const auto at = skeleton.preimages(v);
  std::unordered_map<int, int> triangle;
  for (std::size_t k = 0; k < at.size(); ++k) triangle[4 * at[k].tet + at[k].vertex] = static_cast<int>(k);
  TriangulatedSurface link(static_cast<int>(at.size()));
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto [t, u] = at[k];
    for (int f = 0; f < 4; ++f) {
      if (f == u || tri.is_boundary({t, f})) continue;
      const Gluing g = tri.gluing({t, f});
      std::array<int, 3> corner{};
      for (int c = 0; c < 3; ++c) corner[c] = face_corner(g.perm[u], g.perm[face_vertex[u][c]]);
      link.glue(static_cast<int>(k), face_corner(u, f), triangle.at(4 * g.tet + g.perm[u]), corner);
    }
  }
  return link;
}

} // namespace tetrarch
