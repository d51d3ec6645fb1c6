// SPDX-License-Identifier: GPL-2.0-or-later
#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/laplacian.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/slit/circular_map.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace tetrarch::slit {

using mesh::Side;

int innermost_vertex(const mesh::TriangleMesh& mesh) {
  const mesh::Surface& surface = mesh.surface;
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(surface.vertex_count()));
  std::vector<char> met(neighbours.size(), 0);
  std::vector<int> queue;
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    neighbours[surface.from(s)].push_back(surface.to(s));
    if (!surface.is_boundary(s)) continue;
    neighbours[surface.to(s)].push_back(surface.from(s));
    if (!std::exchange(met[surface.from(s)], 1)) queue.push_back(surface.from(s));
  }
  const std::size_t boundary = queue.size();
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const int v : neighbours[queue[next]])
      if (!std::exchange(met[v], 1)) queue.push_back(v);
  return queue.size() > boundary ? queue.back() : -1;
}

CircularMap disk_map(const mesh::TriangleMesh& mesh, int center) {
  const mesh::Surface& surface = mesh.surface;
  const SurfaceType type = mesh::type_of(surface);
  const auto loops = mesh::boundary_loops(mesh);
  if (!type.orientable || type.euler != 1 || loops.size() != 1)
    throw InputError("Riemann's map needs a disk, but this surface has type " + type.str());
  const std::vector<int> loop = mesh::loops_of_vertices(loops, surface);
  if (center < 0 || center >= surface.vertex_count() || loop[center] >= 0)
    throw InputError("the center of the disk must be an interior vertex");
  const std::vector<double> weight = mesh::half_cotangents(mesh);
  std::vector<char> held;
  held.reserve(loop.size());
  for (const int k : loop) held.push_back(k >= 0);
  const mesh::LaplaceSolver solver(surface, weight, held);
  mesh::LaplaceSolver::Columns data(1, std::vector<double>(held.size(), 0.0));
  data[0][center] = -full_turn;
  const std::vector<double> flux = mesh::fluxes(surface, weight, solver.solve(data)[0]);

  // Fluxes are averages of the density over both edges at a vertex, which is the speed of the angle.
  const auto& sides = loops[0].sides;
  const std::size_t n = sides.size();
  std::vector<double> length;
  length.reserve(n);
  for (const mesh::SideEnd e : sides)
    length.push_back(numeric::distance(mesh.points[surface.from(e.side)], mesh.points[surface.to(e.side)]));
  const auto density = [&](std::size_t j) {
    return 2 * flux[surface.vertex(sides[j % n])] / (length[j % n] + length[(j + n - 1) % n]);
  };
  data.assign(2, std::vector<double>(held.size(), 0.0));
  double angle = 0;
  for (std::size_t j = 0; j < n; ++j) {
    data[0][surface.vertex(sides[j])] = std::cos(angle);
    data[1][surface.vertex(sides[j])] = std::sin(angle);
    angle += length[j] * (density(j) + density(j + 1)) / 2;
  }
  const mesh::LaplaceSolver::Columns position = solver.solve(data);
  CircularMap result;
  result.loop = {0};
  result.domain.circles = {{0, 1, 0}};
  result.domain.found = true;
  for (std::size_t v = 0; v < held.size(); ++v) result.position.emplace_back(position[0][v], position[1][v]);
  return result;
}

} // namespace tetrarch::slit
