// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangle mesh: a connected surface, and a point in space for each of its vertices.
///
/// The promise: indices are in range, every point is used, the three of a triangle differ, no two triangles
/// name the same three, at most two share an edge, and the triangles around a vertex make one fan.
/// Coordinates are finite. Mates are turned only where the surface is not orientable. The surface may meet
/// itself in space.
///
/// A reader of files returns a soup, which promises nothing; doctor/build.hpp makes a mesh of it.

#include "tetrarch/surface/surface.hpp"

#include <array>
#include <vector>

namespace tetrarch::surface {

/// A surface with coordinates.
struct TriangleMesh {
  std::vector<std::array<double, 3>> points;
  Surface surface;
};

} // namespace tetrarch::surface
