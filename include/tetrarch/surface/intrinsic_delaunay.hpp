// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The intrinsic Delaunay triangulation of a triangle mesh: the same surface and the same vertices, other
/// edges, which run straight across the triangles of the mesh.
///
///        a                 a           An edge is flipped where the two angles opposite have more than
///       / \               /|\          half a turn together, that is, where its cotangents add up to less
///      u---v     -->     u | v         than 0; lengths are all that the new edge needs. In the end no weight
///       \ /               \|/          of the Laplacian is negative, so harmonic functions have no extrema
///        b                 b           inside, however thin the triangles of the mesh are.
///
/// Of all triangulations on these vertices this one gives linear functions the least Dirichlet energy.
/// Source: Fisher, Springborn, Schroeder and Bobenko, "An algorithm for the construction of intrinsic
/// Delaunay triangulations" (2007).

#include "tetrarch/surface/triangle_mesh.hpp"

#include <vector>

namespace tetrarch::surface {

/// Triangles given by the lengths of their sides.
struct IntrinsicTriangulation {
  Surface surface;            ///< may have loops and double edges
  std::vector<double> length; ///< of each side
  long long flips = 0;
  /// Whether nothing is left to flip. The number of flips is bounded only by O(n^2); the budget is 100 for
  /// each triangle.
  bool is_delaunay = true;
};

/// Boundary edges stay. `closed` holds numbers on the sides that add up to 0 around each triangle and are
/// opposite on mates; they are carried over to the new triangles, where the same holds. Throws InputError
/// with the number of a triangle without area; PreconditionError if mates are turned. O(n + flips).
IntrinsicTriangulation intrinsic_delaunay(const TriangleMesh& mesh,
                                          std::vector<std::vector<int>>* closed = nullptr);

/// For each side half the cotangent of the opposite angle, in triangles of these lengths. Throws InputError
/// with the number of a triangle whose lengths leave it no area, as those of a needle of 1e-8 may. O(n).
std::vector<double> half_cotangents(const IntrinsicTriangulation& triangulation);

} // namespace tetrarch::surface
