// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/ball.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tetrarch::moves {
namespace {

using Triple = std::array<int, 3>;

Triple face_corners(const Corners& corners, int face) {
  Triple t{corners[face_vertex[face][0]], corners[face_vertex[face][1]], corners[face_vertex[face][2]]};
  std::sort(t.begin(), t.end());
  return t;
}

/// The permutation that matches equal corners of two tetrahedra along a shared face, and face to face.
Perm4 matching(const Corners& a, int face_a, const Corners& b, int face_b) {
  std::array<int, 4> image{};
  image[face_a] = face_b;
  for (const int v : face_vertex[face_a])
    image[v] = static_cast<int>(std::find(b.begin(), b.end(), a[v]) - b.begin());
  return {image[0], image[1], image[2], image[3]};
}

/// The faces of a collection of tetrahedra by their corners: one entry on the boundary of the ball, two
/// inside.
std::map<Triple, std::vector<TetFace>> faces_by_corners(const std::vector<Corners>& tets) {
  std::map<Triple, std::vector<TetFace>> faces;
  for (int k = 0; k < static_cast<int>(tets.size()); ++k)
    for (int f = 0; f < 4; ++f) faces[face_corners(tets[k], f)].push_back({k, f});
  return faces;
}

/// Keeps what lies outside the ball: the renaming and the gluings among the survivors.
Replaced keep_outside(const Triangulation& tri, const std::vector<int>& place) {
  Replaced out{Triangulation(), std::vector<int>(place.size(), -1), 0};
  for (int t = 0; t < tri.size(); ++t)
    if (place[t] < 0) out.image[t] = out.first_new++;
  out.tri.add_tetrahedra(out.first_new);
  for (int t = 0; t < tri.size(); ++t) {
    if (place[t] >= 0) continue;
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet >= 0 && place[g.tet] < 0 && out.tri.is_boundary({out.image[t], f}))
        out.tri.glue({out.image[t], f}, out.image[g.tet], g.perm);
    }
  }
  return out;
}

bool all_different(const std::vector<Placed>& tets) {
  for (std::size_t i = 0; i < tets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (tets[i].tet == tets[j].tet) return false;
  return true;
}

/// The tetrahedra around an interior edge of valence `wanted`: its ends at corners `wanted` and `wanted` + 1,
/// the ring at corners 0 .. wanted-1, the left vertex of the first tetrahedron at 0.
std::variant<std::vector<Placed>, Obstacle> star(const Triangulation& tri, DirectedTetEdge e, int wanted) {
  const Walk start{e.tet, edge_frame(e.from, e.to)};
  Walk w = start;
  std::vector<Placed> tets;
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

const char* to_string(Obstacle obstacle) {
  switch (obstacle) {
  case Obstacle::boundary_face:
    return "on the boundary";
  case Obstacle::wrong_valence:
    return "the edge has another valence";
  case Obstacle::repeated_tetrahedron:
    return "a tetrahedron would be needed twice";
  }
  return "";
}

Replaced replace(const Triangulation& tri, const Ball& ball) {
  std::vector<int> place(static_cast<std::size_t>(tri.size()), -1);
  std::vector<Corners> before;
  for (const Placed& p : ball.before) {
    place[p.tet] = static_cast<int>(before.size());
    before.push_back(p.corners);
  }
  const auto old_faces = faces_by_corners(before);
  const auto new_faces = faces_by_corners(ball.after);
  const auto boundary = [](const auto& faces, const Triple& corners) {
    const auto at = faces.find(corners);
    return at != faces.end() && at->second.size() == 1 ? at->second[0] : TetFace{};
  };
  Replaced out = keep_outside(tri, place);
  const int first = out.tri.add_tetrahedra(static_cast<int>(ball.after.size()));
  for (const auto& [corners, where] : new_faces) {
    const auto [k, f] = where[0];
    if (where.size() == 2) {
      const auto [l, g] = where[1];
      out.tri.glue({first + k, f}, first + l, matching(ball.after[k], f, ball.after[l], g));
      continue;
    }
    const TetFace old = boundary(old_faces, corners);
    if (old.tet < 0) throw PreconditionError("the two sides of the move have different boundaries");
    const Perm4 back = matching(ball.after[k], f, before[old.tet], old.face);
    const Gluing g = tri.gluing({ball.before[old.tet].tet, old.face});
    if (g.tet < 0 || !out.tri.is_boundary({first + k, f})) continue;
    if (place[g.tet] < 0) {
      out.tri.glue({first + k, f}, out.image[g.tet], g.perm * back);
      continue;
    }
    // The ball is glued to itself here: find the new face that takes the partner's place.
    const TetFace partner{place[g.tet], g.perm[old.face]};
    const TetFace there = boundary(new_faces, face_corners(before[partner.tet], partner.face));
    if (there.tet < 0) throw PreconditionError("the two sides of the move have different boundaries");
    const Perm4 forth = matching(before[partner.tet], partner.face, ball.after[there.tet], there.face);
    out.tri.glue({first + k, f}, first + there.tet, forth * g.perm * back);
  }
  return out;
}

BallOrObstacle two_three(const Triangulation& tri, TetFace f) {
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

BallOrObstacle three_two(const Triangulation& tri, DirectedTetEdge e) {
  auto around = star(tri, e, 3);
  if (const auto* obstacle = std::get_if<Obstacle>(&around)) return *obstacle;
  return Ball{std::get<0>(std::move(around)), {{0, 1, 2, 3}, {1, 0, 2, 4}}};
}

BallOrObstacle four_four(const Triangulation& tri, DirectedTetEdge e, int axis) {
  auto around = star(tri, e, 4);
  if (const auto* obstacle = std::get_if<Obstacle>(&around)) return *obstacle;
  const int p = axis;
  const int q = axis + 1;
  const int r = axis + 2;
  const int s = (axis + 3) % 4;
  return Ball{std::get<0>(std::move(around)), {{p, r, q, 4}, {r, p, q, 5}, {r, p, s, 4}, {p, r, s, 5}}};
}

} // namespace tetrarch::moves
