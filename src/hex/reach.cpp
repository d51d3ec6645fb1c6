// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/reach.hpp"

#include "samples.hpp"
#include "tetrarch/hex/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tetrarch::hex {
namespace {

using namespace numeric;

/// A triangle has so many parts along a side at most.
constexpr int most_reach_parts = 64;

/// The weights of a triangle's corners at a point of it.
std::array<double, 3> weights_at(const Point& p, const std::array<Point, 3>& t) {
  std::array<double, 3> result{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = norm(cross(t[(k + 1) % 3] - p, t[(k + 2) % 3] - p));
    sum += result[k];
  }
  for (double& w : result) w = sum > 0 ? w / sum : 1.0 / 3;
  return result;
}

} // namespace

std::vector<SurfaceSample> surface_samples(const Targets& targets, double spacing) {
  std::vector<SurfaceSample> result;
  const NearestTriangle& whole = targets.whole();
  for (int k = 0; k < whole.size(); ++k) {
    const auto& t = whole.corners(k);
    const std::vector<Point> points = spread_points(t, spacing, most_reach_parts);
    const double area = norm(cross(t[1] - t[0], t[2] - t[0])) / 2 / static_cast<double>(points.size());
    for (const Point& p : points) result.push_back({p, whole.normal(k), area});
  }
  return result;
}

std::vector<Vector> reach(const product::HexMesh& mesh, const std::vector<SurfaceSample>& samples,
                          double least, double most, const Progress& progress) {
  std::vector<std::array<int, 3>> corners;
  std::vector<std::array<Point, 3>> triangles;
  for (const SurfaceSquare& s : surface_of(mesh)) {
    const auto& side = product::outward_sides[s.side];
    const product::Hexahedron& h = mesh.hexahedra[s.hexahedron];
    for (const std::size_t k : {0U, 2U}) {
      corners.push_back({h[side[k]], h[side[k + 1]], h[side[(k + 2) % 4]]});
      const auto& c = corners.back();
      triangles.push_back({mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]});
    }
  }
  const NearestTriangle tree(std::move(triangles));
  std::vector<Vector> way(mesh.points.size(), Vector{});
  std::vector<double> weight(mesh.points.size());
  std::size_t asked = 0;
  for (const SurfaceSample& sample : samples) {
    if (++asked % 1024 == 0) progress.step("fitting");
    const Foot foot = tree.nearest(sample.at, &sample.normal);
    if (foot.triangle < 0 || !(foot.distance > least)) continue;
    const std::array<double, 3> share = weights_at(foot.at, tree.corners(foot.triangle));
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = corners[foot.triangle][k];
      const double w = sample.area * foot.distance * share[k];
      way[v] = way[v] + w * (sample.at - foot.at);
      weight[v] += w;
    }
  }
  for (std::size_t v = 0; v < way.size(); ++v) {
    if (!(weight[v] > 0)) continue;
    way[v] = 1 / weight[v] * way[v];
    const double length = norm(way[v]);
    if (length > most) way[v] = most / length * way[v];
  }
  return way;
}

} // namespace tetrarch::hex
