// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The unit cubes of a polycube, and what they are in the solid.
///
///        solid M          polycube           A cube is found by a point near its middle, in the tetrahedron
///        .------.          .--.--.           whose image has it; its neighbors and its corners by straight
///       (   .---'  <----   |  |--'           walks from there through the images. So a polycube may overlap
///        `-'               '--'              itself, or touch itself, as that of a solid with narrow gaps
///                                            does: cubes are neighbors where a walk goes from one to the
///                                            other.
///
/// Corners have the same weights in their tetrahedron as in its image. Source: Gregson, Sheffer and Zhang,
/// "All-hex mesh generation via volumetric PolyCube deformation" (2011), section 3.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/product/solid.hpp"

#include <array>
#include <vector>

namespace tetrarch::polycube {

using numeric::Point;

struct Cells {
  product::HexMesh mesh;                   ///< in the solid; cubes by their places, in lexicographic order
  std::vector<std::array<int, 3>> lattice; ///< of each point of the mesh, in the polycube
  int lost = 0; ///< walks that did not arrive, by rounding: points beside may be wrong, or neighbors missing
};

/// The image of no tetrahedron may be folded, and the boundary's must lie in planes of integers. O(n + c) for
/// c cubes, if no tetrahedron is much larger than a cube. Throws Stopped.
Cells cells(const product::Solid& solid, const std::vector<Point>& image, const Progress& progress = {});

} // namespace tetrarch::polycube
