// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A solid: a tetrahedral mesh that fills the inside of one closed surface.
///
///        .-------.        The promise, beyond that of `solid::TetMesh`: the tetrahedra hang together through
///       /  .-.  /|        faces, each has positive volume, and their outer faces make one closed surface,
///      .--'---'. |        which is given as such, seen from outside. A surface vertex and the mesh vertex
///      |       |/         that it is go by different numbers.
///      '-------'

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/solid/tet_mesh.hpp"
#include "tetrarch/surface/surface.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

using numeric::Point;

/// A mesh of a solid, with its gluings and its boundary.
struct Solid {
  solid::TetMesh mesh;
  Triangulation gluings;        ///< tetrahedron t of the mesh is tetrahedron t, its v-th point vertex v
  surface::Surface boundary;    ///< triangles counterclockwise seen from outside
  std::vector<int> vertex;      ///< of each vertex of the boundary, that of the mesh
  std::vector<int> on_boundary; ///< of each vertex of the mesh, that of the boundary; -1 inside
  std::vector<TetFace> face;    ///< of each triangle of the boundary
  std::vector<int> outside;     ///< of face f of tetrahedron t, at 4 t + f: the triangle; -1 inside

  const Point& point(int v) const { return mesh.points[static_cast<std::size_t>(v)]; }
  const std::array<int, 4>& corners(int t) const { return mesh.tetrahedra[static_cast<std::size_t>(t)]; }
  int size() const { return static_cast<int>(mesh.tetrahedra.size()); }
  /// Corner c of a triangle of the boundary, as a vertex of the mesh.
  int corner(int triangle, int c) const {
    return vertex[static_cast<std::size_t>(boundary.corners(triangle)[static_cast<std::size_t>(c)])];
  }
};

/// Throws InputError with the tetrahedron (counted from 0) or a description of the boundary, unless the mesh
/// keeps the promise, and unless it is between 1e-50 and 1e50 across. Signs of volumes are exact. Linear but
/// for sorting faces.
Solid solid_of(solid::TetMesh mesh);

/// The sum over the tetrahedra. O(n).
double volume(const Solid& solid);

/// The genus of the boundary: how many handles the solid has, if it is a handlebody.
int genus(const Solid& solid);

} // namespace tetrarch::product
