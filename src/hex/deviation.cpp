// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/deviation.hpp"

#include "samples.hpp"
#include "tetrarch/hex/layers.hpp"
#include "tetrarch/numeric/nearest_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using Triangles = std::vector<std::array<Point, 3>>;

constexpr int parts = 4; // of a square's side
/// Of a triangle's side: more than there can be, as the spacing is a thousandth of the box's diagonal at
/// least.
constexpr int most_parts = 2000;

/// Points of the squares, row by row, and triangles between them.
struct Sampled {
  std::vector<Point> points;
  Triangles triangles;
  double mean_edge = 0;
};

Sampled sampled(const product::HexMesh& mesh) {
  Sampled result;
  const std::vector<SurfaceSquare> surface = surface_of(mesh);
  for (const SurfaceSquare& s : surface) {
    std::array<Point, 4> p{};
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = mesh.points[mesh.hexahedra[s.hexahedron][product::outward_sides[s.side][k]]];
    for (std::size_t k = 0; k < 4; ++k) result.mean_edge += distance(p[k], p[(k + 1) % 4]);
    const auto at = [&](int i, int j) {
      const double u = i / static_cast<double>(parts);
      const double v = j / static_cast<double>(parts);
      return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[3] + u * p[2]);
    };
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; j <= parts; ++j) {
        result.points.push_back(at(i, j));
        if (i == parts || j == parts) continue;
        result.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        result.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  result.mean_edge /= std::max(1.0, 4.0 * static_cast<double>(surface.size()));
  return result;
}

} // namespace

std::vector<std::array<Point, 3>> boundary_triangles(const product::Solid& solid) {
  Triangles result;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    result.push_back(
        {solid.point(solid.corner(t, 0)), solid.point(solid.corner(t, 1)), solid.point(solid.corner(t, 2))});
  return result;
}

Deviation deviation(const product::Solid& solid, const product::HexMesh& mesh, const Progress& progress) {
  return deviation(boundary_triangles(solid), mesh, progress);
}

Deviation deviation(std::vector<std::array<Point, 3>> boundary, const product::HexMesh& mesh,
                    const Progress& progress) {
  Sampled hexahedra = sampled(mesh);
  Deviation result;
  Point least = boundary.front().front();
  Point most = least;
  for (const auto& t : boundary)
    for (const Point& p : t)
      for (std::size_t a = 0; a < 3; ++a) {
        least[a] = std::min(least[a], p[a]);
        most[a] = std::max(most[a], p[a]);
      }
  result.diagonal = distance(least, most);
  const double spacing = std::max(hexahedra.mean_edge / 2, result.diagonal / 1000);
  const NearestTriangle of_hexahedra(std::move(hexahedra.triangles));
  std::int64_t asked = 0;
  const auto measure = [&](const NearestTriangle& to, const Point& p, double& greatest, Point& at) {
    if (++asked % 1024 == 0) progress.step("distance");
    const double d = to.nearest(p).distance;
    if (d <= greatest) return;
    greatest = d;
    at = p;
  };
  for (const auto& t : boundary)
    for (const Point& p : spread_points(t, spacing, most_parts))
      measure(of_hexahedra, p, result.from_solid, result.solid_at);
  const NearestTriangle of_solid(std::move(boundary));
  for (const Point& p : hexahedra.points) measure(of_solid, p, result.from_hexahedra, result.hexahedra_at);
  return result;
}

} // namespace tetrarch::hex
