// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A tetrahedral mesh: points in space, and tetrahedra that name four of them each.
///
///          3           The promise: indices are in range, the four of a tetrahedron differ, no two
///         /|\          tetrahedra name the same four, at most two share a face, and the tetrahedra around
///        / | \         every vertex and every edge hang together as in a 3-manifold with boundary. So the
///       0--|--2        mesh is a `Triangulation`, all of whose vertex links are spheres or disks.
///        \ | /         Coordinates are finite; of orientation nothing is promised (doctor/repair.hpp turns
///          1           all tetrahedra to positive volume), nor that no tetrahedra overlap.
///
/// A reader of files returns a soup, which promises nothing; doctor/build.hpp makes a mesh of it.

#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <vector>

namespace tetrarch::solid {

/// Tetrahedra with coordinates.
struct TetMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> tetrahedra;
};

/// Tetrahedron t of the mesh is tetrahedron t, its v-th point is vertex v; faces on the same three points are
/// glued. Boundary faces are those of one tetrahedron alone. Linear but for the sorting of the faces around
/// each point; about 25 bytes a tetrahedron besides the result.
Triangulation triangulation_of(const TetMesh& mesh);

} // namespace tetrarch::solid
