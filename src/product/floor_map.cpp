// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/floor_map.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "rectangle_corners.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/slit/circular_map.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/slit/unflip.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

using Complex = std::complex<double>;
using surface::BoundaryLoop;

/// The floor's triangles as a mesh of their own.
FloorMap floor_of(const Solid& solid, const Partition& partition) {
  FloorMap floor;
  std::vector<int> number(solid.mesh.points.size(), -1);
  std::vector<surface::Surface::Triangle> triangles;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (partition.patch[t] != floor_patch) continue;
    surface::Surface::Triangle& triangle = triangles.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const int v = solid.corner(t, c);
      if (number[v] < 0) {
        number[v] = static_cast<int>(floor.vertex.size());
        floor.vertex.push_back(v);
        floor.mesh.points.push_back(solid.point(v));
      }
      triangle[c] = number[v];
    }
    std::swap(triangle[1], triangle[2]); // seen from inside
    floor.triangle.push_back(t);
  }
  floor.mesh.surface = surface::Surface(static_cast<int>(floor.vertex.size()), std::move(triangles));
  return floor;
}

/// Of each loop of the floor the wall beyond it, counted from 0.
std::vector<int> walls_of_loops(const Solid& solid, const Partition& partition, const FloorMap& floor,
                                const std::vector<BoundaryLoop>& loops) {
  std::vector<int> wall_at(solid.mesh.points.size(), -1);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3 && partition.patch[t] >= first_wall; ++c)
      wall_at[solid.corner(t, c)] = partition.patch[t] - first_wall;
  std::vector<int> walls;
  walls.reserve(loops.size());
  for (const BoundaryLoop& loop : loops)
    walls.push_back(wall_at[floor.vertex[floor.mesh.surface.vertex(loop.sides.front())]]);
  return walls;
}

/// The loop of each wall.
std::vector<int> loops_of_walls(const std::vector<int>& wall_of_loop) {
  std::vector<int> loop(wall_of_loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) loop[wall_of_loop[k]] = static_cast<int>(k);
  return loop;
}

double area_of(const surface::TriangleMesh& mesh, const surface::Surface::Triangle& corners) {
  const auto& p = mesh.points[corners[0]];
  return norm(cross(mesh.points[corners[1]] - p, mesh.points[corners[2]] - p)) / 2;
}

/// Moves what crowds near the rim of the disk inward, by the Moebius map of the disk after which the floor's
/// centroid is 0: circles stay circles. With one hole the map is a ring already.
void balance(FloorMap& floor) {
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round) {
    Complex center = 0;
    double area = 0;
    for (const auto& c : floor.mesh.surface.triangles()) {
      const double weight = area_of(floor.mesh, c);
      area += weight;
      center += weight * (floor.position[c[0]] + floor.position[c[1]] + floor.position[c[2]]) / 3.0;
    }
    center /= area;
    if (std::abs(center) < 1e-9) return;
    for (Complex& z : floor.position) z = (z - center) / (1.0 - std::conj(center) * z);
  }
}

/// The second route, which is slower where many holes crowd the disk.
void try_slit_map(const surface::TriangleMesh& mesh, const std::vector<int>& loop_of_wall,
                  slit::CircularMap& map, const Progress& progress) {
  try {
    const slit::OneForms forms(mesh, progress.silent(), slit::Edges::intrinsic_delaunay);
    map = slit::circular_map(forms, slit::slit_map(forms, loop_of_wall[0], loop_of_wall[1]), {},
                             progress.silent());
  } catch (const InputError&) { // what the first one left is not found either
  }
}

void map_to_circles(FloorMap& floor, const std::vector<BoundaryLoop>& loops,
                    const std::vector<int>& loop_of_wall, const Progress& progress) {
  slit::CircularMap map;
  if (loops.size() == 1) {
    const int center = slit::innermost_vertex(floor.mesh);
    if (center < 0)
      throw InputError(
          "all vertices of the floor are on its rim; the map of the floor needs an interior vertex");
    map = slit::disk_map(floor.mesh, center);
  } else {
    slit::RicciCircles circles =
        slit::ricci_circles(floor.mesh, loop_of_wall[0], loop_of_wall[1], {}, progress.silent());
    map = std::move(circles.map);
    if (!map.domain.found) try_slit_map(floor.mesh, loop_of_wall, map, progress);
  }
  slit::unflip_in_disk(floor.mesh, map, slit::Unflip::everywhere, progress.silent());
  floor.found = map.domain.found;
  floor.position = std::move(map.position);
  if (loops.size() > 2) balance(floor);
}

/// A loop by its vertices, in the order of walking, the floor to the left.
std::vector<int> vertices_of(const surface::Surface& surface, const BoundaryLoop& loop) {
  std::vector<int> vertices;
  vertices.reserve(loop.sides.size());
  for (const surface::SideEnd e : loop.sides) vertices.push_back(surface.vertex(e));
  return vertices;
}

std::array<int, 4> given_corners(const FloorMap& floor, const std::array<int, 4>& corners) {
  std::array<int, 4> inside{};
  for (int c = 0; c < 4; ++c) {
    const auto at = std::find(floor.vertex.begin(), floor.vertex.end(), corners[c]);
    if (at == floor.vertex.end())
      throw InputError("vertex " + std::to_string(corners[c]) +
                       " is meant as a corner, but it is not on the floor");
    inside[c] = static_cast<int>(at - floor.vertex.begin());
  }
  return inside;
}

void map_to_rectangles(FloorMap& floor, const std::vector<BoundaryLoop>& loops,
                       const std::vector<int>& loop_of_wall, const std::array<int, 4>& corners,
                       const Progress& progress) {
  std::vector<std::vector<int>> rims;
  for (const int loop : loop_of_wall) {
    rims.push_back(vertices_of(floor.mesh.surface, loops[loop]));
    if (rims.back().size() < 8)
      throw InputError("the rim of wall " + std::to_string(rims.size() - 1) + " on the floor has " +
                       std::to_string(rims.back().size()) + " edges; a rectangle needs at least 8");
  }
  auto place = shadow(floor.mesh, rims.front());
  if (!place) { // no plate: its circular map shows how the rims lie
    map_to_circles(floor, loops, loop_of_wall, progress);
    place = floor.position;
  }
  std::optional<std::array<int, 4>> given;
  if (corners[0] >= 0) given = given_corners(floor, corners);
  slit::RicciRectangles found;
  for (const CornerHints& hints : corner_guesses(floor.mesh, rims, *place, given)) {
    progress.step("floor");
    found = slit::ricci_rectangles(floor.mesh, hints, {}, progress.silent());
    if (found.found) break;
  }
  floor.found = found.found;
  floor.position = found.position;
  floor.height = found.height;
  for (std::size_t wall = 1; wall < rims.size(); ++wall) {
    std::array<Complex, 2>& box = floor.rectangles.emplace_back();
    std::vector<double> x;
    std::vector<double> y;
    for (const int v : rims[wall]) {
      x.push_back(found.position[v].real());
      y.push_back(found.position[v].imag());
    }
    box[0] = {*std::min_element(x.begin(), x.end()), *std::min_element(y.begin(), y.end())};
    box[1] = {*std::max_element(x.begin(), x.end()), *std::max_element(y.begin(), y.end())};
  }
}

} // namespace

FloorMap floor_map(const Solid& solid, const Partition& partition, const FloorOptions& options,
                   const Progress& progress) {
  progress.step("floor");
  FloorMap floor = floor_of(solid, partition);
  const std::vector<BoundaryLoop> loops = surface::boundary_loops(floor.mesh);
  const std::vector<int> loop_of_wall = loops_of_walls(walls_of_loops(solid, partition, floor, loops));
  if (options.domain == FloorDomain::rectangle)
    map_to_rectangles(floor, loops, loop_of_wall, options.corners, progress);
  else
    map_to_circles(floor, loops, loop_of_wall, progress);
  const auto is_finite = [](const Complex& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); };
  if (!std::all_of(floor.position.begin(), floor.position.end(), is_finite)) {
    floor.position.assign(floor.position.size(), 0);
    floor.found = false;
  }
  floor.flipped = static_cast<int>(slit::distortion_in_plane(floor.mesh, floor.position).flipped.size());
  return floor;
}

} // namespace tetrarch::product
