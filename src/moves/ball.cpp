// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/ball.hpp"

#include "corners.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::moves {
namespace {

constexpr int most_corners = 6;
using Tets = boost::container::static_vector<Corners, 4>;

/// The faces of a side of the move by their corners: found once on the boundary of the ball, twice inside.
struct Faces {
  struct Entry {
    int count = 0;
    TetFace first;
    TetFace second;
  };
  std::array<Entry, 1U << most_corners> at;
  boost::container::static_vector<unsigned, 16> keys; ///< in the order in which they are first met

  explicit Faces(const Tets& tets) {
    for (int k = 0; k < static_cast<int>(tets.size()); ++k)
      for (int f = 0; f < 4; ++f) {
        const unsigned key = face_key(tets[k], f);
        Entry& entry = at[key];
        (entry.count == 0 ? entry.first : entry.second) = {k, f};
        if (entry.count++ == 0) keys.push_back(key);
      }
  }
  bool on_boundary(unsigned key) const { return at[key].count == 1; }
};

void require_same_boundary(const Faces& before, const Faces& after) {
  for (const Faces* side : {&before, &after})
    for (const unsigned key : side->keys)
      if (side->at[key].count > 2 || (side->on_boundary(key) && before.at[key].count != after.at[key].count))
        throw PreconditionError("the two sides of the move have different boundaries");
}

/// The permutation that matches equal corners of two tetrahedra along a shared face, and face to face.
Perm4 matching(const Corners& a, int face_a, const Corners& b, int face_b) {
  std::array<int, 4> image{};
  image[face_a] = face_b;
  for (const int v : face_vertex[face_a])
    image[v] = static_cast<int>(std::find(b.begin(), b.end(), a[v]) - b.begin());
  return {image[0], image[1], image[2], image[3]};
}

/// Classes of vertices and edges by corners; -1 where there is none.
struct Labels {
  std::array<VertexId, most_corners> vertex;
  std::array<std::array<EdgeId, most_corners>, most_corners> edge;
};

Labels labels_of(const Complex& complex, const Ball& ball) {
  Labels labels;
  for (const Placed& p : ball.before) {
    for (int v = 0; v < 4; ++v) labels.vertex[p.corners[v]] = complex.vertex({p.tet, v});
    for (int e = 0; e < 6; ++e) {
      const int a = p.corners[edge_vertex[e][0]];
      const int b = p.corners[edge_vertex[e][1]];
      labels.edge[a][b] = labels.edge[b][a] = complex.edge(TetEdge{p.tet, e});
    }
  }
  return labels;
}

/// Adds a new tetrahedron, with new classes for what the ball did not have before.
int add_filling(Complex& complex, const Corners& corners, Labels& labels) {
  std::array<VertexId, 4> vertices;
  std::array<EdgeId, 6> edges;
  for (int v = 0; v < 4; ++v) {
    VertexId& vertex = labels.vertex[corners[v]];
    if (vertex.value < 0) vertex = complex.add_vertex(LinkKind::sphere);
    vertices[v] = vertex;
  }
  for (int e = 0; e < 6; ++e) {
    const int a = corners[edge_vertex[e][0]];
    const int b = corners[edge_vertex[e][1]];
    if (labels.edge[a][b].value < 0) labels.edge[a][b] = labels.edge[b][a] = complex.add_edge(false);
    edges[e] = labels.edge[a][b];
  }
  return complex.add_tet(vertices, edges);
}

/// Takes note of the edges and vertices inside the old ball that the new one does not have.
void remove_insides(Complex& complex, const Tets& before, const Labels& labels, const Tets& after) {
  std::array<std::array<int, most_corners>, most_corners> uses{}; // 1: before, 2: handled or after
  for (const Corners& c : after)
    for (const int a : c)
      for (const int b : c) uses[a][b] = 2;
  for (const Corners& c : before)
    for (int i = 0; i < 4; ++i) {
      if (std::exchange(uses[c[i]][c[i]], 2) == 0) complex.remove_vertex(labels.vertex[c[i]]);
      for (int j = 0; j < i; ++j) {
        if (uses[c[i]][c[j]] != 0) continue;
        uses[c[i]][c[j]] = uses[c[j]][c[i]] = 2;
        complex.remove_edge(labels.edge[c[i]][c[j]]);
      }
    }
}

template <class Gluings>
bool all_different(const Gluings& tets) {
  for (std::size_t i = 0; i < tets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (tets[i].tet == tets[j].tet) return false;
  return true;
}

using Star = decltype(Ball::before);

/// The tetrahedra around an interior edge of valence `wanted`: its ends at corners `wanted` and `wanted` + 1,
/// the ring at corners 0 .. wanted-1, the left vertex of the first tetrahedron at 0.
template <class Gluings>
std::variant<Star, Obstacle> star(const Gluings& tri, DirectedTetEdge e, int wanted) {
  const Walk start{e.tet, edge_frame(e.from, e.to)};
  Walk w = start;
  Star tets;
  for (int k = 0; k < wanted; ++k) {
    Placed placed{w.tet, {}};
    placed.corners[w.hold[0]] = wanted;
    placed.corners[w.hold[1]] = wanted + 1;
    placed.corners[w.hold[2]] = k;
    placed.corners[w.hold[3]] = (k + wanted - 1) % wanted;
    tets.push_back(placed);
    if (!w.step_left(tri)) return Obstacle::boundary_face;
    if (k + 1 < wanted && w == start) return Obstacle::wrong_valence;
  }
  if (!(w == start)) return Obstacle::wrong_valence;
  if (!all_different(tets)) return Obstacle::repeated_tetrahedron;
  return tets;
}

} // namespace

void replace(Complex& complex, const Ball& ball) {
  Tets before;
  for (const Placed& p : ball.before) before.push_back(p.corners);
  const Faces old_faces(before);
  const Faces new_faces(ball.after);
  require_same_boundary(old_faces, new_faces);
  Labels labels = labels_of(complex, ball);

  // How the boundary of the ball was glued, with partners inside the ball by their place in it.
  struct Side {
    unsigned key;
    Gluing gluing;
    int place = -1; ///< of gluing.tet in the ball, -1: outside
  };
  boost::container::static_vector<Side, 16> sides;
  for (const unsigned key : old_faces.keys) {
    if (!old_faces.on_boundary(key)) continue;
    const auto [k, f] = old_faces.at[key].first;
    Side side{key, complex.gluing({ball.before[k].tet, f})};
    for (int j = 0; j < static_cast<int>(ball.before.size()); ++j)
      if (ball.before[j].tet == side.gluing.tet) side.place = j;
    sides.push_back(side);
  }

  complex.begin_change();
  for (const Placed& p : ball.before) complex.remove_tet(p.tet);
  remove_insides(complex, before, labels, ball.after);
  boost::container::static_vector<int, 4> tets;
  for (const Corners& corners : ball.after) tets.push_back(add_filling(complex, corners, labels));

  for (const unsigned key : new_faces.keys) {
    if (new_faces.on_boundary(key)) continue;
    const auto [k, f] = new_faces.at[key].first;
    const auto [l, g] = new_faces.at[key].second;
    complex.glue({tets[k], f}, tets[l], matching(ball.after[k], f, ball.after[l], g));
  }
  for (const Side& side : sides) {
    const auto [old, old_face] = old_faces.at[side.key].first;
    const auto [k, f] = new_faces.at[side.key].first;
    if (side.gluing.tet < 0 || !complex.is_boundary({tets[k], f})) continue;
    const Perm4 out = side.gluing.perm * matching(ball.after[k], f, before[old], old_face);
    if (side.place < 0) {
      complex.glue({tets[k], f}, side.gluing.tet, out);
      continue;
    }
    // The ball is glued to itself here: find the new face that takes the partner's place.
    const Corners& there = before[side.place];
    const int face_there = side.gluing.perm[old_face];
    const auto [l, g] = new_faces.at[face_key(there, face_there)].first;
    complex.glue({tets[k], f}, tets[l], matching(there, face_there, ball.after[l], g) * out);
  }
}

Replaced replace(const Triangulation& tri, const Ball& ball) {
  Complex complex(tri);
  replace(complex, ball);
  // Survivors in their old order, then the new ones, whatever slots they took.
  Replaced out{Triangulation(complex.size()), std::vector<int>(static_cast<std::size_t>(tri.size()), -1), 0};
  std::vector<int> number(static_cast<std::size_t>(complex.slot_count()), -1);
  for (const int t : complex.last_change().new_tets) number[t] = complex.slot_count();
  for (int t = 0; t < complex.slot_count(); ++t)
    if (complex.is_alive(t) && number[t] < 0) number[t] = out.image[t] = out.first_new++;
  int next = out.first_new;
  for (const int t : complex.last_change().new_tets) number[t] = next++;
  for (int t = 0; t < complex.slot_count(); ++t)
    for (int f = 0; complex.is_alive(t) && f < 4; ++f) {
      const Gluing g = complex.gluing({t, f});
      if (g.tet >= 0 && out.tri.is_boundary({number[t], f}))
        out.tri.glue({number[t], f}, number[g.tet], g.perm);
    }
  return out;
}

template <class Gluings>
BallOrObstacle one_four_ball(const Gluings&, int tet) {
  return Ball{{{tet, {0, 1, 2, 3}}}, {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}}};
}

template <class Gluings>
BallOrObstacle four_one_ball(const Gluings& tri, TetVertex v) {
  Placed core{v.tet, {}};
  core.corners[v.vertex] = 4;
  for (int c = 0; c < 3; ++c) core.corners[face_vertex[v.vertex][c]] = c;
  Ball ball{{core}, {{0, 1, 2, 3}}};
  // The three tetrahedra beside it all reach corner 3.
  for (int c = 0; c < 3; ++c) {
    const int f = face_vertex[v.vertex][c];
    const Gluing g = tri.gluing({v.tet, f});
    if (g.tet < 0) return Obstacle::boundary_face;
    Placed beside{g.tet, {}};
    for (int k = 0; k < 4; ++k) beside.corners[g.perm[k]] = k == f ? 3 : core.corners[k];
    ball.before.push_back(beside);
  }
  if (!all_different(ball.before)) return Obstacle::repeated_tetrahedron;
  for (const Placed& p : ball.before)
    for (int f = 0; f < 4; ++f) {
      if (p.corners[f] == 4) continue;
      const Gluing g = tri.gluing({p.tet, f});
      const auto other = std::find_if(ball.before.begin(), ball.before.end(),
                                      [&g](const Placed& q) { return q.tet == g.tet; });
      if (other == ball.before.end()) return Obstacle::wrong_valence;
      for (int k = 0; k < 4; ++k)
        if (k != f && other->corners[g.perm[k]] != p.corners[k]) return Obstacle::wrong_valence;
    }
  return ball;
}

template <class Gluings>
BallOrObstacle two_three_ball(const Gluings& tri, TetFace f) {
  const Gluing g = tri.gluing(f);
  if (g.tet < 0) return Obstacle::boundary_face;
  if (g.tet == f.tet) return Obstacle::repeated_tetrahedron;
  Placed one{f.tet, {}};
  Placed two{g.tet, {}};
  one.corners[f.face] = 3;
  two.corners[g.perm[f.face]] = 4;
  for (int c = 0; c < 3; ++c) {
    one.corners[face_vertex[f.face][c]] = c;
    two.corners[g.perm[face_vertex[f.face][c]]] = c;
  }
  return Ball{{one, two}, {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}}};
}

template <class Gluings>
BallOrObstacle three_two_ball(const Gluings& tri, DirectedTetEdge e) {
  auto around = star(tri, e, 3);
  if (const auto* obstacle = std::get_if<Obstacle>(&around)) return *obstacle;
  return Ball{std::get<0>(std::move(around)), {{0, 1, 2, 3}, {1, 0, 2, 4}}};
}

template <class Gluings>
BallOrObstacle four_four_ball(const Gluings& tri, DirectedTetEdge e, int axis) {
  auto around = star(tri, e, 4);
  if (const auto* obstacle = std::get_if<Obstacle>(&around)) return *obstacle;
  const int p = axis;
  const int q = axis + 1;
  const int r = axis + 2;
  const int s = (axis + 3) % 4;
  return Ball{std::get<0>(std::move(around)), {{p, r, q, 4}, {r, p, q, 5}, {r, p, s, 4}, {p, r, s, 5}}};
}

#define TETRARCH_BALLS_OF(Gluings)                                                                           \
  template BallOrObstacle one_four_ball(const Gluings&, int);                                                \
  template BallOrObstacle four_one_ball(const Gluings&, TetVertex);                                          \
  template BallOrObstacle two_three_ball(const Gluings&, TetFace);                                           \
  template BallOrObstacle three_two_ball(const Gluings&, DirectedTetEdge);                                   \
  template BallOrObstacle four_four_ball(const Gluings&, DirectedTetEdge, int);
TETRARCH_BALLS_OF(Triangulation)
TETRARCH_BALLS_OF(Complex)
#undef TETRARCH_BALLS_OF

} // namespace tetrarch::moves
