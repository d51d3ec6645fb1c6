// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/complex.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::moves {

void Change::clear() {
  removed_tets.clear();
  new_tets.clear();
  merged_vertices.clear();
  merged_edges.clear();
  split_vertices.clear();
  split_edges.clear();
  removed_vertices.clear();
  removed_edges.clear();
  new_vertices.clear();
  new_edges.clear();
  touched_tets.clear();
}

Complex::Complex(const Triangulation& tri) : tets_(index(tri.size())), size_(tri.size()) {
  for (int t = 0; t < tri.size(); ++t) {
    Tet& tet = tets_[index(t)];
    tet.vertex.fill(-1);
    tet.edge.fill(-1);
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      tet.across[f] = g.tet;
      tet.perm[f] = g.perm;
      if (g.tet < 0) ++boundary_faces_;
    }
  }
  find_vertices();
  find_edges();
  find_links();
  vertex_count_ = static_cast<int>(vertices_.size());
  edge_count_ = static_cast<int>(edges_.size());
}

void Complex::find_vertices() {
  std::vector<TetVertex> pending;
  for (int t = 0; t < slot_count(); ++t)
    for (int v = 0; v < 4; ++v) {
      if (tets_[index(t)].vertex[v] >= 0) continue;
      const int id = static_cast<int>(vertices_.size());
      vertices_.push_back({id, 0, LinkKind::sphere});
      tets_[index(t)].vertex[v] = id;
      pending.push_back({t, v});
      while (!pending.empty()) {
        const TetVertex at = pending.back();
        pending.pop_back();
        ++vertices_[index(id)].size;
        for (int f = 0; f < 4; ++f) {
          if (f == at.vertex) continue;
          const Gluing g = gluing({at.tet, f});
          if (g.tet < 0 || tets_[index(g.tet)].vertex[g.perm[at.vertex]] >= 0) continue;
          tets_[index(g.tet)].vertex[g.perm[at.vertex]] = id;
          pending.push_back({g.tet, g.perm[at.vertex]});
        }
      }
    }
}

void Complex::find_edges() {
  for (int t = 0; t < slot_count(); ++t)
    for (int e = 0; e < 6; ++e)
      if (tets_[index(t)].edge[e] < 0) label_edge({t, e});
}

/// Walks left from the t-edge until home or the boundary, then right. A t-edge is met a second time before
/// the way home is found only where the class runs back along itself.
void Complex::label_edge(TetEdge first) {
  const int id = static_cast<int>(edges_.size());
  edges_.push_back({id, 0, false, false});
  EdgeClass& made = edges_.back();
  const auto label = [&](const Walk& w) {
    int& place = tets_[index(w.tet)].edge[w.edge().edge];
    if (place == id) {
      made.reversed = true;
      return;
    }
    place = id;
    made.size = made.size + 1;
  };
  const auto [from, to] = edge_vertex[first.edge];
  const Walk start{first.tet, edge_frame(from, to)};
  Walk w = start;
  label(w);
  while (w.step_left(*this)) {
    if (w == start) return;
    label(w);
  }
  made.boundary = true;
  for (w = start; w.step_right(*this);) label(w);
}

/// The Euler characteristic of each link: corners are ends of edges, sides are met by two triangles or lie on
/// the boundary.
void Complex::find_links() {
  std::vector<int> corners(vertices_.size(), 0);
  std::vector<int> free_sides(vertices_.size(), 0);
  std::vector<bool> seen(edges_.size(), false);
  for (const Tet& tet : tets_)
    for (int e = 0; e < 6; ++e) {
      const std::size_t id = index(tet.edge[e]);
      if (seen[id]) continue;
      seen[id] = true;
      // Both ends of a reversed edge are one point of the link, which is then no surface to count on.
      ++corners[index(tet.vertex[edge_vertex[e][0]])];
      if (!edges_[id].reversed) ++corners[index(tet.vertex[edge_vertex[e][1]])];
    }
  for (const Tet& tet : tets_)
    for (int f = 0; f < 4; ++f)
      if (tet.across[f] < 0)
        for (const int v : face_vertex[f]) ++free_sides[index(tet.vertex[v])];
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const int sides = (3 * vertices_[v].size + free_sides[v]) / 2;
    const int euler = corners[v] - sides + vertices_[v].size;
    if (free_sides[v] == 0)
      vertices_[v].link = euler == 2 ? LinkKind::sphere : LinkKind::closed;
    else
      vertices_[v].link = euler == 1 ? LinkKind::disk : LinkKind::bad;
  }
}

Table<VertexId, VertexId> Complex::all_vertices() const {
  Table<VertexId, VertexId> names(static_cast<int>(vertices_.size()));
  for (const VertexId v : all<VertexId>(names.size())) {
    const VertexId now = current(v);
    if (degree(now) > 0) names[v] = now;
  }
  return names;
}

Ring Complex::around(DirectedTetEdge e) const {
  Ring ring;
  Walk w{e.tet, edge_frame(e.from, e.to)};
  if (is_boundary(edge(e)))
    while (w.step_right(*this)) {
    }
  const Walk start = w;
  do ring.push_back(w);
  while (w.step_left(*this) && !(w == start));
  return ring;
}

Complex::Compact Complex::compact() const {
  Compact out{Triangulation(size_), std::vector<int>(tets_.size(), -1)};
  int next = 0;
  for (int t = 0; t < slot_count(); ++t)
    if (is_alive(t)) out.image[index(t)] = next++;
  for (int t = 0; t < slot_count(); ++t) {
    if (!is_alive(t)) continue;
    for (int f = 0; f < 4; ++f) {
      const Gluing g = gluing({t, f});
      const TetFace here{out.image[index(t)], f};
      if (g.tet >= 0 && out.tri.is_boundary(here)) out.tri.glue(here, out.image[index(g.tet)], g.perm);
    }
  }
  return out;
}

/// Keeps the classes that have a name, in the order of names, and extends the names to what was merged into
/// them.
template <class Classes, class Names>
void Complex::rename_classes(Classes& classes, Names& names) {
  using Key = std::decay_t<decltype(*names.begin())>;
  Classes kept;
  for (int id = 0; id < static_cast<int>(classes.size()); ++id) {
    const int name = names[Key(id)].value;
    if (name < 0) continue;
    if (kept.size() <= index(name)) kept.resize(index(name) + 1);
    kept[index(name)] = classes[index(id)];
    kept[index(name)].parent = name;
  }
  for (int id = 0; id < static_cast<int>(classes.size()); ++id)
    names[Key(id)] = names[Key(root(classes, id))];
  classes = std::move(kept);
}

Complex::Renaming Complex::pack() {
  Renaming names{std::vector<int>(tets_.size(), -1),
                 Table<VertexId, VertexId>(static_cast<int>(vertices_.size())),
                 Table<EdgeId, EdgeId>(static_cast<int>(edges_.size()))};
  std::vector<Tet> kept;
  kept.reserve(index(size_));
  int vertices = 0;
  int edges = 0;
  for (int t = 0; t < slot_count(); ++t) {
    if (!is_alive(t)) continue;
    names.tet[index(t)] = static_cast<int>(kept.size());
    Tet tet = tets_[index(t)];
    for (int v = 0; v < 4; ++v) {
      VertexId& name = names.vertex[vertex({t, v})];
      if (name.value < 0) name = VertexId(vertices++);
      tet.vertex[v] = name.value;
    }
    for (int e = 0; e < 6; ++e) {
      EdgeId& name = names.edge[edge(TetEdge{t, e})];
      if (name.value < 0) name = EdgeId(edges++);
      tet.edge[e] = name.value;
    }
    kept.push_back(tet);
  }
  for (Tet& tet : kept)
    for (int& across : tet.across)
      if (across >= 0) across = names.tet[index(across)];
  tets_ = std::move(kept);
  free_ = {};
  change_ = {};
  rename_classes(vertices_, names.vertex);
  rename_classes(edges_, names.edge);
  return names;
}

int Complex::add_tet(const std::array<VertexId, 4>& vertices, const std::array<EdgeId, 6>& edges) {
  int t = slot_count();
  if (free_.empty()) {
    tets_.emplace_back();
  } else {
    t = free_.back();
    free_.pop_back();
  }
  Tet& tet = tets_[index(t)];
  tet.across.fill(-1);
  for (int v = 0; v < 4; ++v) {
    tet.vertex[v] = vertices[v].value;
    ++vertices_[index(vertices[v].value)].size;
  }
  for (int e = 0; e < 6; ++e) {
    tet.edge[e] = edges[e].value;
    EdgeClass& made = edges_[index(edges[e].value)];
    made.size = made.size + 1;
  }
  ++size_;
  boundary_faces_ += 4;
  change_.new_tets.push_back(t);
  return t;
}

void Complex::remove_tet(int t) {
  for (int f = 0; f < 4; ++f) {
    const int other = gluing({t, f}).tet;
    if (other >= 0 && other != t) change_.touched_tets.push_back(other);
    part({t, f});
  }
  Tet& tet = tets_[index(t)];
  for (int v = 0; v < 4; ++v) --vertices_[index(vertex({t, v}).value)].size;
  for (int e = 0; e < 6; ++e) {
    EdgeClass& left = edges_[index(edge(TetEdge{t, e}).value)];
    left.size = left.size - 1;
  }
  tet.vertex[0] = -1;
  --size_;
  boundary_faces_ -= 4;
  free_.push_back(t);
  change_.removed_tets.push_back(t);
}

void Complex::glue(TetFace f, int other, Perm4 p) {
  const TetFace there{other, p[f.face]};
  if (!is_boundary(f) || !is_boundary(there) || f == there)
    throw PreconditionError("Complex::glue: both faces must be free, and two");
  tets_[index(f.tet)].across[f.face] = other;
  tets_[index(f.tet)].perm[f.face] = p;
  tets_[index(other)].across[there.face] = f.tet;
  tets_[index(other)].perm[there.face] = p.inverse();
  boundary_faces_ -= 2;
  change_.touched_tets.push_back(f.tet);
  change_.touched_tets.push_back(other);
}

void Complex::unglue(TetFace f) {
  if (is_boundary(f)) return;
  change_.touched_tets.push_back(f.tet);
  change_.touched_tets.push_back(partner(f).tet);
  part(f);
}

void Complex::part(TetFace f) {
  if (is_boundary(f)) return;
  const TetFace there = partner(f);
  tets_[index(f.tet)].across[f.face] = -1;
  tets_[index(there.tet)].across[there.face] = -1;
  boundary_faces_ += 2;
}

VertexId Complex::add_vertex(LinkKind link) {
  const VertexId made(static_cast<int>(vertices_.size()));
  vertices_.push_back({made.value, 0, link});
  ++vertex_count_;
  change_.new_vertices.push_back(made);
  return made;
}

EdgeId Complex::add_edge(bool boundary) {
  const EdgeId made(static_cast<int>(edges_.size()));
  edges_.push_back({made.value, 0, boundary, false});
  ++edge_count_;
  change_.new_edges.push_back(made);
  return made;
}

void Complex::remove_vertex(VertexId v) {
  --vertex_count_;
  change_.removed_vertices.push_back(v);
}

void Complex::remove_edge(EdgeId e) {
  --edge_count_;
  change_.removed_edges.push_back(e);
}

/// The smaller class joins the larger one; returns (gone, kept).
template <class Classes>
std::pair<int, int> Complex::link_roots(Classes& classes, int a, int b) {
  a = root(classes, a);
  b = root(classes, b);
  if (a == b) throw PreconditionError("Complex: a class cannot be merged with itself");
  if (classes[index(a)].size > classes[index(b)].size) std::swap(a, b);
  classes[index(a)].parent = b;
  classes[index(b)].size = classes[index(b)].size + classes[index(a)].size;
  return {a, b};
}

void Complex::merge_vertices(VertexId a, VertexId b, LinkKind link) {
  const auto [gone, kept] = link_roots(vertices_, a.value, b.value);
  vertices_[index(kept)].link = link;
  --vertex_count_;
  change_.merged_vertices.emplace_back(VertexId(gone), VertexId(kept));
}

void Complex::merge_edges(EdgeId a, EdgeId b) {
  const auto [gone, kept] = link_roots(edges_, a.value, b.value);
  EdgeClass& into = edges_[index(kept)];
  into.boundary = into.boundary || edges_[index(gone)].boundary;
  into.reversed = into.reversed || edges_[index(gone)].reversed;
  --edge_count_;
  change_.merged_edges.emplace_back(EdgeId(gone), EdgeId(kept));
}

void Complex::relabel(TetVertex v, VertexId part) {
  --vertices_[index(vertex(v).value)].size;
  tets_[index(v.tet)].vertex[v.vertex] = part.value;
  ++vertices_[index(part.value)].size;
}

void Complex::relabel(TetEdge e, EdgeId part) {
  EdgeClass& whole = edges_[index(edge(e).value)];
  whole.size = whole.size - 1;
  tets_[index(e.tet)].edge[e.edge] = part.value;
  EdgeClass& into = edges_[index(part.value)];
  into.size = into.size + 1;
}

} // namespace tetrarch::moves
