// SPDX-License-Identifier: GPL-2.0-or-later
#include "drilling.hpp"

#include "tetrarch/moves/drill.hpp"
#include "tetrarch/moves/marked.hpp"
#include "tetrarch/moves/monodromy.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tetrarch::moves {
namespace {

class Crushing {
public:
  Crushing(const Triangulation& tri, const Skeleton& skeleton, const EdgeSet& edges)
      : tri_(tri), skeleton_(skeleton), edges_(edges), axis_(static_cast<std::size_t>(tri.size()), -1) {}

  MaybeObstacle why_not() {
    MaybeObstacle why_not = why_not_flat();
    if (!why_not) why_not = why_not_vertices();
    if (!why_not) why_not = why_not_edges();
    if (!why_not) why_not = why_not_faces();
    return why_not;
  }

  /// The rest, if it is legal.
  Triangulation glued() {
    Triangulation out;
    number_rest(out);
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; number_[t] >= 0 && f < 4; ++f) {
        const Gluing g = across({t, f}, [](int, Perm4) {});
        if (g.tet >= 0 && out.is_boundary({number_[t], f})) out.glue({number_[t], f}, number_[g.tet], g.perm);
      }
    return out;
  }

  /// The marks of the edges that stay, on the rest, if it is legal; nothing where two would become one.
  std::optional<Marks> marks(const EdgeOrders& orders) const {
    Forest forest(skeleton_.edge_count());
    join_pressed_edges(forest);
    std::vector<double> order(static_cast<std::size_t>(skeleton_.edge_count()), 1.0); // of each root
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      if (orders[e] == 1 || edges_[e]) continue;
      double& found = order[forest.root(e.value)];
      if (found != 1) return std::nullopt;
      found = orders[e];
    }
    Marks out;
    for (int t = 0; t < tri_.size(); ++t)
      for (int e = 0; number_[t] >= 0 && e < 6; ++e) {
        double& left = order[forest.root(skeleton_.edge(TetEdge{t, e}).value)];
        if (left != 1) out.push_back({{number_[t], e}, left});
        left = 1;
      }
    const bool all_told = std::all_of(order.begin(), order.end(), [](double n) { return n == 1; });
    return all_told ? std::optional(std::move(out)) : std::nullopt;
  }

  /// The words of its crossings: who passes a flat tetrahedron at an end of its edge travels along this.
  Monodromy words(const Table<EdgeId, int>& letter, const std::vector<int>& hands) const {
    std::vector<int> start(axis_.size(), -1); // of each flat tetrahedron, where its edge begins
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count()))
      if (edges_[e])
        for (const Walk& w : skeleton_.around(e)) start[w.tet] = w.from();
    Monodromy out(static_cast<int>(axis_.size()) - flat_count());
    for (int t = 0; t < tri_.size(); ++t)
      if (number_[t] >= 0) out.set_hand(number_[t], hands[t]);
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; number_[t] >= 0 && f < 4; ++f)
        across({t, f}, [&](int flat, Perm4 map) {
          const auto [a, b] = edge_vertex[axis_[flat]];
          const int x = letter[skeleton_.edge(TetEdge{flat, axis_[flat]})];
          if (x == 0) return;
          for (const int v : face_vertex[f])
            if (map[v] == a || map[v] == b) {
              FreeWord& word = out.at(number_[t], v, f);
              word = product(word, {map[v] == start[flat] ? x : -x});
            }
        });
    return out;
  }

private:
  /// Finds each tetrahedron's edge in K.
  MaybeObstacle why_not_flat() {
    for (int t = 0; t < tri_.size(); ++t)
      for (int e = 0; e < 6; ++e) {
        if (!edges_[skeleton_.edge(TetEdge{t, e})]) continue;
        if (axis_[t] >= 0) return Obstacle::repeated_tetrahedron;
        axis_[t] = e;
      }
    return std::nullopt;
  }

  MaybeObstacle why_not_vertices() const {
    const Table<VertexId, bool> on = vertices_on(skeleton_, edges_);
    for (const VertexId v : all<VertexId>(skeleton_.vertex_count()))
      if (on[v] && !skeleton_.link(v).is_closed()) return Obstacle::boundary_face;
    return std::nullopt;
  }

  /// A triangle on an edge of K is pressed to an edge: its two others are identified.
  MaybeObstacle why_not_edges() const {
    Forest forest(skeleton_.edge_count());
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      if (edges_[e] && skeleton_.is_reversed(e)) return Obstacle::reversed_edge;
      if (skeleton_.is_boundary(e) || skeleton_.is_reversed(e)) forest.join(e.value, forest.boundary());
    }
    if (!join_pressed_edges(forest)) return Obstacle::edges_form_cycle;
    return std::nullopt;
  }

  /// False: some were one already.
  bool join_pressed_edges(Forest& forest) const {
    for (const FaceId f : all<FaceId>(skeleton_.face_count())) {
      const auto [t, face] = skeleton_.preimages(f).front();
      const int axis = axis_[t];
      if (axis < 0 || edge_vertex[axis][0] == face || edge_vertex[axis][1] == face) continue;
      const auto [a, b] = edge_vertex[axis];
      const int c = 6 - a - b - face;
      if (!forest.join(skeleton_.edge(TetEdge{t, edge_number[a][c]}).value,
                       skeleton_.edge(TetEdge{t, edge_number[b][c]}).value))
        return false;
    }
    return true;
  }

  /// A tetrahedron on an edge of K is pressed to a triangle: the two faces off the edge are identified.
  MaybeObstacle why_not_faces() const {
    Forest forest(skeleton_.face_count());
    for (const FaceId f : all<FaceId>(skeleton_.face_count()))
      if (skeleton_.is_boundary(f)) forest.join(f.value, forest.boundary());
    for (int t = 0; t < tri_.size(); ++t) {
      if (axis_[t] < 0) continue;
      const auto [a, b] = edge_vertex[axis_[t]];
      if (!forest.join(skeleton_.face({t, a}).value, skeleton_.face({t, b}).value))
        return Obstacle::faces_form_cycle;
    }
    return std::nullopt;
  }

  /// Across a face, through all that is flat: the next tetrahedron that is left. Flat ones form no circle.
  /// `pass` is told each flat one, and where the vertices of the first tetrahedron enter it.
  template <class Pass>
  Gluing across(TetFace f, Pass pass) const {
    Gluing g = tri_.gluing(f);
    while (g.tet >= 0 && axis_[g.tet] >= 0) {
      const auto [a, b] = edge_vertex[axis_[g.tet]];
      pass(g.tet, g.perm);
      const Perm4 through = Perm4::swap(a, b) * g.perm;
      const int leave = through[f.face];
      const Gluing next = tri_.gluing({g.tet, leave});
      g = {next.tet, next.perm * through};
    }
    return g;
  }

  int flat_count() const {
    return static_cast<int>(std::count_if(axis_.begin(), axis_.end(), [](int axis) { return axis >= 0; }));
  }

  void number_rest(Triangulation& out) {
    number_.assign(axis_.size(), -1);
    for (int t = 0; t < tri_.size(); ++t)
      if (axis_[t] < 0) number_[t] = out.add_tetrahedra();
  }

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  const EdgeSet& edges_;
  std::vector<int> axis_;   ///< the edge of K in each tetrahedron; -1: it stays
  std::vector<int> number_; ///< of those that stay
};

} // namespace

std::variant<Triangulation, Obstacle> crushed(const Triangulation& tri, const Skeleton& skeleton,
                                              const Table<EdgeId, bool>& edges) {
  require_fit(tri, skeleton, edges);
  Crushing crushing(tri, skeleton, edges);
  if (const MaybeObstacle why_not = crushing.why_not()) return *why_not;
  return crushing.glued();
}

std::variant<MarkedTriangulation, Obstacle> crushed(const Triangulation& tri, const Skeleton& skeleton,
                                                    const EdgeOrders& orders,
                                                    const Table<EdgeId, bool>& edges) {
  require_fit(tri, skeleton, edges);
  Crushing crushing(tri, skeleton, edges);
  if (const MaybeObstacle why_not = crushing.why_not()) return *why_not;
  MarkedTriangulation out{crushing.glued(), {}};
  std::optional<Marks> marks = crushing.marks(orders);
  if (!marks) return Obstacle::edges_form_cycle;
  out.marks = *std::move(marks);
  return out;
}

std::variant<Crushed, Obstacle> crushed_with_monodromy(const Triangulation& tri, const Skeleton& skeleton,
                                                       const Table<EdgeId, bool>& edges,
                                                       const GraphLetters& letters,
                                                       const std::vector<int>& hands) {
  require_fit(tri, skeleton, edges);
  Crushing crushing(tri, skeleton, edges);
  if (const MaybeObstacle why_not = crushing.why_not()) return *why_not;
  Crushed out{crushing.glued(), Monodromy()};
  out.monodromy = crushing.words(letters.letter, hands);
  return out;
}

} // namespace tetrarch::moves
