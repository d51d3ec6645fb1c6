// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A polycube's cubes carried into a solid, the best of the ways that were tried.

#include "tetrarch/workshop/product.hpp"

#include <optional>

namespace tetrarch::workshop {

/// None if no way was open.
struct CarriedCubes {
  std::optional<product::SolidHexahedra> hexahedra;
  product::HexQuality quality;
  const char* how = "";

  /// Whether no other way needs to be tried.
  bool is_good() const;
};

/// By a map of all of the solid that turns no tetrahedron over: the one given, or one that agrees with it on
/// the boundary and is harmonic inside. No partition is needed. Throws InputError where the boundary is no
/// polycube.
CarriedCubes carried_by_map(const product::Solid& solid, const PolycubeImage& polycube, int threads,
                            const Progress& progress);

/// Along fibers, if that is better than what there is. The images of vertices made by splitting edges lie on
/// the images of these. Throws InputError if no way was open at all.
void try_fibers(CarriedCubes& carried, const PartitionedSolid& start, const PolycubeImage& polycube,
                int threads, const Progress& progress);

} // namespace tetrarch::workshop
