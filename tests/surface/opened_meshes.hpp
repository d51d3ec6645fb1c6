// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Meshes to be opened.

#include "support/surface_soups.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/surface/opened.hpp"

namespace tetrarch::surface::test {

inline OpenedMesh opened(const support::TriangleList& list) {
  return OpenedMesh(doctor::build_surface(support::soups::surface_soup(list)));
}

/// A square of 10 x 10 unit squares in the plane z = 0; triangles 2 (10 i + j) and the next are square (i,
/// j).
inline OpenedMesh plane() {
  support::TriangleList list = support::detail::grid(10, 10, [](int i, int j) { return 11 * i + j; });
  list.vertices = 121;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) list.points.push_back({1.0 * i, 1.0 * j, 0});
  return opened(list);
}
/// Its vertex at (i, j, 0).
inline long long at(int i, int j) {
  return 11 * i + j;
}

/// Whether it still is a mesh; zero areas and the like apart.
inline bool is_valid(const TriangleMesh& mesh) {
  const format::Soup soup = support::soups::surface_soup(mesh.points, mesh.surface.triangles());
  return doctor::validate_surface(soup).count(doctor::Severity::fatal) == 0;
}

} // namespace tetrarch::surface::test
