// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "vertex_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;
using surface::Side;

void check(const surface::TriangleMesh& mesh, const Curvatures& curvatures, const std::vector<Side>& out) {
  const auto vertices = static_cast<std::size_t>(mesh.surface.vertex_count());
  if (curvatures.at.size() != vertices) throw PreconditionError("each vertex needs a curvature");
  if (!curvatures.held.empty() && curvatures.held.size() != vertices)
    throw PreconditionError("each vertex is held or not");
  std::vector<double> at = curvatures.at;
  for (const int first : curvatures.round_holes) {
    if (first < 0 || first >= mesh.surface.vertex_count() || !out[first].exists())
      throw InputError("vertex " + std::to_string(first) + " (counted from 0) is not on a hole");
    int v = first;
    do {
      at[v] = 0;
      v = mesh.surface.to(out[v]);
    } while (v != first);
  }
  double total = -full_turn * static_cast<double>(curvatures.round_holes.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!std::isfinite(at[v]))
      throw InputError("the curvature of vertex " + std::to_string(v) + " (counted from 0) is not finite");
    total += at[v];
  }
  if (std::find(curvatures.held.begin(), curvatures.held.end(), 1) != curvatures.held.end()) return;
  const double euler =
      mesh.surface.vertex_count() - mesh.surface.edge_count() + mesh.surface.triangle_count();
  constexpr double rounding = 1e-8;
  if (std::abs(total - full_turn * euler) > rounding)
    throw InputError("by Gauss-Bonnet the curvatures must add up to " + std::to_string(euler) +
                     " full turns, not to " + std::to_string(total / full_turn));
}

} // namespace

ScaledMetric scaled_metric(const surface::TriangleMesh& mesh, const Curvatures& curvatures,
                           const RicciOptions& options, const Progress& progress) {
  surface::IntrinsicTriangulation start = surface::intrinsic_delaunay(mesh);
  check(mesh, curvatures, boundary_sides(mesh.surface));
  std::vector<char> held = curvatures.held;
  held.resize(curvatures.at.size(), 0);
  if (std::find(held.begin(), held.end(), 1) == held.end()) held[0] = 1;
  VertexScaling scaling(std::move(start), held, curvatures.round_holes);
  const VertexScaling::Outcome outcome = scaling.solve(curvatures.at, options, progress);
  ScaledMetric result{scaling.metric(), scaling.log_scale(), outcome.residual, outcome.steps, outcome.found};
  result.log_scale.resize(held.size());
  return result;
}

Layout laid_out(const surface::IntrinsicTriangulation& metric) {
  const surface::Surface& surface = metric.surface;
  const auto start = [](Side s) { return s.next().value; };
  const auto end = [](Side s) { return s.previous().value; };
  Layout out;
  out.corner.resize(metric.length.size());
  const auto place_apex = [&](Side s) {
    const Complex along = (out.corner[end(s)] - out.corner[start(s)]) / metric.length[s.value];
    out.corner[s.value] = out.corner[start(s)] + along * std::polar(metric.length[s.previous().value],
                                                                    angle_opposite(metric.length, s.next()));
  };
  std::vector<char> placed(static_cast<std::size_t>(surface.triangle_count()), 0);
  std::vector<int> queue{0};
  placed[0] = 1;
  out.corner[end(Side(0))] = metric.length[0];
  place_apex(Side(0));
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const Side s : surface::sides_of(queue[next])) {
      const Side m = surface.mate(s);
      if (!m.exists() || std::exchange(placed[m.triangle()], 1)) continue;
      out.corner[start(m)] = out.corner[end(s)];
      out.corner[end(m)] = out.corner[start(s)];
      place_apex(m);
      queue.push_back(m.triangle());
    }
  out.position.resize(static_cast<std::size_t>(surface.vertex_count()));
  for (int k = 0; k < surface.side_count(); ++k) {
    out.position[surface.apex(Side(k))] = out.corner[k];
    if (const Side m = surface.mate(Side(k)); m.exists())
      out.gap = numeric::maximum(out.gap, std::abs(out.corner[start(m)] - out.corner[end(Side(k))]));
  }
  return out;
}

Holonomy holonomy(const surface::IntrinsicTriangulation& metric, int vertex) {
  const std::vector<Side> out = boundary_sides(metric.surface);
  if (vertex < 0 || vertex >= metric.surface.vertex_count() || !out[vertex].exists())
    throw InputError("vertex " + std::to_string(vertex) + " (counted from 0) is not on the boundary");
  const std::vector<double> curvature = curvatures_of(metric);
  Holonomy result;
  double heading = 0;
  int v = vertex;
  do {
    result.translation += std::polar(metric.length[out[v].value], heading);
    v = metric.surface.to(out[v]);
    heading += curvature[v];
  } while (v != vertex);
  result.rotation = std::remainder(heading, full_turn);
  return result;
}

namespace {

/// The circle nearest to points by least squares of |z - c|^2 - r^2, a linear problem.
Circle fitted(const std::vector<Complex>& points) {
  const auto count = static_cast<double>(points.size());
  const Complex mean = std::accumulate(points.begin(), points.end(), Complex(0)) / count;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Complex right = 0;
  for (const Complex p : points) {
    const Complex z = p - mean;
    xx += z.real() * z.real();
    xy += z.real() * z.imag();
    yy += z.imag() * z.imag();
    right += z * std::norm(z) / 2.0;
  }
  const double determinant = xx * yy - xy * xy;
  const Complex center =
      Complex(yy * right.real() - xy * right.imag(), xx * right.imag() - xy * right.real()) / determinant;
  Circle circle{mean + center, std::sqrt((xx + yy) / count + std::norm(center)), 0};
  for (const Complex p : points)
    circle.circularity =
        numeric::maximum(circle.circularity, std::abs(std::abs(p - circle.center) / circle.radius - 1));
  return circle;
}

std::vector<Complex> points_of(const surface::Surface& surface, const surface::BoundaryLoop& loop,
                               const std::vector<Complex>& position) {
  std::vector<Complex> points;
  for (const surface::SideEnd e : loop.sides) points.push_back(position[surface.vertex(e)]);
  return points;
}

/// The surface without a vertex of the outer loop, which is sent to infinity: its neighbours are scaled so
/// that all are equally far from it, and stay so. Others are scaled as inversion in a sphere about the vertex
/// would do it, which on planar meshes comes near the solution.
struct Opened {
  int vertex = -1;
  std::vector<int> link; ///< the vertices around it, from the next on the loop to the one before
  surface::IntrinsicTriangulation rest;
  std::vector<int> in_rest; ///< of each vertex its name there; -1 for the one that is gone
};

/// The sides of the triangles around the vertex at which boundary side s starts, those that start there.
std::vector<Side> spokes(const surface::Surface& surface, Side s) {
  std::vector<Side> result;
  for (; s.exists(); s = surface.mate(s.previous())) result.push_back(s);
  return result;
}

/// Whether the vertex with these spokes can go without anything falling apart.
bool can_go(const surface::Surface& surface, const std::vector<Side>& around, const std::vector<Side>& out) {
  std::vector<int> link;
  for (const Side s : around) {
    if (s != around.front() && out[surface.to(s)].exists()) return false;
    link.push_back(surface.to(s));
  }
  link.push_back(surface.apex(around.back()));
  link.push_back(surface.from(around.front()));
  std::sort(link.begin(), link.end());
  return std::adjacent_find(link.begin(), link.end()) == link.end() &&
         static_cast<int>(around.size()) < surface.triangle_count();
}

/// Takes the triangles at the spokes away.
void remove_star(const surface::IntrinsicTriangulation& whole, const std::vector<Side>& around,
                 Opened& open) {
  surface::Surface surface = whole.surface;
  for (const Side s : around)
    if (surface.mate(s.next()).exists()) surface.unglue(s.next());
  const surface::Parts parts = surface::parts(surface);
  for (const surface::Part& part : surface::split(surface, parts)) {
    if (parts.of[part.triangles.front()] == parts.of[around.front().triangle()]) continue;
    open.rest.surface = part.surface;
    for (int k = 0; k < part.surface.side_count(); ++k) {
      const Side s = part.in_whole(Side(k));
      open.rest.length.push_back(whole.length[s.value]);
      open.in_rest[whole.surface.apex(s)] = part.surface.apex(Side(k));
    }
  }
}

Opened opened(const surface::TriangleMesh& mesh, const surface::BoundaryLoop& outer) {
  const surface::IntrinsicTriangulation whole = surface::intrinsic_delaunay(mesh);
  const surface::Surface& surface = whole.surface;
  const std::vector<Side> out = boundary_sides(surface);
  Opened open;
  open.in_rest.assign(mesh.points.size(), -1);
  std::vector<Side> around;
  for (const surface::SideEnd e : outer.sides) {
    around = spokes(surface, out[mesh.surface.vertex(e)]);
    if (!can_go(surface, around, out)) continue;
    open.vertex = mesh.surface.vertex(e);
    break;
  }
  if (open.vertex < 0) throw InputError("the triangles along the outer loop are too coarse for a circle");
  remove_star(whole, around, open);

  // Edges at the vertex are known, other distances a guess to start from; other sheets of the surface may
  // come as near as they like.
  const double unit = whole.length[around.front().value];
  const auto& center = mesh.points[open.vertex];
  std::vector<double> distance;
  for (const auto& p : mesh.points)
    distance.push_back(std::max(std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]), unit / 2));
  for (const Side s : around) {
    open.link.push_back(surface.to(s));
    distance[surface.to(s)] = whole.length[s.value];
  }
  open.link.push_back(surface.apex(around.back()));
  distance[open.link.back()] = whole.length[around.back().previous().value];
  std::vector<double> in_rest(mesh.points.size());
  for (std::size_t v = 0; v < in_rest.size(); ++v)
    if (open.in_rest[v] >= 0) in_rest[open.in_rest[v]] = distance[v] / unit;
  for (int k = 0; k < open.rest.surface.side_count(); ++k)
    open.rest.length[k] /= in_rest[open.rest.surface.from(Side(k))] * in_rest[open.rest.surface.to(Side(k))];
  return open;
}

/// Where the vertices lie in the disk, of the half-plane's point `zero` at 0 and infinity at 1.
std::vector<Complex> in_disk(const Opened& open, const std::vector<Complex>& half_plane, Complex zero) {
  std::vector<Complex> position;
  for (const int v : open.in_rest)
    position.push_back(v < 0 ? 1.0 : (half_plane[v] - zero) / (half_plane[v] - std::conj(zero)));
  return position;
}

void check_loops(const surface::TriangleMesh& mesh, int loops, int outer, int inner) {
  const SurfaceType type = surface::type_of(mesh.surface);
  if (!type.orientable || loops == 0 || type.euler != 2 - loops)
    throw InputError("a circular domain needs a sphere with holes, but this surface has type " + type.str());
  const bool is_disk = loops == 1;
  if (outer < 0 || outer >= loops || inner >= loops || inner == outer || (is_disk ? inner != -1 : inner < 0))
    throw InputError("there are no such outer and inner loops: the surface has " + std::to_string(loops));
}

/// The outer loop, the inner one if there is one, the others in their order.
std::vector<int> in_order(int loops, int outer, int inner) {
  std::vector<int> order{outer};
  if (inner >= 0) order.push_back(inner);
  for (int k = 0; k < loops; ++k)
    if (k != outer && k != inner) order.push_back(k);
  return order;
}

/// The rest of the surface in the half-plane to the left of the real axis, on which the outer loop lies.
std::vector<Complex> in_half_plane(const Opened& open, const surface::IntrinsicTriangulation& metric) {
  std::vector<Complex> position = laid_out(metric).position;
  const Complex first = position[open.in_rest[open.link.front()]];
  const Complex along = position[open.in_rest[open.link.back()]] - first;
  for (Complex& z : position) z = (z - first) / along;
  return position;
}

/// The point of the half-plane that is to be the centre of the disk.
Complex center_of_disk(const surface::TriangleMesh& mesh, const surface::BoundaryLoop* inner,
                       const Opened& open, const std::vector<Complex>& half_plane) {
  if (!inner) {
    const int center = innermost_vertex(mesh);
    if (center < 0) throw InputError("the disk has no interior vertex");
    return half_plane[open.in_rest[center]];
  }
  std::vector<Complex> points;
  for (const surface::SideEnd e : inner->sides)
    points.push_back(half_plane[open.in_rest[mesh.surface.vertex(e)]]);
  const Circle circle = fitted(points);
  // The hyperbolic centre. Where no metric was found the circle may cross the axis.
  const double y = circle.center.imag();
  const double squared = (y - circle.radius) * (y + circle.radius);
  return {circle.center.real(), squared > 0 ? std::sqrt(squared) : 1.0};
}

} // namespace

RicciCircles ricci_circles(const surface::TriangleMesh& mesh, int outer, int inner,
                           const RicciOptions& options, const Progress& progress) {
  const auto loops = surface::boundary_loops(mesh);
  const int count = static_cast<int>(loops.size());
  check_loops(mesh, count, outer, inner);
  const Opened open = opened(mesh, loops[outer]);
  RicciCircles result;
  result.map.loop = in_order(count, outer, inner);

  std::vector<char> held(mesh.points.size() - 1, 0);
  for (const int v : open.link) held[open.in_rest[v]] = 1;
  std::vector<int> round_holes;
  for (std::size_t k = 1; k < loops.size(); ++k)
    round_holes.push_back(open.in_rest[mesh.surface.vertex(loops[result.map.loop[k]].sides.front())]);
  const std::vector<double> flat(held.size(), 0.0);
  VertexScaling scaling(open.rest, held, round_holes);
  const VertexScaling::Outcome outcome = scaling.solve(flat, options, progress);

  const std::vector<Complex> half_plane = in_half_plane(open, scaling.metric());
  std::vector<Complex>& position = result.map.position;
  position =
      in_disk(open, half_plane, center_of_disk(mesh, inner < 0 ? nullptr : &loops[inner], open, half_plane));
  Complex ahead = 1;
  if (count == 1) ahead = position[mesh.surface.vertex(loops[outer].sides.front())];
  if (count > 2) ahead = fitted(points_of(mesh.surface, loops[result.map.loop[2]], position)).center;
  for (Complex& z : position) z *= std::conj(ahead) / std::abs(ahead);

  CircularDomain& domain = result.map.domain;
  for (const int k : result.map.loop) {
    domain.circles.push_back(fitted(points_of(mesh.surface, loops[k], position)));
    domain.circularity = numeric::maximum(domain.circularity, domain.circles.back().circularity);
  }
  domain.rounds = outcome.steps;
  domain.found = outcome.found;
  result.residual = outcome.residual;
  return result;
}

} // namespace tetrarch::slit
