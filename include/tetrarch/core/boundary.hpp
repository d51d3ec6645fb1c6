// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The boundary components of a triangulated manifold: surfaces of boundary faces ("real"), and closed vertex
/// links other than spheres ("ideal"; the vertex is truncated, or a cusp).

#include "tetrarch/core/skeleton.hpp"

namespace tetrarch {

/// One component of the boundary: unglued faces (real) or the link of an ideal vertex.
struct BoundaryComponent {
  enum class Kind { real, ideal };
  Kind kind;
  SurfaceType type;
  VertexId vertex;            ///< of an ideal component
  std::vector<TetFace> faces; ///< of a real component
};

/// Real components by first boundary face, then ideal ones by vertex. O(n).
std::vector<BoundaryComponent> boundary_components(const Triangulation& tri, const Skeleton& skeleton);

/// The surface of all boundary faces; triangle k is faces[k], corner c its c-th t-vertex in increasing order.
/// O(n).
struct BoundarySurface {
  TriangulatedSurface surface;
  std::vector<TetFace> faces;
};
BoundarySurface boundary_surface(const Triangulation& tri, const Skeleton& skeleton);

} // namespace tetrarch
