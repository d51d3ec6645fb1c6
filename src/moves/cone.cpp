// SPDX-License-Identifier: GPL-2.0-or-later
#include "boundary_walk.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/boundary_moves.hpp"

#include <algorithm>
#include <unordered_map>

namespace tetrarch::moves {
namespace {

using FaceNumbers = std::unordered_map<long long, int>;

long long key(TetFace f) {
  return 4LL * f.tet + f.face;
}

/// What lies beside each side of each triangle of a component: `at[k][c]` across the side opposite the c-th
/// t-vertex of triangle k.
struct Neighbours {
  std::vector<std::array<Beside, 3>> at;
  FaceNumbers number;
};

Neighbours neighbours_of(const Complex& complex, const std::vector<TetFace>& component) {
  Neighbours out;
  out.number.reserve(component.size());
  for (int k = 0; k < static_cast<int>(component.size()); ++k) out.number.emplace(key(component[k]), k);
  for (const TetFace f : component) {
    if (!complex.is_boundary(f)) throw PreconditionError("cone: a face is not on the boundary");
    out.at.emplace_back();
    for (int c = 0; c < 3; ++c) {
      out.at.back()[c] = boundary_beside(complex, f, face_vertex[f.face][c]);
      if (out.number.count(key(out.at.back()[c].face)) == 0)
        throw PreconditionError("cone: the triangles are not a whole boundary component");
    }
  }
  return out;
}

/// The edges from the apex: one for each corner of the surface, `of[k][c]` at the c-th t-vertex of triangle
/// k.
std::vector<std::array<EdgeId, 3>> add_spokes(Complex& complex, const std::vector<TetFace>& component,
                                              const Neighbours& beside, int& corners) {
  std::vector<std::array<EdgeId, 3>> of(component.size());
  corners = 0;
  for (int k = 0; k < static_cast<int>(component.size()); ++k)
    for (int c = 0; c < 3; ++c) {
      if (of[k][c].value >= 0) continue;
      const EdgeId spoke = complex.add_edge(false);
      ++corners;
      // Round the corner: leave each triangle by the side by which it was not entered.
      int at = k;
      int corner = face_vertex[component[k].face][c];
      int leave = face_vertex[component[k].face][(c + 1) % 3];
      while (true) {
        const TetFace f = component[at];
        EdgeId& place = of[at][face_corner(f.face, corner)];
        if (place.value >= 0) break;
        place = spoke;
        const Beside& next = beside.at[at][face_corner(f.face, leave)];
        const int entered = next.map[leave]; // the side entered lies opposite this corner
        at = beside.number.at(key(next.face));
        corner = next.map[corner];
        leave = 6 - next.face.face - corner - entered;
      }
    }
  return of;
}

} // namespace

std::vector<std::vector<TetFace>> boundary_faces(const Complex& complex) {
  std::vector<std::vector<TetFace>> components;
  std::unordered_map<long long, int> seen;
  for (int t = 0; t < complex.slot_count(); ++t) {
    if (!complex.is_alive(t)) continue;
    for (int f = 0; f < 4; ++f) {
      if (!complex.is_boundary({t, f}) || seen.count(key({t, f})) != 0) continue;
      std::vector<TetFace> component{{t, f}};
      seen.emplace(key({t, f}), 1);
      for (std::size_t k = 0; k < component.size(); ++k) {
        const TetFace at = component[k];
        for (const int v : face_vertex[at.face]) {
          const TetFace next = boundary_beside(complex, at, v).face;
          if (seen.emplace(key(next), 1).second) component.push_back(next);
        }
      }
      std::sort(component.begin(), component.end());
      components.push_back(std::move(component));
    }
  }
  return components;
}

MaybeObstacle why_not_cone(const Complex& complex, const std::vector<TetFace>& component) {
  for (const TetFace f : component)
    for (const int v : face_vertex[f.face])
      if (complex.link(complex.vertex({f.tet, v})) != LinkKind::disk) return Obstacle::bad_vertex;
  return std::nullopt;
}

MaybeObstacle cone(Complex& complex, const std::vector<TetFace>& component) {
  if (const auto obstacle = why_not_cone(complex, component)) return obstacle;
  const Neighbours beside = neighbours_of(complex, component);
  complex.begin_change();
  int corners = 0;
  const auto spokes = add_spokes(complex, component, beside, corners);
  const int triangles = static_cast<int>(component.size());
  const bool sphere = corners - triangles / 2 == 2; // V - E + F with E = 3F/2
  const VertexId apex = complex.add_vertex(sphere ? LinkKind::sphere : LinkKind::closed);
  std::vector<int> tets;
  for (int k = 0; k < triangles; ++k) {
    const TetFace f = component[k];
    std::array<VertexId, 4> vertices;
    std::array<EdgeId, 6> edges;
    for (int v = 0; v < 4; ++v) vertices[v] = v == f.face ? apex : complex.vertex({f.tet, v});
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertex[e];
      if (i == f.face || j == f.face)
        edges[e] = spokes[k][face_corner(f.face, i == f.face ? j : i)];
      else
        edges[e] = complex.edge(TetEdge{f.tet, e});
    }
    tets.push_back(complex.add_tet(vertices, edges));
  }
  for (int k = 0; k < triangles; ++k) {
    const TetFace f = component[k];
    complex.glue(f, tets[k], Perm4());
    for (const int v : face_vertex[f.face]) {
      const Beside& next = beside.at[k][face_corner(f.face, v)];
      if (complex.is_boundary({tets[k], v}))
        complex.glue({tets[k], v}, tets[beside.number.at(key(next.face))], next.map);
    }
  }
  for (const TetFace f : component)
    for (const int v : face_vertex[f.face]) {
      complex.set_link(complex.vertex({f.tet, v}), LinkKind::sphere);
      for (const int w : face_vertex[f.face])
        if (v < w) complex.set_boundary(complex.edge(DirectedTetEdge{f.tet, v, w}), false);
    }
  return std::nullopt;
}

} // namespace tetrarch::moves
