// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How far the surface of a mesh of hexahedra is from that of a solid, both ways.
///
///       .-----.           From points on one surface to the nearest of the other, and back: the greatest of
///      /       .  <-->    these distances is the Hausdorff distance, if the points are dense. One way alone
///     '---------'         misses what one of the two does not have at all.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/product/solid.hpp"

#include <array>
#include <vector>

namespace tetrarch::hex {

using product::Point;

struct Deviation {
  double from_hexahedra = 0; ///< the greatest distance of a point of theirs from the solid's surface
  double from_solid = 0;
  Point hexahedra_at{}; ///< where it is
  Point solid_at{};
  double diagonal = 0; ///< of the solid's box

  double greatest() const { return from_hexahedra > from_solid ? from_hexahedra : from_solid; }
  /// In terms of the diagonal.
  double relative() const { return greatest() / diagonal; }
  Point at() const { return from_hexahedra > from_solid ? hexahedra_at : solid_at; }
};

/// The triangles of a solid's boundary, seen from outside.
std::vector<std::array<Point, 3>> boundary_triangles(const product::Solid& solid);

/// Sampled: on each square of the hexahedra's surface 25 points, which cut it into 32 triangles; on each
/// triangle of the solid points that are no farther apart than half a mean edge of the squares. O(n log n).
Deviation deviation(const product::Solid& solid, const product::HexMesh& mesh, const Progress& progress = {});
/// The same for a solid's boundary.
Deviation deviation(std::vector<std::array<Point, 3>> boundary, const product::HexMesh& mesh,
                    const Progress& progress = {});

} // namespace tetrarch::hex
