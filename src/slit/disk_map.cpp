// SPDX-License-Identifier: GPL-2.0-or-later
#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/slit/circular_map.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace tetrarch::slit {

namespace {

using surface::Side;

/// The speed of the angle at the vertices of a loop. Fluxes are averages of it over both edges at a vertex. A
/// corner without a neighbor inside has the flux 0 on any mesh; its speed lies between those beside it, whose
/// logs are averaged, as they may differ by powers of ten.
std::vector<double> densities(const std::vector<double>& flux, const std::vector<double>& length) {
  const std::size_t n = flux.size();
  std::vector<double> result(n);
  for (std::size_t j = 0; j < n; ++j) result[j] = 2 * flux[j] / (length[j] + length[(j + n - 1) % n]);
  const std::vector<double> known = result;
  for (std::size_t j = 0; j < n; ++j) {
    if (known[j] != 0) continue;
    std::size_t before = 1;
    std::size_t after = 1;
    while (before < n && known[(j + n - before) % n] == 0) ++before;
    while (after < n && known[(j + after) % n] == 0) ++after;
    const double a = known[(j + n - before % n) % n];
    const double b = known[(j + after) % n];
    if (!(a > 0 && b > 0)) continue;
    const double part = static_cast<double>(before) / static_cast<double>(before + after);
    result[j] = std::exp((1 - part) * std::log(a) + part * std::log(b));
  }
  return result;
}

/// The angle at the vertices of the loop, from 0 on. Throws InputError where doubles do not tell them apart.
std::vector<double> angles_round(const surface::TriangleMesh& mesh, const surface::BoundaryLoop& loop,
                                 const std::vector<double>& flux) {
  const surface::Surface& surface = mesh.surface;
  std::vector<double> length;
  std::vector<double> here;
  for (const surface::SideEnd e : loop.sides) {
    length.push_back(numeric::distance(mesh.points[surface.from(e.side)], mesh.points[surface.to(e.side)]));
    here.push_back(flux[surface.vertex(e)]);
  }
  const std::vector<double> density = densities(here, length);
  const std::size_t n = length.size();
  std::vector<double> angle{0};
  int lost = 0;
  constexpr double least_step = 1e-14; // angles up to a full turn are known to about a tenth of that
  for (std::size_t j = 0; j < n; ++j) {
    const double step = length[j] * (density[j] + density[(j + 1) % n]) / 2;
    lost += static_cast<int>(std::abs(step) < least_step);
    angle.push_back(angle.back() + step);
  }
  if (lost > 0)
    throw InputError("no disk in doubles holds this surface: " + std::to_string(lost) + " of " +
                     std::to_string(n) +
                     " boundary edges would be shorter than 1e-14 on the circle, as they lie so far from the "
                     "center; another center may see them, and a second hole makes a ring of it");
  const double total = angle.back();
  angle.pop_back();
  for (double& x : angle) x *= full_turn / total;
  return angle;
}

} // namespace

int innermost_vertex(const surface::TriangleMesh& mesh) {
  const surface::Surface& surface = mesh.surface;
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

CircularMap disk_map(const surface::TriangleMesh& mesh, int center) {
  const surface::Surface& surface = mesh.surface;
  const SurfaceType type = surface::type_of(surface);
  const auto loops = surface::boundary_loops(mesh);
  if (!type.orientable || type.euler != 1 || loops.size() != 1)
    throw InputError("Riemann's map needs a disk, but this surface has type " + type.str());
  const std::vector<int> loop = surface::loops_of_vertices(loops, surface);
  if (center < 0 || center >= surface.vertex_count() || loop[center] >= 0)
    throw InputError("the center of the disk must be an interior vertex");
  const std::vector<double> weight = surface::half_cotangents(mesh);
  std::vector<char> held;
  held.reserve(loop.size());
  for (const int k : loop) held.push_back(k >= 0);
  const surface::LaplaceSolver solver(surface, weight, held);
  surface::LaplaceSolver::Columns data(1, std::vector<double>(held.size(), 0.0));
  data[0][center] = -full_turn;
  const std::vector<double> flux = surface::fluxes(surface, weight, solver.solve(data)[0]);

  const std::vector<double> angle = angles_round(mesh, loops[0], flux);
  data.assign(2, std::vector<double>(held.size(), 0.0));
  for (std::size_t j = 0; j < angle.size(); ++j) {
    data[0][surface.vertex(loops[0].sides[j])] = std::cos(angle[j]);
    data[1][surface.vertex(loops[0].sides[j])] = std::sin(angle[j]);
  }
  const surface::LaplaceSolver::Columns position = solver.solve(data);
  CircularMap result;
  result.loop = {0};
  result.domain.circles = {{0, 1, 0}};
  result.domain.found = true;
  for (std::size_t v = 0; v < held.size(); ++v) result.position.emplace_back(position[0][v], position[1][v]);
  return result;
}

} // namespace tetrarch::slit
