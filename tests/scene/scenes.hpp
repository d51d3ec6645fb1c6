// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Small scenes, and what can be said of any surface.

#include "tetrarch/scene/scene.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::scene::test {

inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double inner(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Point& a) {
  return std::sqrt(inner(a, a));
}
inline double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// By the divergence theorem; positive if the triangles are counter-clockwise from outside.
inline double enclosed_volume(const Surface& s) {
  double six = 0;
  for (const auto& [a, b, c] : s.triangles) six += determinant(s.points[a], s.points[b], s.points[c]);
  return six / 6;
}

/// Whether every edge is there once in each direction.
inline bool is_closed(const Surface& s) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!edges.insert({t[i], t[(i + 1) % 3]}).second) return false;
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) return false;
  return true;
}

/// V - E + F of a closed surface all of whose points are used.
inline int euler_characteristic(const Surface& s) {
  return static_cast<int>(s.points.size()) - static_cast<int>(s.triangles.size() / 2);
}

/// n x n x n unit cubes as hexahedra, with data `cell`, the number of the cell.
inline Cells cubes(int n) {
  Cells cells;
  cells.name = "cubes";
  const auto id = [n](int x, int y, int z) { return (z * (n + 1) + y) * (n + 1) + x; };
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        cells.points.push_back({double(x), double(y), double(z)});
        cells.textures.push_back({x / 8.0, y / 8.0, z / 8.0});
      }
  cells.data = {{"cell", {}}};
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        cells.data[0].values.push_back(static_cast<int>(cells.hexahedra.size()));
        cells.hexahedra.push_back({id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z),
                                   id(x, y, z + 1), id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1),
                                   id(x, y + 1, z + 1)});
      }
  return cells;
}

/// Each of these cubes cut into the six tetrahedra around its diagonal from corner 0 to corner 6, every other
/// one mirrored.
inline Cells cut_cubes(int n) {
  Cells cells = cubes(n);
  cells.data[0].values.clear();
  constexpr std::array<std::array<int, 2>, 6> middle{{{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}};
  for (std::size_t k = 0; k < cells.hexahedra.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) {
      const auto& h = cells.hexahedra[k];
      std::array<int, 4> tet{h[0], h[middle[i][0]], h[middle[i][1]], h[6]};
      if (i % 2 == 1) std::swap(tet[0], tet[3]);
      cells.tetrahedra.push_back(tet);
      cells.data[0].values.push_back(static_cast<int>(k));
    }
  cells.hexahedra.clear();
  return cells;
}

/// A unit square of two triangles of different colours, with everything that a surface can have.
inline Surface square() {
  Surface s;
  s.name = "unit square";
  s.points = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.1}};
  s.normals.assign(4, {0, 0, 1});
  s.textures = {{0, 0}, {1, 0}, {1, 0.25}, {0, 1}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.colors = {{255, 0, 0, 255}, {0, 0, 128, 64}};
  s.data = {{"tetrahedron", {4, 5}}, {"face", {1, 2}}};
  return s;
}

/// A bent one and a straight one.
inline Tubes tubes() {
  Tubes t;
  t.name = "edges";
  t.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0, 0}, {-1, -1, -1}};
  t.radii = {0.1, 0.1, 0.05, 0.1, 0.2};
  t.starts = {0, 3, 5};
  t.colors = {{0, 255, 0, 255}, {1, 2, 3, 255}};
  t.data = {{"edge", {7, 8}}};
  return t;
}

/// Something of each kind: 2 triangles, 2 polylines, 1 hexahedron, 6 tetrahedra, 1 label.
inline Scene one_of_each() {
  Scene scene;
  scene.title = "One & \"all\"";
  scene.surfaces = {square()};
  scene.tubes = {tubes()};
  scene.cells = {cubes(1), cut_cubes(1)};
  scene.labels = {{{0, 0, 1.25}, "north"}};
  return scene;
}

} // namespace tetrarch::scene::test
