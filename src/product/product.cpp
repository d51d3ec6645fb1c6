// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/product.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/parallel.hpp"
#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/solid/split_edges.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace tetrarch::product {
namespace {

/// Vertices whose fibres are followed by one thread before it takes more.
constexpr int batch = 256;

using Edge = std::array<int, 2>;

Edge edge(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Edges that join two vertices of a base but are not on it.
std::vector<solid::EdgePoint> shortcuts(const Solid& solid, const Partition& partition) {
  const std::vector<int> base = bases_of_vertices(solid, partition);
  std::set<Edge> on_base;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3 && partition.patch[t] < first_wall; ++c)
      on_base.insert(edge(solid.corner(t, c), solid.corner(t, (c + 1) % 3)));
  std::set<Edge> found;
  for (const auto& v : solid.mesh.tetrahedra)
    for (const auto& [i, j] : edge_vertex)
      if (base[v[i]] >= 0 && base[v[i]] == base[v[j]] && !on_base.contains(edge(v[i], v[j])))
        found.insert(edge(v[i], v[j]));
  std::vector<solid::EdgePoint> splits;
  splits.reserve(found.size());
  for (const Edge& e : found) splits.push_back({e[0], e[1], 0.5});
  return splits;
}

double diameter(const std::vector<Point>& points) {
  double greatest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      greatest = std::max(greatest, numeric::distance(points[i], points[j]));
  return greatest;
}

/// Lengths and areas of the walls.
struct WallSize {
  double area = 0;
  double rims = 0; ///< length of all rims, floor and ceiling
};

WallSize size_of_walls(const Solid& solid, const Partition& partition) {
  WallSize size;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (partition.patch[t] < first_wall) continue;
    std::array<Eigen::Vector3d, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = Eigen::Vector3d::Map(solid.point(solid.corner(t, c)).data());
    size.area += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
    for (const surface::Side s : surface::sides_of(t)) {
      if (partition.patch[solid.boundary.mate(s).triangle()] < first_wall)
        size.rims += (p[s.next().corner()] - p[s.previous().corner()]).norm();
    }
  }
  return size;
}

/// u and v of vertices whose fibre did not arrive: means of those around, from the known ones outward.
void fill_in(const Solid& solid, std::vector<char> known, std::vector<Point>& uvw) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::array<double, 3>> sum(uvw.size(), {0, 0, 0});
    for (const auto& corners : solid.mesh.tetrahedra)
      for (const int v : corners)
        for (const int u : corners)
          if (!known[v] && known[u]) sum[v] = {sum[v][0] + uvw[u][0], sum[v][1] + uvw[u][1], sum[v][2] + 1};
    for (std::size_t v = 0; v < uvw.size(); ++v) {
      if (known[v] || sum[v][2] == 0) continue;
      uvw[v][0] = sum[v][0] / sum[v][2];
      uvw[v][1] = sum[v][1] / sum[v][2];
      known[v] = 1;
      changed = true;
    }
  }
}

double cosine(const Point& a, const Point& b) {
  const auto p = Eigen::Vector3d::Map(a.data());
  const auto q = Eigen::Vector3d::Map(b.data());
  const double lengths = p.norm() * q.norm();
  return lengths > 0 ? std::abs(p.dot(q)) / lengths : 0;
}

double volume(const Solid& solid, int t) {
  std::array<Eigen::Vector3d, 4> p;
  for (int k = 0; k < 4; ++k) p[k] = Eigen::Vector3d::Map(solid.point(solid.corners(t)[k]).data());
  return (p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) / 6;
}

double mean_edge(const Solid& solid) {
  double sum = 0;
  for (const auto& v : solid.mesh.tetrahedra)
    for (const auto& [i, j] : edge_vertex) sum += numeric::distance(solid.point(v[i]), solid.point(v[j]));
  return sum / (6.0 * solid.size());
}

} // namespace

SplitSolid split_shortcuts(Solid before, Partition partition) {
  const std::vector<solid::EdgePoint> splits = shortcuts(before, partition);
  if (splits.empty()) return {std::move(before), std::move(partition), 0};
  solid::SplitTets split = solid::split_edges(before.mesh, splits);
  SplitSolid after{solid_of(std::move(split.mesh)), {{}, partition.walls}, static_cast<int>(splits.size())};
  after.partition.patch.reserve(after.solid.face.size());
  for (const TetFace face : after.solid.face) {
    const int from = 4 * split.origin[face.tet] + split.face_of[4 * face.tet + face.face];
    after.partition.patch.push_back(partition.patch[before.outside[from]]);
  }
  return after;
}

double natural_height(const Solid& solid, const Partition& partition, const FloorMap& floor) {
  const WallSize walls = size_of_walls(solid, partition);
  std::vector<Point> here;
  std::vector<Point> there;
  for (const surface::BoundaryLoop& loop : surface::boundary_loops(floor.mesh))
    for (const surface::SideEnd e : loop.sides) {
      const int v = floor.mesh.surface.vertex(e);
      here.push_back(floor.mesh.points[v]);
      there.push_back({floor.position[v].real(), floor.position[v].imag(), 0});
    }
  const double scale = diameter(there) / diameter(here);
  return std::isfinite(scale) && scale > 0 ? walls.area / (walls.rims / 2) * scale : 1.0;
}

Coordinates coordinates(const FiberField& field, const FloorMap& floor, int threads,
                        const Progress& progress) {
  const Solid& solid = field.solid();
  std::vector<std::complex<double>> position(solid.mesh.points.size());
  for (std::size_t v = 0; v < floor.vertex.size(); ++v) position[floor.vertex[v]] = floor.position[v];
  const int count = static_cast<int>(solid.mesh.points.size());
  std::vector<Fiber> fibers(solid.mesh.points.size());
  numeric::parallel_for(
      count, {threads, batch},
      [&](int v) {
        if (field.is_used(v)) fibers[v] = field.trace(field.at_vertex(v), Way::down);
      },
      [&](double part) { progress.step("fibres", part); });

  Coordinates result;
  result.uvw.resize(solid.mesh.points.size());
  std::vector<char> known(solid.mesh.points.size(), 1);
  for (int v = 0; v < count; ++v) {
    if (!field.is_used(v)) continue;
    const Fiber& fiber = fibers[v];
    std::complex<double> uv;
    for (int k = 0; k < 4; ++k) uv += fiber.at.weight[k] * position[solid.corners(fiber.at.tet)[k]];
    result.uvw[v] = {uv.real(), uv.imag(), field.w()[v]};
    result.by_gradient += fiber.by_gradient ? 1 : 0;
    if (fiber.end == FiberEnd::base) continue;
    result.stuck.push_back({v, fiber.end, point_at(solid, fiber.at)});
    known[v] = 0;
  }
  if (!result.stuck.empty()) fill_in(solid, std::move(known), result.uvw);
  return result;
}

Quality quality(const Solid& solid, const std::vector<Point>& uvw) {
  std::array<std::vector<double>, 3> f;
  for (int c = 0; c < 3; ++c) {
    f[c].reserve(uvw.size());
    for (const Point& p : uvw) f[c].push_back(p[c]);
  }
  Quality q;
  double whole = 0;
  for (int t = 0; t < solid.size(); ++t) {
    const auto& v = solid.corners(t);
    if (numeric::volume_sign(uvw[v[0]], uvw[v[1]], uvw[v[2]], uvw[v[3]]) != numeric::Sign::positive) {
      q.flipped.push_back(t);
      continue;
    }
    const Point du = gradient_in(solid, t, f[0]);
    const Point dv = gradient_in(solid, t, f[1]);
    const Point dw = gradient_in(solid, t, f[2]);
    const double error = numeric::maximum(cosine(du, dw), cosine(dv, dw));
    const double weight = volume(solid, t);
    whole += weight;
    q.mean_orthogonality_error += weight * error;
    q.max_orthogonality_error = numeric::maximum(q.max_orthogonality_error, error);
    q.mean_uv += weight * cosine(du, dv);
    q.max_uv = numeric::maximum(q.max_uv, cosine(du, dv));
  }
  if (whole > 0) {
    q.mean_orthogonality_error /= whole;
    q.mean_uv /= whole;
  }
  return q;
}

Confirmation confirm(const FiberField& field, int threads, const Progress& progress) {
  const Solid& solid = field.solid();
  const int count = static_cast<int>(solid.mesh.points.size());
  std::vector<double> distance(solid.mesh.points.size(), -1.0);
  numeric::parallel_for(
      count, {threads, batch},
      [&](int v) {
        if (!field.is_used(v)) return;
        const Fiber down = field.trace(field.at_vertex(v), Way::down);
        if (down.end != FiberEnd::base) return;
        const Fiber up = field.trace_to(down.at, Way::up, field.w()[v]);
        if (up.end == FiberEnd::base || up.end == FiberEnd::level)
          distance[v] = numeric::distance(point_at(solid, up.at), solid.point(v));
      },
      [&](double part) { progress.step("the opposite way", part); });
  const double unit = mean_edge(solid);
  Confirmation result;
  int used = 0;
  for (int v = 0; v < count; ++v) {
    if (!field.is_used(v)) continue;
    ++used;
    if (distance[v] < 0) {
      ++result.not_arrived;
      continue;
    }
    const double d = distance[v] / unit;
    result.mean_distance += d;
    result.off += d > 1 ? 1 : 0;
    if (result.worst >= 0 && d <= result.max_distance) continue;
    result.worst = v;
    result.max_distance = d;
  }
  if (used > result.not_arrived) result.mean_distance /= used - result.not_arrived;
  return result;
}

} // namespace tetrarch::product
