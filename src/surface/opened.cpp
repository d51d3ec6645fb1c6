// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/opened.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace tetrarch::surface {

OpenedMesh::OpenedMesh(TriangleMesh m, std::vector<long long> numbers)
    : mesh(std::move(m)), number(std::move(numbers)),
      triangle_of(static_cast<std::size_t>(mesh.surface.triangle_count())) {
  if (number.empty()) {
    number.resize(mesh.points.size());
    std::iota(number.begin(), number.end(), 0);
  }
  if (number.size() != mesh.points.size()) throw PreconditionError("a number for each vertex is needed");
  std::iota(triangle_of.begin(), triangle_of.end(), 0);
}

int vertex_numbered(const OpenedMesh& opened, long long number) {
  const auto found = std::find(opened.number.begin(), opened.number.end(), number);
  if (number < 0 || found == opened.number.end())
    throw InputError("there is no vertex " + std::to_string(number));
  return static_cast<int>(found - opened.number.begin());
}

OpenedMesh cut_along(const OpenedMesh& opened, const MarkedSurface& marked) {
  const Surface open = cut_open(marked);
  OpenedMesh out;
  out.mesh.points = marked.points;
  out.number = opened.number;
  out.number.resize(marked.points.size(), -1); // split vertices
  for (const int t : marked.origin) out.triangle_of.push_back(opened.triangle_of[t]);
  // The first copy of a vertex keeps its place.
  std::vector<char> has_copy(marked.points.size(), 0);
  std::vector<int> name(static_cast<std::size_t>(open.vertex_count()), -1);
  std::vector<Surface::Triangle> triangles = open.triangles();
  for (int t = 0; t < open.triangle_count(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const int old = marked.surface.corners(t)[c];
      int& copy = name[open.corners(t)[c]];
      if (copy < 0 && std::exchange(has_copy[old], 1) == 0) copy = old;
      if (copy < 0) {
        copy = static_cast<int>(out.number.size());
        out.mesh.points.push_back(marked.points[old]);
        out.number.push_back(out.number[old]);
      }
      triangles[t][c] = copy;
    }
  out.mesh.surface = Surface(static_cast<int>(out.number.size()), std::move(triangles));
  return out;
}

} // namespace tetrarch::surface
