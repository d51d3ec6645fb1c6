// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/floor_map.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/boundary_loops.hpp"
#include "tetrarch/slit/circular_map.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/slit/unflip.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using Complex = std::complex<double>;
using mesh::BoundaryLoop;
using mesh::Side;

/// The floor's triangles as a mesh of their own.
FloorMap floor_of(const Solid& solid, const Partition& partition) {
  FloorMap floor;
  std::vector<int> number(solid.mesh.points.size(), -1);
  std::vector<mesh::Surface::Triangle> triangles;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (partition.patch[t] != floor_patch) continue;
    mesh::Surface::Triangle& triangle = triangles.emplace_back();
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
  floor.mesh.surface = mesh::Surface(static_cast<int>(floor.vertex.size()), std::move(triangles));
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

void map_to_circles(FloorMap& floor, const std::vector<BoundaryLoop>& loops,
                    const std::vector<int>& loop_of_wall, const Progress& progress) {
  slit::CircularMap map;
  if (loops.size() == 1) {
    const int center = slit::innermost_vertex(floor.mesh);
    if (center < 0) throw InputError("all vertices of the floor are on its rim; its map needs one inside");
    map = slit::disk_map(floor.mesh, center);
  } else {
    slit::RicciCircles circles =
        slit::ricci_circles(floor.mesh, loop_of_wall[0], loop_of_wall[1], {}, progress.silent());
    map = std::move(circles.map);
    // The second route, which is slower where many holes crowd the disk.
    if (!map.domain.found) {
      const slit::OneForms forms(floor.mesh, progress.silent(), slit::Edges::intrinsic_delaunay);
      map = slit::circular_map(forms, slit::slit_map(forms, loop_of_wall[0], loop_of_wall[1]));
    }
  }
  slit::unflip_in_disk(floor.mesh, map);
  floor.found = map.domain.found;
  floor.position = std::move(map.position);
}

/// A loop by its vertices, in the order of walking, the floor to the left.
std::vector<int> vertices_of(const mesh::Surface& surface, const BoundaryLoop& loop) {
  std::vector<int> vertices;
  vertices.reserve(loop.sides.size());
  for (const mesh::SideEnd e : loop.sides) vertices.push_back(surface.vertex(e));
  return vertices;
}

/// pi less the angles of the floor at each vertex.
std::vector<double> turns(const mesh::TriangleMesh& mesh) {
  std::vector<double> turn(mesh.points.size(), std::numbers::pi);
  for (const auto& corners : mesh.surface.triangles())
    for (int c = 0; c < 3; ++c) {
      const auto at = Eigen::Vector3d::Map(mesh.points[corners[c]].data());
      const Eigen::Vector3d a = Eigen::Vector3d::Map(mesh.points[corners[(c + 1) % 3]].data()) - at;
      const Eigen::Vector3d b = Eigen::Vector3d::Map(mesh.points[corners[(c + 2) % 3]].data()) - at;
      turn[corners[c]] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
  return turn;
}

/// The floor's shadow in the plane of its area vector: x along the principal axis of the rim. None where the
/// shadow is much smaller than the floor, which is then no plate.
std::optional<std::vector<Complex>> shadow(const mesh::TriangleMesh& mesh, const std::vector<int>& rim) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double area = 0;
  const auto point = [&](int v) -> Eigen::Vector3d { return Eigen::Vector3d::Map(mesh.points[v].data()); };
  for (const auto& c : mesh.surface.triangles()) {
    const Eigen::Vector3d twice = (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0]));
    normal += twice;
    area += twice.norm();
  }
  if (normal.norm() < 0.5 * area) return std::nullopt;
  normal.normalize();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int v : rim) mean += point(v) / static_cast<double>(rim.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const int v : rim) {
    const Eigen::Vector3d d = point(v) - mean;
    const Eigen::Vector3d flat = d - normal * normal.dot(d);
    spread += flat * flat.transpose();
  }
  const Eigen::Vector3d x = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  const Eigen::Vector3d y = normal.cross(x);
  std::vector<Complex> places;
  places.reserve(mesh.points.size());
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v)
    places.emplace_back((point(v) - mean).dot(x), (point(v) - mean).dot(y));
  return places;
}

/// Four places on the loop of vertices, in its order: where it has just four corners, these; else its extreme
/// points in the diagonal directions.
std::array<int, 4> corners_of(const std::vector<int>& loop, const std::vector<double>& turn, int sign,
                              const std::vector<Complex>& place) {
  constexpr double sharp = std::numbers::pi / 4;
  std::vector<int> corners;
  for (int k = 0; k < static_cast<int>(loop.size()); ++k)
    if (sign * turn[loop[k]] > sharp) corners.push_back(k);
  std::array<int, 4> found{};
  if (corners.size() == 4) {
    std::copy(corners.begin(), corners.end(), found.begin());
    return found;
  }
  Complex low = place[loop[0]];
  Complex high = low;
  for (const int v : loop) {
    low = {std::min(low.real(), place[v].real()), std::min(low.imag(), place[v].imag())};
    high = {std::max(high.real(), place[v].real()), std::max(high.imag(), place[v].imag())};
  }
  const Complex size = high - low;
  for (int d = 0; d < 4; ++d) {
    const std::array<double, 2> way{d == 0 || d == 3 ? -1.0 : 1.0, d < 2 ? -1.0 : 1.0};
    const auto reach = [&](int v) {
      return way[0] * place[v].real() / size.real() + way[1] * place[v].imag() / size.imag();
    };
    found[d] = static_cast<int>(
        std::max_element(loop.begin(), loop.end(), [&](int a, int b) { return reach(a) < reach(b); }) -
        loop.begin());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Whether no two corners are the same or neighbours.
bool are_apart(const std::array<int, 4>& corners, std::size_t size) {
  for (int c = 0; c < 4; ++c) {
    const int gap = c < 3 ? corners[c + 1] - corners[c] : corners[0] + static_cast<int>(size) - corners[3];
    if (gap < 2) return false;
  }
  return true;
}

/// The same corners from the one on that lies lowest to the left.
std::array<int, 4> from_lower_left(std::array<int, 4> corners, const std::vector<Complex>& place) {
  const auto height = [&](int v) { return place[v].real() + place[v].imag(); };
  const auto first =
      std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return height(a) < height(b); });
  std::rotate(corners.begin(), first, corners.end());
  return corners;
}

std::array<int, 4> given_corners(const FloorMap& floor, const std::array<int, 4>& corners) {
  std::array<int, 4> inside{};
  for (int c = 0; c < 4; ++c) {
    const auto at = std::find(floor.vertex.begin(), floor.vertex.end(), corners[c]);
    if (at == floor.vertex.end())
      throw InputError("vertex " + std::to_string(corners[c]) +
                       " is to be a corner, but is not on the floor");
    inside[c] = static_cast<int>(at - floor.vertex.begin());
  }
  return inside;
}

/// Four vertices of each loop, walls in their order. Of floors that are no plates, their circular map tells
/// where the corners are.
std::vector<std::array<int, 4>> corner_hints(FloorMap& floor, const std::vector<BoundaryLoop>& loops,
                                             const std::vector<int>& loop_of_wall,
                                             const std::array<int, 4>& given, const Progress& progress) {
  const mesh::Surface& surface = floor.mesh.surface;
  const std::vector<double> turn = turns(floor.mesh);
  const auto places = shadow(floor.mesh, vertices_of(surface, loops[loop_of_wall[0]]));
  if (!places) map_to_circles(floor, loops, loop_of_wall, progress);
  const std::vector<Complex>& place = places ? *places : floor.position;
  std::vector<std::array<int, 4>> hints;
  for (std::size_t wall = 0; wall < loops.size(); ++wall) {
    const std::vector<int> loop = vertices_of(surface, loops[loop_of_wall[wall]]);
    if (loop.size() < 8)
      throw InputError("the rim of wall " + std::to_string(wall) + " on the floor has " +
                       std::to_string(loop.size()) + " edges; a rectangle needs at least 8");
    std::array<int, 4> corners = corners_of(loop, turn, wall == 0 ? 1 : -1, place);
    for (int c = 0; c < 4 && !are_apart(corners, loop.size()); ++c)
      corners[c] = c * static_cast<int>(loop.size()) / 4;
    if (!are_apart(corners, loop.size()))
      for (int c = 0; c < 4; ++c) corners[c] = c * static_cast<int>(loop.size()) / 4;
    for (int& c : corners) c = loop[c];
    hints.push_back(from_lower_left(corners, place));
  }
  if (given[0] >= 0) hints[0] = given_corners(floor, given);
  return hints;
}

void map_to_rectangles(FloorMap& floor, const std::vector<BoundaryLoop>& loops,
                       const std::vector<int>& loop_of_wall, const std::array<int, 4>& corners,
                       const Progress& progress) {
  const slit::RicciRectangles found = slit::ricci_rectangles(
      floor.mesh, corner_hints(floor, loops, loop_of_wall, corners, progress), {}, progress.silent());
  floor.found = found.found;
  floor.position = found.position;
  floor.height = found.height;
  for (std::size_t wall = 1; wall < loops.size(); ++wall) {
    std::array<Complex, 2>& box = floor.rectangles.emplace_back();
    std::vector<double> x;
    std::vector<double> y;
    for (const int v : vertices_of(floor.mesh.surface, loops[loop_of_wall[wall]])) {
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
  const std::vector<BoundaryLoop> loops = mesh::boundary_loops(floor.mesh);
  const std::vector<int> loop_of_wall = loops_of_walls(walls_of_loops(solid, partition, floor, loops));
  if (options.domain == FloorDomain::rectangle)
    map_to_rectangles(floor, loops, loop_of_wall, options.corners, progress);
  else
    map_to_circles(floor, loops, loop_of_wall, progress);
  floor.flipped = static_cast<int>(slit::distortion_in_plane(floor.mesh, floor.position).flipped.size());
  return floor;
}

} // namespace tetrarch::product
