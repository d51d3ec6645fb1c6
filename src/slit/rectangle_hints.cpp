// SPDX-License-Identifier: GPL-2.0-or-later
#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/slit/ricci.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tetrarch::slit {
namespace {

using namespace numeric;
using Complex = std::complex<double>;

std::vector<int> vertices_of(const surface::Surface& surface, const surface::BoundaryLoop& loop) {
  std::vector<int> result;
  for (const surface::SideEnd e : loop.sides) result.push_back(surface.vertex(e));
  return result;
}

/// Of each vertex of the loop pi less the angles there, in space.
std::vector<double> turning_angles(const surface::TriangleMesh& mesh, const std::vector<int>& loop) {
  std::vector<double> angles(mesh.points.size(), 0.0);
  for (const auto& t : mesh.surface.triangles())
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector a = mesh.points[t[(c + 1) % 3]] - mesh.points[t[c]];
      const Vector b = mesh.points[t[(c + 2) % 3]] - mesh.points[t[c]];
      angles[t[c]] += std::atan2(length(cross(a, b)), dot(a, b));
    }
  std::vector<double> result;
  result.reserve(loop.size());
  for (const int v : loop) result.push_back(full_turn / 2 - angles[v]);
  return result;
}

bool have_neighbors(const std::array<std::size_t, 4>& places, std::size_t size) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((places[(c + 1) % 4] + size - places[c]) % size < 2) return true;
  return false;
}

} // namespace

std::array<int, 4> corners_of(const surface::TriangleMesh& mesh, const surface::BoundaryLoop& loop) {
  const std::vector<int> vertices = vertices_of(mesh.surface, loop);
  const std::size_t n = vertices.size();
  constexpr std::size_t fewest = 8;
  if (n < fewest)
    throw InputError("a loop of " + std::to_string(n) + " edges is too short for the sides of a rectangle");
  const std::vector<double> turn = turning_angles(mesh, vertices);
  std::vector<std::size_t> order(n);
  for (std::size_t j = 0; j < n; ++j) order[j] = j;
  std::partial_sort(order.begin(), order.begin() + 4, order.end(),
                    [&](std::size_t a, std::size_t b) { return turn[a] > turn[b]; });
  std::array<std::size_t, 4> places{order[0], order[1], order[2], order[3]};
  const bool are_sharp = turn[places[3]] > full_turn / 8;
  std::sort(places.begin(), places.end());
  if (!are_sharp || have_neighbors(places, n)) {
    double walked = 0;
    std::size_t corner = 0;
    for (std::size_t j = 0; j < n && corner < 4; ++j) {
      const double edge = length(mesh.points[vertices[(j + 1) % n]] - mesh.points[vertices[j]]);
      // Of few or uneven edges: two between corners at least, and as many left for those to come.
      const bool is_far = corner == 0 || j >= places[corner - 1] + 2;
      const bool is_last_chance = j + 2 * (4 - corner) >= n;
      const bool is_nearest = walked + edge / 2 > static_cast<double>(corner) * loop.length / 4;
      if (is_far && (is_nearest || is_last_chance)) places[corner++] = j;
      walked += edge;
    }
  }
  return {vertices[places[0]], vertices[places[1]], vertices[places[2]], vertices[places[3]]};
}

std::vector<std::array<int, 4>> rectangle_hints(const surface::TriangleMesh& mesh,
                                                const std::array<int, 4>& outer, const RicciOptions& options,
                                                const Progress& progress) {
  const auto loops = surface::boundary_loops(mesh);
  const int loop = surface::loop_through(loops, mesh.surface, outer[0]);
  if (loop < 0)
    throw InputError("vertex " + std::to_string(outer[0]) + " (counted from 0) is not on the boundary");
  std::vector<std::array<int, 4>> result{outer};
  if (loops.size() == 1) return result;
  Curvatures wanted;
  wanted.at.assign(mesh.points.size(), 0.0);
  for (const int v : outer) wanted.at[v] += full_turn / 4;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (static_cast<int>(k) != loop)
      wanted.round_holes.push_back(mesh.surface.vertex(loops[k].sides.front()));
  const ScaledMetric metric = scaled_metric(mesh, wanted, options, progress);
  if (!metric.found)
    throw InputError("there is no rectangle with round holes for these corners on this mesh");
  const std::vector<Complex> position = laid_out(metric.triangulation).position;
  const Complex along = position[outer[1]] - position[outer[0]];
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (static_cast<int>(k) == loop) continue;
    const std::vector<int> vertices = vertices_of(mesh.surface, loops[k]);
    auto& corners = result.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) {
      const Complex diagonal = std::polar(1.0, full_turn * (static_cast<double>(c) / 4 - 3.0 / 8)) * along;
      corners[c] = *std::max_element(vertices.begin(), vertices.end(), [&](int a, int b) {
        return (std::conj(diagonal) * position[a]).real() < (std::conj(diagonal) * position[b]).real();
      });
    }
  }
  return result;
}

} // namespace tetrarch::slit
