// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/body.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetrarch::show {

namespace {

using embed::center;
using embed::corner;
using embed::cross;
using embed::Domain;
using embed::face_normal;
using embed::inner;
using hyperbolic::VertexType;

constexpr Vector4 geodesic{};

/// Turns the corners counter-clockwise as seen from where the normal points to.
void orient(Patch& patch) {
  const Vector4 middle = embed::centroid(patch.corners);
  if (inner(cross(middle, patch.corners[0], patch.corners[1]), patch.normal) < 0) return;
  std::reverse(patch.corners.begin(), patch.corners.end());
  // Side k came before corner k+1; now it comes after: the last side stays where it is.
  std::reverse(patch.cusps.begin(), patch.cusps.end() - 1);
}

/// The hexagon of face f; an ideal vertex is cut off along a horocycle, a finite one is a single corner.
Patch face_patch(const Domain<double>& domain, const Skeleton& skeleton, TetFace f) {
  const auto& v = domain.vertices[f.tet];
  const auto& types = domain.types[f.tet];
  Patch patch{Patch::Kind::face,
              {},
              {},
              face_normal(v, f.face),
              f.tet,
              skeleton.face(f).value,
              domain.gluable[f.tet][f.face] < 0};
  for (int k = 0; k < 3; ++k) {
    const int before = face_vertex[f.face][(k + 2) % 3];
    const int at = face_vertex[f.face][k];
    const int after = face_vertex[f.face][(k + 1) % 3];
    if (types[at] != VertexType::finite) {
      patch.corners.push_back(corner(v, types, at, before));
      patch.cusps.push_back(types[at] == VertexType::ideal ? v[at] : geodesic);
    }
    patch.corners.push_back(corner(v, types, at, after));
    patch.cusps.push_back(geodesic);
  }
  orient(patch);
  return patch;
}

Patch truncation_patch(const Domain<double>& domain, const Skeleton& skeleton, TetVertex at) {
  const auto& v = domain.vertices[at.tet];
  const auto& types = domain.types[at.tet];
  const bool cusp = types[at.vertex] == VertexType::ideal;
  Patch patch{cusp ? Patch::Kind::cusp : Patch::Kind::boundary,
              {},
              {},
              v[at.vertex],
              at.tet,
              skeleton.vertex(at).value,
              false};
  for (const int j : face_vertex[at.vertex]) {
    patch.corners.push_back(corner(v, types, at.vertex, j));
    patch.cusps.push_back(cusp ? v[at.vertex] : geodesic);
  }
  orient(patch);
  return patch;
}

/// Per t-edge, the t-edge that draws it: those that faces inside the domain identify have one in common.
std::vector<int> drawn_edges(const Triangulation& tri, const Domain<double>& domain) {
  std::vector<int> root(6 * static_cast<std::size_t>(tri.size()));
  std::iota(root.begin(), root.end(), 0);
  for (int t = 0; t < tri.size(); ++t)
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertex[e];
      for (int f = 0; f < 4; ++f) {
        if (f == i || f == j || domain.gluable[t][f] >= 0) continue;
        const auto [other, perm] = tri.gluing({t, f});
        root[numeric::find_root(root, 6 * t + e)] =
            numeric::find_root(root, 6 * other + edge_number[perm[i]][perm[j]]);
      }
    }
  for (std::size_t e = 0; e < root.size(); ++e) root[e] = numeric::find_root(root, static_cast<int>(e));
  return root;
}

void add_arcs(const Triangulation& tri, const Skeleton& skeleton, const Domain<double>& domain, Body& body) {
  const std::vector<int> drawn = drawn_edges(tri, domain);
  for (int t = 0; t < tri.size(); ++t) {
    const auto& v = domain.vertices[t];
    const auto& types = domain.types[t];
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertex[e];
      body.arcs.push_back({corner(v, types, i, j), corner(v, types, j, i), geodesic, true, t,
                           skeleton.edge({t, e}).value,
                           drawn[6 * static_cast<std::size_t>(t) + e] != 6 * t + e});
    }
    for (int i = 0; i < 4; ++i) {
      if (types[i] == VertexType::finite) continue;
      for (int f = 0; f < 4; ++f) {
        if (f == i) continue;
        const auto [j, k] = edge_vertex[opposite_edge(edge_number[i][f])];
        const bool elsewhere = domain.gluable[t][f] < 0 && tri.partner({t, f}) < TetFace{t, f};
        body.arcs.push_back({corner(v, types, i, j), corner(v, types, i, k),
                             types[i] == VertexType::ideal ? v[i] : geodesic, false, t,
                             skeleton.vertex({t, i}).value, elsewhere});
      }
    }
  }
}

} // namespace

Body body_of(const Triangulation& tri, const Skeleton& skeleton, const Domain<double>& domain,
             const embed::Piece& piece) {
  skeleton.require_current(tri);
  Body body;
  body.name = "fundamental domain";
  body.half_space = domain.half_space;
  body.copies = piece.copies;
  body.length = piece.length;
  for (int t = 0; t < tri.size(); ++t) {
    for (int f = 0; f < 4; ++f) body.patches.push_back(face_patch(domain, skeleton, {t, f}));
    for (int i = 0; i < 4; ++i)
      if (domain.types[t][i] != VertexType::finite)
        body.patches.push_back(truncation_patch(domain, skeleton, {t, i}));
    body.parent.push_back(domain.entrance[t].tet);
    body.middle.push_back(center(domain.vertices[t], domain.types[t]));
  }
  add_arcs(tri, skeleton, domain, body);
  return body;
}

Body body_of(const Skeleton& skeleton, const embed::BoundaryLift& lift, const embed::Piece& piece) {
  const bool cusp = lift.type == VertexType::ideal;
  const Vector4 surface = cusp ? Vector4{0, 0, 1, 1} : Vector4{0, -1, 0, 0};
  Body body;
  body.name = (cusp ? "cusp " : "boundary ") + std::to_string(lift.vertex.value) + " (" +
              skeleton.link(lift.vertex).str() + ")";
  body.view = cusp ? View::horizontal : View::vertical;
  body.half_space = embed::identity<double>();
  body.parent = lift.parent;
  body.copies = piece.copies;
  body.length = piece.length;
  for (std::size_t k = 0; k < lift.corners.size(); ++k) {
    const auto& c = lift.corners[k];
    const Vector4 curve = cusp ? surface : geodesic;
    Patch patch{cusp ? Patch::Kind::cusp : Patch::Kind::boundary,
                {c[0], c[1], c[2]},
                {curve, curve, curve},
                surface,
                static_cast<int>(k),
                lift.vertex.value,
                false};
    orient(patch);
    for (int s = 0; s < 3; ++s)
      body.arcs.push_back({patch.corners[s], patch.corners[(s + 1) % 3], curve, false, static_cast<int>(k),
                           lift.vertex.value, false});
    body.middle.push_back(embed::centroid(patch.corners));
    body.patches.push_back(std::move(patch));
  }
  return body;
}

void keep_nearest(Body& body, std::size_t count) {
  std::vector<std::size_t> order(body.copies.size());
  std::iota(order.begin(), order.end(), 0);
  // The last entry is the hyperbolic cosine of the distance; copies as far as each other stay in their order.
  const auto ring = [&body](std::size_t c) { return std::llround(std::log(body.copies[c][3][3]) * 1e6); };
  std::stable_sort(order.begin(), order.end(),
                   [&ring](std::size_t a, std::size_t b) { return ring(a) < ring(b); });
  order.resize(std::min(count, order.size()));
  std::vector<Matrix4> copies;
  std::vector<int> length;
  for (const std::size_t c : order) {
    copies.push_back(body.copies[c]);
    length.push_back(body.length[c]);
  }
  body.copies = std::move(copies);
  body.length = std::move(length);
}

} // namespace tetrarch::show
