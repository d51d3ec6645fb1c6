// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Direct product parameterisation: coordinates (u, v, w) of a handlebody in (a disk with holes) x (an
/// interval).
///
///        solid                     domain            (u, v): conformal on the floor, constant along fibres.
///       .-------.                 .--------.         w: harmonic. Orthogonal to u and v, if the mesh is fine
///      /  ,-.  / \     ----->    /  ,-.   /|         enough; u to v on the floor, elsewhere only where the
///     |  '-'  |  |              /--------/ |         solid is a product itself.
///      \_____/|_/               |________|/
///
/// Source: Yin, chapter 3.

#include "tetrarch/mesh/triangle_mesh.hpp"
#include "tetrarch/product/fibers.hpp"
#include "tetrarch/product/field.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace tetrarch::product {

/// The floor laid into the plane.
enum class FloorDomain : std::uint8_t {
  circular, ///< the unit disk with round holes
  rectangle ///< a rectangle of width 1 with rectangular holes
};

struct FloorMap {
  mesh::TriangleMesh mesh;   ///< the floor, its triangles counterclockwise seen from inside of the solid
  std::vector<int> vertex;   ///< of each of its vertices, that of the solid
  std::vector<int> triangle; ///< of each of its triangles, that of the solid's boundary
  std::vector<std::complex<double>> position; ///< of each vertex
  /// Of a rectangle: that of each hole, by its lower left and upper right corner.
  std::vector<std::array<std::complex<double>, 2>> rectangles;
  double height = 0; ///< of a rectangle; its width is 1
  int flipped = 0;   ///< triangles
  bool found = true; ///< whether the solver converged
};

} // namespace tetrarch::product
