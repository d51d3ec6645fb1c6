// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One tetrahedron and its local numbering: the t-vertices, t-edges and t-faces of the dissertation
/// (section 4.2.1).
///
///            0            Vertices 0..3; face i lies opposite vertex i.
///           /|\           Edges 01,02,03,12,13,23 are numbered 0..5, so opposite edges sum to 5.
///          / | \          (Regina numbers edges alike; SnapPea's edge e is our 5 - e.)
///         3--|--1         Positively handed: from outside, face 0 shows 1,2,3 counterclockwise (as drawn,
///          \ | /          edge 02 in front), that is, det(v1-v0, v2-v0, v3-v0) > 0. A gluing of two
///           \|/           positively handed tetrahedra keeps orientations iff its permutation is odd.
///            2
///
/// Tetrahedra are plain indices `int`; a local simplex is a tetrahedron and a local number.

#include "tetrarch/core/perm4.hpp"

#include <array>
#include <compare>

namespace tetrarch {

/// The t-vertex `vertex` of tetrahedron `tet`.
struct TetVertex {
  int tet = -1;
  int vertex = 0;
  friend constexpr auto operator<=>(TetVertex, TetVertex) = default;
};

/// The t-edge `edge` of tetrahedron `tet`, without a direction.
struct TetEdge {
  int tet = -1;
  int edge = 0;
  friend constexpr auto operator<=>(TetEdge, TetEdge) = default;
};

/// The t-face `face` of tetrahedron `tet`, without an orientation.
struct TetFace {
  int tet = -1;
  int face = 0;
  friend constexpr auto operator<=>(TetFace, TetFace) = default;
};

/// The directed t-edge e_{from,to}: starts at t-vertex `from`, ends at t-vertex `to`.
struct DirectedTetEdge {
  int tet = -1;
  int from = 0;
  int to = 1;
  friend constexpr auto operator<=>(DirectedTetEdge, DirectedTetEdge) = default;
};

/// The oriented t-face f_{abc}: covers t-vertices a, b, c, read counterclockwise. Rotations of (a,b,c) name
/// the same oriented t-face; `canonical` turns the smallest to the front, and equality compares canonical
/// forms.
struct OrientedTetFace {
  int tet = -1;
  int a = 0;
  int b = 1;
  int c = 2;

  constexpr int face() const { return 6 - a - b - c; }
  constexpr OrientedTetFace reversed() const { return {tet, a, c, b}; }
  constexpr OrientedTetFace canonical() const {
    OrientedTetFace f = *this;
    while (f.a > f.b || f.a > f.c) f = {tet, f.b, f.c, f.a};
    return f;
  }
  friend constexpr bool operator==(const OrientedTetFace& p, const OrientedTetFace& q) {
    const OrientedTetFace f = p.canonical();
    const OrientedTetFace g = q.canonical();
    return f.tet == g.tet && f.a == g.a && f.b == g.b && f.c == g.c;
  }
};

/// edge_vertex[e] = the two t-vertices of edge e, in increasing order.
inline constexpr std::array<std::array<int, 2>, 6> edge_vertex{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// edge_number[i][j] = the edge that joins t-vertices i != j (-1 on the diagonal).
inline constexpr std::array<std::array<int, 4>, 4> edge_number{
    {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};

/// face_vertex[f][c] = the c-th t-vertex of face f, in increasing order; face_corner(f, v) is the c with that
/// value v.
inline constexpr std::array<std::array<int, 3>, 4> face_vertex{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
constexpr int face_corner(int f, int v) {
  return v < f ? v : v - 1;
}

constexpr int opposite_edge(int e) {
  return 5 - e;
}

/// The even permutation that takes 0,1 to i,j: the edge ij with a positively handed frame around it.
constexpr Perm4 edge_frame(int i, int j) {
  int k = 0;
  while (k == i || k == j) ++k;
  const int l = 6 - i - j - k;
  const Perm4 p(i, j, k, l);
  return p.sign() > 0 ? p : Perm4(i, j, l, k);
}

/// Face f of a positively handed tetrahedron as seen from outside: (f,a,b,c) is even.
constexpr OrientedTetFace outward(TetFace f) {
  const std::array<std::array<int, 3>, 4> cycle{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const auto& v = cycle[f.face];
  return {f.tet, v[0], v[1], v[2]};
}

} // namespace tetrarch
