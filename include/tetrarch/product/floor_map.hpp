// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The conformal map from the floor of a handlebody into the plane.
///
///       .------.            .------------.       circular:   the unit disk with round holes
///      /  ()  ()\           |  .-.   .-. |       rectangle:  of width 1, with rectangular holes whose sides
///     |  ()     |    or     |  '-'   '-' |                   are parallel to its own
///      \_______/            '------------'
///
/// The floor's triangles are turned, so that they are counterclockwise seen from inside of the solid, and so
/// is the map: with w upwards, (u, v, w) keeps the orientation. Of all disks with round holes, one hole is
/// in the middle; of more, the centroid of the floor goes there. Source: Yin, section 3.4.2.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/partition.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace tetrarch::product {

enum class FloorDomain : std::uint8_t { circular, rectangle };

struct FloorMap {
  surface::TriangleMesh mesh;                 ///< the floor, its triangles turned
  std::vector<int> vertex;                    ///< of each of its vertices, that of the solid
  std::vector<int> triangle;                  ///< of each of its triangles, that of the solid's boundary
  std::vector<std::complex<double>> position; ///< of each vertex
  /// Of a rectangle, each hole by its lower left and upper right corner, in the order of the walls.
  std::vector<std::array<std::complex<double>, 2>> rectangles;
  double height = 0; ///< of a rectangle; its width is 1
  int flipped = 0;   ///< triangles
  bool found = true; ///< whether the solver converged
};

struct FloorOptions {
  FloorDomain domain = FloorDomain::circular;
  /// Of a rectangle: the outer corners, vertices of the solid in the order 0, 1, 1 + i height, i height; if
  /// they are -1, corners of the rim are taken where there are some, else its extreme points in the diagonal
  /// directions of the floor's principal axes.
  std::array<int, 4> corners{-1, -1, -1, -1};
};

/// Throws InputError if the floor has triangles without area, or if a corner is not on the outer rim. Check
/// `found`: a mesh may be too coarse for the rectangle. A few sparse factorizations.
FloorMap floor_map(const Solid& solid, const Partition& partition, const FloorOptions& options = {},
                   const Progress& progress = {});

} // namespace tetrarch::product
