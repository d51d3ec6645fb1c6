// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/drill.hpp"

#include "drilling.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace tetrarch::moves {

void require_fit(const Triangulation& tri, const Skeleton& skeleton, const EdgeSet& edges) {
  skeleton.require_current(tri);
  if (edges.size() != skeleton.edge_count())
    throw PreconditionError("drill: " + std::to_string(edges.size()) + " entries for " +
                            std::to_string(skeleton.edge_count()) + " edges");
}

/// The vertices of the drilled edges.
Table<VertexId, bool> vertices_on(const Skeleton& skeleton, const EdgeSet& edges) {
  Table<VertexId, bool> on(skeleton.vertex_count(), false);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (edges[e]) {
      const auto [a, b] = skeleton.ends(e);
      on[a] = on[b] = true;
    }
  return on;
}

namespace {

// Cutting. A simplex of a tetrahedron is the set of its vertices, as bits; the point in its middle has that
// name. The middle m between the points of a simplex and of a larger one is called by both.

using Name = int;
using Corners = std::array<Name, 4>;

constexpr Name between(int smaller, int larger) {
  return 16 * smaller + larger;
}

int image(int simplex, Perm4 p) {
  int bits = 0;
  for (int v = 0; v < 4; ++v)
    if ((simplex >> v & 1) != 0) bits |= 1 << p[v];
  return bits;
}

Name renamed(Name name, Perm4 p) {
  return between(image(name / 16, p), image(name % 16, p));
}

/// The larger of the two simplices that name a point: it lies in the inside of this one.
constexpr int carrier(Name name) {
  return name % 16;
}

class Cutting {
public:
  Cutting(const Triangulation& tri, const Skeleton& skeleton, const EdgeSet& edges, Table<VertexId, bool> on)
      : tri_(tri), skeleton_(skeleton), edges_(edges), on_(std::move(on)) {
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
      if (edges[e] && skeleton.is_reversed(e))
        throw PreconditionError("drill: edge " + std::to_string(e.value) +
                                " is identified with itself backwards");
    first_.push_back(0);
    for (int t = 0; t < tri.size(); ++t) {
      add_pieces(t);
      first_.push_back(static_cast<int>(pieces_.size()));
    }
  }

  Triangulation glued() const {
    Triangulation out(static_cast<int>(pieces_.size()));
    for (int t = 0; t < tri_.size(); ++t) glue_inside(out, t);
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f) glue_across(out, {t, f});
    return out;
  }

  /// What is left of an edge that is not drilled.
  void follow(EdgeId e, std::vector<TetEdge>& left) const {
    const Walk& w = skeleton_.around(e).front();
    const int from = 1 << w.from();
    const int to = 1 << w.to();
    const auto add = [&](Name a, Name b) {
      const DirectedTetEdge found = edge_between(w.tet, a, b);
      left.push_back({found.tet, edge_number[found.from][found.to]});
    };
    if (!touches(w.tet, from | to)) return add(from, to);
    for (const int end : {from, to}) {
      const bool cut = touches(w.tet, end);
      add(cut ? between(end, from | to) : end, from | to);
    }
  }

  CutOut run() {
    CutOut out{glued(), {}, {}};
    for (int t = 0; t < tri_.size(); ++t)
      out.origin.insert(out.origin.end(), static_cast<std::size_t>(first_[t + 1] - first_[t]), t);
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count()))
      if (edges_[e]) out.meridians.push_back(meridian(e));
    return out;
  }

private:
  bool is_on(int t, int v) const { return on_[skeleton_.vertex({t, v})]; }
  bool is_drilled(int t, int a, int b) const { return edges_[skeleton_.edge(TetEdge{t, edge_number[a][b]})]; }
  bool touches(int t, int simplex) const {
    for (int v = 0; v < 4; ++v)
      if ((simplex >> v & 1) != 0 && is_on(t, v)) return true;
    return false;
  }

  void add_pieces(int t) {
    constexpr int whole = 15;
    if (!touches(t, whole)) {
      pieces_.push_back({1, 2, 4, 8});
      return;
    }
    for (int f = 0; f < 4; ++f) {
      const int face = whole & ~(1 << f);
      const auto& [a, b, c] = face_vertex[f];
      if (!touches(t, face)) {
        pieces_.push_back({1 << a, 1 << b, 1 << c, whole});
        continue;
      }
      for (const auto& [v, w] : {std::pair{a, b}, {a, c}, {b, c}}) {
        const int edge = 1 << v | 1 << w;
        if (!touches(t, edge)) {
          pieces_.push_back({1 << v, 1 << w, face, whole});
          continue;
        }
        add_flag(t, v, w, face);
        add_flag(t, w, v, face);
      }
    }
  }

  /// The flag of the vertex v, the edge vw, a face and all.
  void add_flag(int t, int v, int w, int face) {
    constexpr int x3 = 15;
    const int x0 = 1 << v;
    const int x1 = x0 | 1 << w;
    const int x2 = face;
    if (!is_on(t, v)) {
      pieces_.push_back({x0, x1, x2, x3});
      return;
    }
    const Name m02 = between(x0, x2);
    const Name m03 = between(x0, x3);
    if (!is_drilled(t, v, w)) {
      pieces_.insert(pieces_.end(), {{x1, x2, x3, m03}, {x1, x2, m02, m03}, {x1, between(x0, x1), m02, m03}});
      return;
    }
    const Name m12 = between(x1, x2);
    const Name m13 = between(x1, x3);
    pieces_.insert(pieces_.end(), {{x2, x3, m03, m13}, {x2, m02, m03, m13}, {x2, m02, m12, m13}});
  }

  /// A face of a piece by its corners' names, increasing.
  struct Side {
    std::array<Name, 3> names{};
    TetFace face;
    auto key() const { return std::tie(names[0], names[1], names[2]); }
    bool operator<(const Side& other) const { return key() < other.key(); }
  };

  Side side_of(TetFace f, Perm4 p) const {
    Side side;
    side.face = f;
    for (int c = 0; c < 3; ++c) side.names[c] = renamed(pieces_[f.tet][face_vertex[f.face][c]], p);
    std::sort(side.names.begin(), side.names.end());
    return side;
  }

  /// Glues two faces so that corners of equal names meet; the names of the first are read through p.
  void glue_by_name(Triangulation& out, TetFace f, Perm4 p, TetFace g) const {
    std::array<int, 4> to{};
    to[f.face] = g.face;
    for (const int v : face_vertex[f.face])
      for (const int w : face_vertex[g.face])
        if (renamed(pieces_[f.tet][v], p) == pieces_[g.tet][w]) to[v] = w;
    out.glue(f, g.tet, Perm4(to[0], to[1], to[2], to[3]));
  }

  void glue_inside(Triangulation& out, int t) const {
    std::vector<Side> sides;
    for (int piece = first_[t]; piece < first_[t + 1]; ++piece)
      for (int f = 0; f < 4; ++f) sides.push_back(side_of({piece, f}, Perm4()));
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 0; k + 1 < sides.size(); ++k)
      if (sides[k].names == sides[k + 1].names) {
        glue_by_name(out, sides[k].face, Perm4(), sides[k + 1].face);
        ++k;
      }
  }

  /// The faces of pieces that lie on a face of t, named by the vertices of what p leads to.
  std::vector<Side> sides_on(TetFace f, Perm4 p) const {
    std::vector<Side> sides;
    for (int piece = first_[f.tet]; piece < first_[f.tet + 1]; ++piece)
      for (int k = 0; k < 4; ++k) {
        bool lies_on = true;
        for (const int c : face_vertex[k]) lies_on &= (carrier(pieces_[piece][c]) >> f.face & 1) == 0;
        if (lies_on) sides.push_back(side_of({piece, k}, p));
      }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  void glue_across(Triangulation& out, TetFace f) const {
    const Gluing g = tri_.gluing(f);
    if (g.tet < 0 || tri_.partner(f) < f) return;
    const std::vector<Side> here = sides_on(f, g.perm);
    const std::vector<Side> there = sides_on(tri_.partner(f), Perm4());
    for (std::size_t k = 0; k < here.size(); ++k) glue_by_name(out, here[k].face, g.perm, there[k].face);
  }

  /// The edge between two named points of a tetrahedron, in the first piece that has it.
  DirectedTetEdge edge_between(int t, Name from, Name to) const {
    for (int piece = first_[t]; piece < first_[t + 1]; ++piece) {
      const Corners& corners = pieces_[piece];
      const auto a = std::find(corners.begin(), corners.end(), from);
      const auto b = std::find(corners.begin(), corners.end(), to);
      if (a != corners.end() && b != corners.end())
        return {piece, static_cast<int>(a - corners.begin()), static_cast<int>(b - corners.begin())};
    }
    throw PreconditionError("drill: a meridian leaves the boundary");
  }

  /// Round the edge near its first end: from the right face to the middle of each tetrahedron to the left.
  std::vector<DirectedTetEdge> meridian(EdgeId e) const {
    std::vector<DirectedTetEdge> path;
    if (skeleton_.is_boundary(e)) return path;
    for (const Walk& w : skeleton_.around(e)) {
      constexpr int whole = 15;
      const int x0 = 1 << w.from();
      const Name middle = between(x0, whole);
      path.push_back(edge_between(w.tet, between(x0, whole & ~(1 << w.right_face().face)), middle));
      path.push_back(edge_between(w.tet, middle, between(x0, whole & ~(1 << w.left_face().face))));
    }
    return path;
  }

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  const EdgeSet& edges_;
  Table<VertexId, bool> on_;
  std::vector<Corners> pieces_;
  std::vector<int> first_; ///< of each tetrahedron, its first piece
};

} // namespace

CutOut cut_out(const Triangulation& tri, const Skeleton& skeleton, const Table<EdgeId, bool>& edges) {
  require_fit(tri, skeleton, edges);
  return Cutting(tri, skeleton, edges, vertices_on(skeleton, edges)).run();
}

Punctured punctured(const Triangulation& tri, const Skeleton& skeleton, const Table<VertexId, bool>& vertices,
                    const Table<EdgeId, bool>& followed) {
  require_fit(tri, skeleton, followed);
  if (vertices.size() != skeleton.vertex_count())
    throw PreconditionError("drill: an entry for each vertex is needed");
  const EdgeSet none(skeleton.edge_count(), false);
  const Cutting cutting(tri, skeleton, none, vertices);
  Punctured out{cutting.glued(), {}};
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (followed[e]) cutting.follow(e, out.edges);
  return out;
}

Triangulation doubled(const Triangulation& tri) {
  const int n = tri.size();
  Triangulation out(2 * n);
  for (int t = 0; t < n; ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet < 0) {
        out.glue({t, f}, n + t, Perm4());
        continue;
      }
      for (const int copy : {0, n})
        if (out.is_boundary({copy + t, f})) out.glue({copy + t, f}, copy + g.tet, g.perm);
    }
  return out;
}

int tree_count(const Skeleton& skeleton, const Table<EdgeId, bool>& edges) {
  Forest forest(skeleton.vertex_count());
  std::vector<EdgeId> extra; // each closes a circle
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const auto [a, b] = skeleton.ends(e);
    if (edges[e] && !forest.join(a.value, b.value)) extra.push_back(e);
  }
  const Table<VertexId, bool> on = vertices_on(skeleton, edges);
  std::vector<bool> is_tree(static_cast<std::size_t>(skeleton.vertex_count()), false);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (on[v]) is_tree[static_cast<std::size_t>(forest.root(v.value))] = true;
  for (const EdgeId e : extra)
    is_tree[static_cast<std::size_t>(forest.root(skeleton.ends(e).first.value))] = false;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (on[v] && !skeleton.link(v).is_sphere())
      is_tree[static_cast<std::size_t>(forest.root(v.value))] = false;
  return static_cast<int>(std::count(is_tree.begin(), is_tree.end(), true));
}

Drilling drill(const Triangulation& tri, const Skeleton& skeleton, const Table<EdgeId, bool>& edges) {
  auto by_crushing = crushed(tri, skeleton, edges);
  if (auto* made = std::get_if<Triangulation>(&by_crushing)) return {std::move(*made), true};
  return {cut_out(tri, skeleton, edges).tri, false};
}

} // namespace tetrarch::moves
