// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tetrarch::checker {
namespace {

using Products = std::array<std::array<Interval, 4>, 4>;

/// G x = 1, and sqrt(-det G).
struct Hyperplane {
  std::array<Interval, 4> x;
  Interval root;
};

/// By elimination; nothing unless det G < 0.
std::optional<Hyperplane> hyperplane(Products g) {
  Hyperplane plane;
  plane.x = {1, 1, 1, 1};
  Interval determinant = 1;
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < 4; ++r)
      if (std::abs(g[r][c].nearest_double()) > std::abs(g[pivot][c].nearest_double())) pivot = r;
    if (pivot != c) {
      std::swap(g[pivot], g[c]);
      std::swap(plane.x[pivot], plane.x[c]);
      determinant = -determinant;
    }
    determinant = determinant * g[c][c];
    for (std::size_t r = c + 1; r < 4; ++r) {
      const Interval times = g[r][c] / g[c][c];
      for (std::size_t k = c; k < 4; ++k) g[r][k] = g[r][k] - times * g[c][k];
      plane.x[r] = plane.x[r] - times * plane.x[c];
    }
  }
  if (!less(determinant, Interval(0))) return std::nullopt;
  for (std::size_t c = 4; c-- > 0;) {
    for (std::size_t k = c + 1; k < 4; ++k) plane.x[c] = plane.x[c] - g[c][k] * plane.x[k];
    plane.x[c] = plane.x[c] / g[c][c];
  }
  plane.root = sqrt(-determinant);
  return plane;
}

std::array<Interval, 6> lengths_of(const OnBox& box, std::size_t tet) {
  std::array<Interval, 6> six;
  for (int e = 0; e < 6; ++e) six[e] = box.lengths[box.classes.edge[tet][e]];
  return six;
}

/// Of each class of vertices, what its vectors are multiplied by. Times s divides the area by s^2.
std::vector<Interval> scales(const OnBox& box, const Interval& wanted) {
  std::vector<Interval> area(box.classes.link.size());
  for (std::size_t t = 0; t < box.gluings.size(); ++t) {
    const Corners kinds = kinds_at(box.classes, static_cast<int>(t));
    const auto six = lengths_of(box, t);
    for (int v = 0; v < 4; ++v) {
      if (kinds[v] != 0) continue;
      const int a = v == 0 ? 1 : 0;
      const int b = v <= 1 ? 2 : 1;
      const int c = 6 - v - a - b;
      // Two sides and the angle between them, at the corner on the edge to a.
      std::size_t e = 0;
      while (ends_of_edge[e] != std::array{std::min(v, a), std::max(v, a)}) ++e;
      const Interval square = corner_side(six, kinds, v, a, b) * corner_side(six, kinds, v, a, c);
      Interval& sum = area[box.classes.vertex[t][v]];
      sum = sum + sqrt(square) * sin(box.angles[t][e]) / 2;
    }
  }
  std::vector<Interval> scale(area.size(), Interval(1));
  for (std::size_t v = 0; v < area.size(); ++v)
    if (box.classes.link[v] == 0) scale[v] = sqrt(area[v] / wanted);
  return scale;
}

std::string name_of(int tet, int face) {
  return "face " + std::to_string(face) + " of tetrahedron " + std::to_string(tet);
}

} // namespace

std::string fault_in_cells(const OnBox& box, const CellClaims& claims) {
  const auto& links = box.classes.link;
  if (*std::max_element(links.begin(), links.end()) > 0)
    return "with finite vertices there are no canonical cells";
  const bool cusps = std::find(links.begin(), links.end(), 0) != links.end();
  if (cusps == claims.cusp_area.empty()) return "an area is claimed for exactly those that have cusps";
  const std::vector<Interval> scale = scales(box, cusps ? Interval(claims.cusp_area) : Interval(1));
  std::vector<Hyperplane> planes;
  for (std::size_t t = 0; t < box.gluings.size(); ++t) {
    Products g = products(lengths_of(box, t), kinds_at(box.classes, static_cast<int>(t)));
    const auto& v = box.classes.vertex[t];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) g[i][j] = g[i][j] * scale[v[i]] * scale[v[j]];
    const auto plane = hyperplane(g);
    if (!plane) return "tetrahedron " + std::to_string(t) + " spans no space for certain";
    planes.push_back(*plane);
  }
  std::vector<std::array<bool, 4>> named(planes.size());
  for (const CellClaims::Face& face : claims.faces) {
    const FaceGluing& g = box.gluings[face.tet][face.face];
    const int far = g.images[face.face];
    if (named[face.tet][face.face]) return name_of(face.tet, face.face) + " is named twice";
    named[face.tet][face.face] = named[g.tet][far] = true;
    const Interval bend =
        planes[face.tet].x[face.face] * planes[face.tet].root + planes[g.tet].x[far] * planes[g.tet].root;
    const bool convex = less(bend, Interval(0));
    if (face.flat.empty() && !convex) return name_of(face.tet, face.face) + " is not proved to be convex";
    if (!face.flat.empty() && (convex || less(Interval(0), bend)))
      return name_of(face.tet, face.face) + " is not flat";
  }
  for (std::size_t t = 0; t < named.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (!named[t][f]) return "nothing is claimed of " + name_of(static_cast<int>(t), f);
  return {};
}

} // namespace tetrarch::checker
