// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "unroll.hpp"

#include <algorithm>
#include <map>

namespace tetrarch::embed {
namespace {

/// The point on the surface (plane or horosphere of v) nearest to a point near it.
Vector4<double> onto_surface(const Vector4<double>& x, const Vector4<double>& v, VertexType type) {
  if (type == VertexType::hyperideal) return normalized(combination(1.0, x, -inner(x, v), v));
  return onto_horosphere(x, v);
}

double distance_from_surface(const Vector4<double>& x, const Vector4<double>& v, VertexType type) {
  const double w = inner(x, v);
  return type == VertexType::hyperideal ? std::abs(std::asinh(w)) : std::abs(std::log(-w));
}

/// The unit vector perpendicular to the given orthonormal ones (`t` time-like, `n` space-like) towards x.
Vector4<double> tangent_towards(const Vector4<double>& x, const Vector4<double>& t,
                                const Vector4<double>& n) {
  return normalized(combination(1.0, combination(1.0, x, inner(x, t), t), -inner(x, n), n));
}

/// The isometry that brings the surface of v into the position the header promises: `center` to height 1 over
/// 0, `corner` above it (below z = 1: to the right of it).
Matrix4<double> upright(const Vector4<double>& v, VertexType type, const Vector4<double>& center,
                        const Vector4<double>& corner) {
  // The plane's outward normal points towards the viewer, who stands at y < 0; the horosphere's centre goes
  // up.
  const Vector4<double> n =
      type == VertexType::hyperideal ? scaled(-1.0, v) : combination(1.0, v, -1.0, center);
  const Vector4<double> side = tangent_towards(corner, center, n);
  Vector4<double> last = normalized(cross(side, n, center));
  const auto frame = [&] {
    return type == VertexType::hyperideal ? matrix_with_columns<double>({last, n, side, center})
                                          : matrix_with_columns<double>({side, last, n, center});
  };
  if (numeric::determinant(frame()) < 0) last = scaled(-1.0, last);
  return inverse(reorthonormalized(frame()));
}

BoundaryLift lift(const Triangulation& tri, const Skeleton& skeleton, const Domain<double>& domain,
                  VertexId vertex) {
  const auto triangles = unroll(tri, skeleton, domain, vertex);
  const TetVertex first = triangles.front().at;
  BoundaryLift result;
  result.vertex = vertex;
  result.type = domain.types[first.tet][first.vertex];
  const Vector4<double>& v = domain.vertices[first.tet][first.vertex];
  const auto start = corners_of(domain, first);
  const Vector4<double> center = onto_surface(centroid(start), v, result.type);
  const Matrix4<double> to_picture = upright(v, result.type, center, start[0]);

  std::map<TetVertex, const Matrix4<double>*> copy_of;
  for (const auto& triangle : triangles) {
    result.triangles.push_back(triangle.at);
    result.parent.push_back(triangle.parent);
    copy_of[triangle.at] = &triangle.copy;
    auto& corners = result.corners.emplace_back(corners_of(domain, triangle.at));
    for (Vector4<double>& x : corners) {
      x = triangle.copy * x;
      result.off_surface = numeric::maximum(result.off_surface, distance_from_surface(x, v, result.type));
      x = to_picture * x;
      result.size = numeric::maximum(result.size, distance(base_point<double>, x));
    }
  }
  for (const auto& triangle : triangles)
    for (int f = 0; f < 4; ++f) {
      if (f == triangle.at.vertex) continue;
      const auto [other, perm] = tri.gluing({triangle.at.tet, f});
      const Matrix4<double>& there = *copy_of.at({other, perm[triangle.at.vertex]});
      const Matrix4<double> step = triangle.copy * domain.across({triangle.at.tet, f}) * inverse(there);
      if (relative_difference(step, identity<double>()) < 1e-6) continue; // the side is inside the polygon
      result.pairings.push_back(reorthonormalized(to_picture * step * inverse(to_picture)));
    }
  return result;
}

} // namespace

std::vector<BoundaryLift> boundary_lifts(const Triangulation& tri, const Skeleton& skeleton,
                                         const Domain<double>& domain) {
  skeleton.require_current(tri);
  std::vector<BoundaryLift> lifts;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (hyperbolic::vertex_type(skeleton.link(v)) != VertexType::finite)
      lifts.push_back(lift(tri, skeleton, domain, v));
  return lifts;
}

} // namespace tetrarch::embed
