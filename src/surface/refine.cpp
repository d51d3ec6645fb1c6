// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/refine.hpp"

namespace tetrarch::surface {

TriangleMesh refined(const TriangleMesh& mesh) {
  const Surface& surface = mesh.surface;
  TriangleMesh fine;
  fine.points = mesh.points;
  std::vector<int> middle(static_cast<std::size_t>(surface.side_count()), -1);
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    if (middle[k] >= 0) continue;
    middle[k] = static_cast<int>(fine.points.size());
    if (const Side m = surface.mate(s); m.exists()) middle[m.value] = middle[k];
    const auto& p = mesh.points[surface.from(s)];
    const auto& q = mesh.points[surface.to(s)];
    fine.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
  }
  std::vector<Surface::Triangle> triangles;
  triangles.reserve(4 * static_cast<std::size_t>(surface.triangle_count()));
  for (int t = 0; t < surface.triangle_count(); ++t) {
    for (int c = 0; c < 3; ++c) {
      Surface::Triangle corner{};
      corner[c] = surface.corners(t)[c];
      corner[(c + 1) % 3] = middle[Side(t, (c + 2) % 3).value];
      corner[(c + 2) % 3] = middle[Side(t, (c + 1) % 3).value];
      triangles.push_back(corner);
    }
    triangles.push_back({middle[Side(t, 0).value], middle[Side(t, 1).value], middle[Side(t, 2).value]});
  }
  fine.surface = Surface(static_cast<int>(fine.points.size()), std::move(triangles));
  return fine;
}

} // namespace tetrarch::surface
