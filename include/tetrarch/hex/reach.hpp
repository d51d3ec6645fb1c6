// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where a solid sticks out of the hexahedra that are to fill it.
///
///         .          The nearest point of the solid's surface tells a point of the hexahedra where to go,
///        / \         but never draws it out to a tip or into a groove: the flanks are always nearer. So
///       /---\        points of the solid ask as well: each finds the nearest square that faces as it does,
///      /|   |\       and would like to have it. What is far away counts more.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/targets.hpp"
#include "tetrarch/product/hex_mesh.hpp"

#include <vector>

namespace tetrarch::hex {

/// A point of a solid's surface.
struct SurfaceSample {
  Point at{};
  Vector normal{}; ///< of its triangle, unit
  double area = 0; ///< that it stands for
};

/// Points of the boundary that are no farther apart than `spacing` on a triangle, its corners among them, for
/// triangles that are not larger by far. O(points).
std::vector<SurfaceSample> surface_samples(const Targets& targets, double spacing);

/// For each point of the mesh the way that samples would like it to go: the mean of theirs, each counted by
/// its area times its distance, shares of a triangle's corners taken into account; none where nobody is
/// farther away than `least`. No way is longer than `most`. O(s log n).
std::vector<Vector> reach(const product::HexMesh& mesh, const std::vector<SurfaceSample>& samples,
                          double least, double most, const Progress& progress = {});

} // namespace tetrarch::hex
