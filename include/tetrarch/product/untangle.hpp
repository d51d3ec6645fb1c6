// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Untangling hexahedra by the energy of the room `unfold`.
///
///      .--.--.--.     At each of its eight corners a hexahedron has a tetrahedron, which would like to be
///      |  | /|  |     the corner of a cube. Points inside move freely. Points of the surface slide: in a
///      .--.  .--.     plane where all squares around them lie in it, along a straight ridge where they lie
///      |  |/  \ |     in two planes; all others stay. So the solid that is filled remains the same.
///      '--'--'--'
///
/// The corners of a hexahedron may all be good and its middle not: so the best mesh by scaled Jacobians is
/// kept, the start included.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/hex_mesh.hpp"

#include <cstdint>
#include <vector>

namespace tetrarch::product {

/// How a point of a mesh may move.
struct Sliding {
  enum class Kind : std::uint8_t { free, plane, ridge, fixed } kind = Kind::free;
  numeric::Vector direction{}; ///< unit: the normal of the plane, or along the ridge
};

/// Of each point. The surface is made of the squares that belong to one hexahedron only. O(n log n).
std::vector<Sliding> sliding(const HexMesh& mesh);

struct Untangled {
  int bad_before = 0; ///< hexahedra of scaled Jacobian 0 or less
  int bad_after = 0;
  double minimum_before = 1;
  double minimum_after = 1;
  int sliding = 0; ///< points of the surface that may move
  int iterations = 0;
};

/// Points with `fixed` not 0 stay, if any are given; otherwise all move as `sliding` says. Throws
/// PreconditionError unless `fixed` is empty or has a value for each point. O(n) an iteration.
Untangled untangle(HexMesh& mesh, const std::vector<char>& fixed = {}, const Progress& progress = {});

} // namespace tetrarch::product
