// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/pachner.hpp"

#include "flatten.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/ball.hpp"

namespace tetrarch::moves {
namespace {

MaybeObstacle fill(Complex& complex, const BallOrObstacle& ball) {
  if (const auto* obstacle = std::get_if<Obstacle>(&ball)) return *obstacle;
  replace(complex, std::get<Ball>(ball));
  return std::nullopt;
}

MaybeObstacle plan_two_zero_edge(const Complex& complex, DirectedTetEdge e, Flattening& flat) {
  const EdgeId edge = complex.edge(e);
  if (complex.is_reversed(edge)) return Obstacle::reversed_edge;
  if (complex.is_boundary(edge)) return Obstacle::boundary_face;
  if (complex.valence(edge) != 2) return Obstacle::wrong_valence;
  const Walk one{e.tet, edge_frame(e.from, e.to)};
  Walk two = one;
  two.step_left(complex);
  if (one.tet == two.tet) return Obstacle::repeated_tetrahedron;
  const Perm4 map = two.hold * Perm4::swap(2, 3) * one.hold.inverse();
  flat.tets = {one.tet, two.tet};
  for (const int end : {e.from, e.to}) flat.faces.push_back({{one.tet, end}, {two.tet, map[end]}, map});
  flat.edges.push_back({complex.edge(DirectedTetEdge{one.tet, one.hold[2], one.hold[3]}),
                        complex.edge(DirectedTetEdge{two.tet, two.hold[2], two.hold[3]})});
  return why_not_flatten(complex, flat);
}

MaybeObstacle plan_two_zero_vertex(const Complex& complex, TetVertex v, Flattening& flat) {
  const VertexId vertex = complex.vertex(v);
  if (complex.degree(vertex) != 2) return Obstacle::wrong_valence;
  if (complex.link(vertex) != LinkKind::sphere) return Obstacle::bad_vertex;
  const Gluing g = complex.gluing({v.tet, face_vertex[v.vertex][0]});
  for (const int f : face_vertex[v.vertex])
    if (complex.gluing({v.tet, f}) != g) return Obstacle::repeated_tetrahedron;
  if (g.tet == v.tet) return Obstacle::repeated_tetrahedron;
  flat.tets = {v.tet, g.tet};
  flat.faces.push_back({{v.tet, v.vertex}, {g.tet, g.perm[v.vertex]}, g.perm});
  return why_not_flatten(complex, flat);
}

std::array<VertexId, 4> vertices_of(const Complex& complex, int t) {
  return {complex.vertex({t, 0}), complex.vertex({t, 1}), complex.vertex({t, 2}), complex.vertex({t, 3})};
}

std::array<EdgeId, 6> edges_of(const Complex& complex, int t) {
  std::array<EdgeId, 6> edges;
  for (int e = 0; e < 6; ++e) edges[e] = complex.edge(TetEdge{t, e});
  return edges;
}

} // namespace

MaybeObstacle one_four(Complex& complex, int tet) {
  return fill(complex, one_four_ball(complex, tet));
}

MaybeObstacle four_one(Complex& complex, TetVertex v) {
  return fill(complex, four_one_ball(complex, v));
}

MaybeObstacle two_three(Complex& complex, TetFace f) {
  return fill(complex, two_three_ball(complex, f));
}

MaybeObstacle three_two(Complex& complex, DirectedTetEdge e) {
  return fill(complex, three_two_ball(complex, e));
}

MaybeObstacle four_four(Complex& complex, DirectedTetEdge e, int axis) {
  return fill(complex, four_four_ball(complex, e, axis));
}

MaybeObstacle why_not_two_zero_edge(const Complex& complex, DirectedTetEdge e) {
  Flattening flat;
  return plan_two_zero_edge(complex, e, flat);
}

MaybeObstacle two_zero_edge(Complex& complex, DirectedTetEdge e) {
  Flattening flat;
  if (const auto obstacle = plan_two_zero_edge(complex, e, flat)) return obstacle;
  const EdgeId edge = complex.edge(e);
  complex.begin_change();
  flatten(complex, flat);
  complex.remove_edge(edge);
  return std::nullopt;
}

MaybeObstacle why_not_two_zero_vertex(const Complex& complex, TetVertex v) {
  Flattening flat;
  return plan_two_zero_vertex(complex, v, flat);
}

MaybeObstacle two_zero_vertex(Complex& complex, TetVertex v) {
  Flattening flat;
  if (const auto obstacle = plan_two_zero_vertex(complex, v, flat)) return obstacle;
  const VertexId vertex = complex.vertex(v);
  std::array<EdgeId, 3> spokes;
  for (int c = 0; c < 3; ++c)
    spokes[c] = complex.edge(DirectedTetEdge{v.tet, v.vertex, face_vertex[v.vertex][c]});
  complex.begin_change();
  flatten(complex, flat);
  for (const EdgeId spoke : spokes) complex.remove_edge(spoke);
  complex.remove_vertex(vertex);
  return std::nullopt;
}

/// Draw the tetrahedron as p q a b with e = pq, its neighbour as w q a b. The 2-3 move leaves p w q a and
/// p w q b around e, which are pressed flat, and p w a b.
MaybeObstacle why_not_two_one(const Complex& complex, DirectedTetEdge e) {
  const EdgeId edge = complex.edge(e);
  if (complex.is_reversed(edge)) return Obstacle::reversed_edge;
  if (complex.is_boundary(edge)) return Obstacle::boundary_face;
  if (complex.valence(edge) != 1) return Obstacle::wrong_valence;
  const Gluing g = complex.gluing({e.tet, e.from});
  if (g.tet < 0) return Obstacle::boundary_face;
  if (g.tet == e.tet) return Obstacle::repeated_tetrahedron;
  const Perm4 hold = edge_frame(e.from, e.to);
  const int w = g.perm[hold[0]];
  const int a = g.perm[hold[2]];
  const int b = g.perm[hold[3]];
  const EdgeId wa = complex.edge(DirectedTetEdge{g.tet, w, a});
  const EdgeId wb = complex.edge(DirectedTetEdge{g.tet, w, b});
  const auto fixed = [&complex](EdgeId x) { return complex.is_boundary(x) || complex.is_reversed(x); };
  if (wa == wb || (fixed(wa) && fixed(wb))) return Obstacle::edges_form_cycle;
  const TetFace wqa{g.tet, b};
  const TetFace wqb{g.tet, a};
  const bool free_a = complex.is_boundary(wqa);
  if (free_a ? complex.is_boundary(wqb) : complex.partner(wqa) == wqb) return Obstacle::faces_form_cycle;
  return std::nullopt;
}

MaybeObstacle two_one(Complex& complex, DirectedTetEdge e) {
  if (const auto obstacle = why_not_two_one(complex, e)) return obstacle;
  if (const auto obstacle = two_three(complex, {e.tet, e.from})) return obstacle;
  const Change first = complex.last_change();
  // Corner 3 is e.from, corner `to` is e.to; the new tetrahedra have the corners 0134, 1234, 2034.
  const int to = face_corner(e.from, e.to);
  const int holder = to == 2 ? 1 : 0; // one that has the corner, as its vertex 0 or 1
  if (const auto obstacle = two_zero_edge(complex, {first.new_tets[holder], 2, to == 0 ? 0 : 1}))
    throw PreconditionError("two_one: the second half is impossible");
  Change whole = complex.last_change();
  whole.new_tets.clear();
  for (const int t : first.new_tets)
    if (complex.is_alive(t)) whole.new_tets.push_back(t);
  whole.removed_tets = first.removed_tets;
  whole.new_edges = first.new_edges;
  for (const int t : first.touched_tets)
    if (complex.is_alive(t)) whole.touched_tets.push_back(t);
  complex.set_last_change(std::move(whole));
  return std::nullopt;
}

MaybeObstacle why_not_zero_two_edge(const Complex& complex, DirectedTetEdge e, int turn) {
  const EdgeId edge = complex.edge(e);
  if (complex.is_reversed(edge)) return Obstacle::reversed_edge;
  if (turn < 1 || turn >= complex.valence(edge)) return Obstacle::wrong_valence;
  Walk w{e.tet, edge_frame(e.from, e.to)};
  const TetFace first = w.left_face();
  for (int k = 0; k < turn; ++k)
    if (!w.step_left(complex)) return Obstacle::boundary_face;
  const TetFace second = w.left_face();
  if (complex.is_boundary(second)) return Obstacle::boundary_face;
  if (first == second || complex.partner(first) == second) return Obstacle::same_face;
  return std::nullopt;
}

std::vector<int> zero_two_turns(const Complex& complex, DirectedTetEdge e) {
  const EdgeId edge = complex.edge(e);
  std::vector<int> turns;
  if (complex.is_reversed(edge)) return turns;
  Walk w{e.tet, edge_frame(e.from, e.to)};
  const TetFace first = w.left_face();
  for (int turn = 1; turn < complex.valence(edge) && w.step_left(complex); ++turn) {
    const TetFace second = w.left_face();
    if (!complex.is_boundary(second) && first != second && complex.partner(first) != second)
      turns.push_back(turn);
  }
  return turns;
}

MaybeObstacle zero_two_edge(Complex& complex, DirectedTetEdge e, int turn) {
  if (const auto obstacle = why_not_zero_two_edge(complex, e, turn)) return obstacle;
  complex.begin_change();
  const EdgeId whole = complex.edge(e);
  const Walk before_first{e.tet, edge_frame(e.from, e.to)}; // its left face is the first triangle
  Walk after_first = before_first;
  after_first.step_left(complex);
  Walk before_second = before_first;
  for (int k = 0; k < turn; ++k) before_second.step_left(complex);
  Walk after_second = before_second;
  after_second.step_left(complex);

  const EdgeId part = complex.add_edge(false); // the edge as the wedge between the triangles sees it
  complex.note_split(whole, part);
  Walk w = after_first;
  for (int k = 0; k < turn; ++k) {
    complex.relabel(w.edge(), part);
    w.step_left(complex);
  }
  // Both tetrahedra of the pillow: 0 and 1 are the ends, 2 the third corner of the first triangle, 3 that of
  // the second; the new edge is 23. Outside the wedge lies `outer`, inside `inner`.
  const auto corner = [&complex](const Walk& at, int k) { return complex.vertex({at.tet, at.hold[k]}); };
  const auto side = [&complex](const Walk& at, int i, int j) {
    return complex.edge(DirectedTetEdge{at.tet, at.hold[i], at.hold[j]});
  };
  const std::array<VertexId, 4> vertices{corner(before_first, 0), corner(before_first, 1),
                                         corner(before_first, 2), corner(before_second, 2)};
  std::array<EdgeId, 6> edges{whole,
                              side(before_first, 0, 2),
                              side(before_second, 0, 2),
                              side(before_first, 1, 2),
                              side(before_second, 1, 2),
                              complex.add_edge(false)};
  complex.unglue(before_first.left_face());
  complex.unglue(before_second.left_face());
  const int outer = complex.add_tet(vertices, edges);
  edges[0] = part;
  const int inner = complex.add_tet(vertices, edges);
  for (const int end : {0, 1}) complex.glue({outer, end}, inner, Perm4());
  const Perm4 first_map(0, 1, 2, 3);  // the first triangle is 012
  const Perm4 second_map(0, 1, 3, 2); // the second is 013
  complex.glue(before_first.left_face(), outer, first_map * before_first.hold.inverse());
  complex.glue(after_first.right_face(), inner, Perm4(0, 1, 3, 2) * after_first.hold.inverse());
  complex.glue(before_second.left_face(), inner, second_map * before_second.hold.inverse());
  complex.glue(after_second.right_face(), outer, Perm4(0, 1, 2, 3) * after_second.hold.inverse());
  return std::nullopt;
}

MaybeObstacle why_not_zero_two_face(const Complex& complex, TetFace f) {
  if (complex.is_boundary(f)) return Obstacle::boundary_face;
  return std::nullopt;
}

MaybeObstacle zero_two_face(Complex& complex, TetFace f) {
  if (const auto obstacle = why_not_zero_two_face(complex, f)) return obstacle;
  complex.begin_change();
  const Gluing g = complex.gluing(f);
  auto vertices = vertices_of(complex, f.tet);
  auto edges = edges_of(complex, f.tet);
  vertices[f.face] = complex.add_vertex(LinkKind::sphere);
  for (const int v : face_vertex[f.face]) edges[edge_number[f.face][v]] = complex.add_edge(false);
  complex.unglue(f);
  const int near = complex.add_tet(vertices, edges);
  const int far = complex.add_tet(vertices, edges);
  for (const int v : face_vertex[f.face]) complex.glue({near, v}, far, Perm4());
  complex.glue(f, near, Perm4());
  complex.glue({far, f.face}, g.tet, g.perm);
  return std::nullopt;
}

} // namespace tetrarch::moves
