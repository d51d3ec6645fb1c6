// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A boundary component (or a cusp's cross-section) on its own: its truncation triangles unrolled in the
/// plane.
///
/// The triangles of one lift of a geodesic boundary component lie in one hyperbolic plane; walk over the link
/// of the vertex from the middle triangle and put each triangle down in this plane. The plane is then turned
/// into the vertical plane y = 0 of the upper half space, which is an upper half plane (figure 4.11 of the
/// dissertation), the middle of the first triangle at height 1 over 0, seen from outside the manifold in the
/// direction of growing y. The triangles of a cusp lie in a horosphere, a Euclidean plane, which is turned
/// into the horizontal plane z = 1, seen from above.

#include "tetrarch/embed/domain.hpp"

namespace tetrarch::embed {

struct BoundaryLift {
  VertexId vertex;
  VertexType type = VertexType::hyperideal; ///< or ideal
  std::vector<TetVertex> triangles;         ///< in the order in which they were reached
  std::vector<int> parent;                  ///< the triangle from which each was reached; -1 for the first
  /// corners[k][c]: where the edge from triangles[k] to the c-th of the other three vertices leaves it.
  std::vector<std::array<Vector4<double>, 3>> corners;
  /// The isometries of the plane or horosphere that take this polygon to its neighbors, each with its
  /// inverse: generators of the surface's group.
  std::vector<Matrix4<double>> pairings;
  double size = 0; ///< largest distance of a corner from the middle of the first triangle, the base point
  /// Largest distance of a corner from the surface on which all should lie.
  double off_surface = 0;
};

/// One for each vertex class that is not finite, by class. O(n).
std::vector<BoundaryLift> boundary_lifts(const Triangulation& tri, const Skeleton& skeleton,
                                         const Domain<double>& domain);

} // namespace tetrarch::embed
