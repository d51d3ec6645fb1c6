// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The truncation triangles of one vertex, unrolled: one lift of each, found breadth first over the link.

#include "tetrarch/embed/domain.hpp"

#include <algorithm>

namespace tetrarch::embed {

template <class Scalar>
struct UnrolledTriangle {
  TetVertex at;
  Matrix4<Scalar> copy; ///< of the domain, in which this lift lies
  int parent = -1;      ///< the triangle from which it was reached
};

/// Corner c of the triangle: where the edge to the c-th of the other three vertices leaves it.
template <class Scalar>
std::array<Vector4<Scalar>, 3> corners_of(const Domain<Scalar>& domain, TetVertex at) {
  std::array<Vector4<Scalar>, 3> corners;
  for (int c = 0; c < 3; ++c)
    corners[c] = corner(domain.vertices[at.tet], domain.types[at.tet], at.vertex, face_vertex[at.vertex][c]);
  return corners;
}

/// From a given triangle. O(size of the link + n).
template <class Scalar>
std::vector<UnrolledTriangle<Scalar>> unroll_from(const Triangulation& tri, const Domain<Scalar>& domain,
                                                  TetVertex first) {
  std::vector<std::array<char, 4>> seen(static_cast<std::size_t>(tri.size()), {0, 0, 0, 0});
  std::vector<UnrolledTriangle<Scalar>> queue{{first, identity<Scalar>(), -1}};
  seen[first.tet][first.vertex] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const UnrolledTriangle<Scalar> here = queue[next];
    for (int f = 0; f < 4; ++f) {
      if (f == here.at.vertex) continue;
      const auto [other, perm] = tri.gluing({here.at.tet, f});
      const TetVertex there{other, perm[here.at.vertex]};
      if (seen[there.tet][there.vertex]) continue;
      seen[there.tet][there.vertex] = 1;
      queue.push_back({there, here.copy * domain.across({here.at.tet, f}), static_cast<int>(next)});
    }
  }
  return queue;
}

/// From the triangle in the middle of the polygon that they make up: the one nearest to the centroid of the
/// polygon unrolled from the first. Distances, and with them rounding errors, come out smallest.
template <class Scalar>
std::vector<UnrolledTriangle<Scalar>> unroll(const Triangulation& tri, const Skeleton& skeleton,
                                             const Domain<Scalar>& domain, VertexId vertex) {
  const auto triangles = unroll_from(tri, domain, skeleton.preimages(vertex).front());
  std::vector<Vector4<Scalar>> middle;
  middle.reserve(triangles.size());
  for (const auto& triangle : triangles)
    middle.push_back(triangle.copy * centroid(corners_of(domain, triangle.at)));
  const Vector4<Scalar> center_of_all = centroid(middle);
  const auto nearest =
      std::max_element(middle.begin(), middle.end(), [&center_of_all](const auto& a, const auto& b) {
        return inner(a, center_of_all) < inner(b, center_of_all);
      });
  return unroll_from(tri, domain, triangles[static_cast<std::size_t>(nearest - middle.begin())].at);
}

} // namespace tetrarch::embed
