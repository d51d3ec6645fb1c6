// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra of `product`: made, measured, and told with what is to be doubted.

#include "command.hpp"
#include "product_files.hpp"
#include "product_partition.hpp"

#include "tetrarch/format/soup.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/product/product.hpp"

#include <optional>
#include <string>

namespace tetrarch::program {

/// Options as typed.
struct HexahedraOptions {
  int across = 0; ///< 0: none between floor and ceiling
  int layers = 0; ///< 0: cells as high as wide
  bool smooth = false;
  std::string polycube; ///< a file; empty: none
  double step = 1;      ///< of the polycube's lattice
  int cells = 4;
  /// Cells with straight edges cut the corners of what is round: of a circle in n chords 6.6 / n^2 of the
  /// area is lost, which is 2 % with 18. Up to there it is the resolution that was asked for; beyond, a part
  /// of the solid is likely to be missing.
  double volume_tolerance = 0.02;
};

/// On a grid of the floor, which must be found, along the fibers.
void add_hexahedra(SolidProduct& made, const product::FiberField& field, const product::FloorMap& floor,
                   const HexahedraOptions& options, const Context& context);

/// Cubes carried into a solid, the best of the ways that were tried; none if no way was open.
struct CarriedCubes {
  std::optional<product::SolidHexahedra> hexahedra;
  product::HexQuality quality;
  std::string how;

  /// Whether no other way needs to be tried.
  bool is_good() const;
};

/// By a map of all of the solid that turns no tetrahedron over: the one in the polycube's file, whose vertex
/// k is the image of the solid's vertex k, or one that agrees with it on the boundary and is harmonic inside.
/// No partition is needed. Throws InputError where the boundary is no polycube.
CarriedCubes carried_by_map(const product::Solid& solid, const format::Soup& polycube,
                            const HexahedraOptions& options, const Context& context);

/// What hexahedra are measured against.
struct MeasuredSolid {
  double volume = 0;
  std::vector<std::array<product::Point, 3>> boundary;
};
MeasuredSolid measured(const product::Solid& solid);

/// Along fibers, if that is better than what there is. The images of vertices made by splitting edges lie on
/// the images of these. Throws InputError if no way was open at all.
void try_fibers(CarriedCubes& carried, const PartitionedSolid& solid, const format::Soup& polycube,
                const HexahedraOptions& options, const Context& context);

/// Throws PreconditionError if there are none.
void add_polycube(SolidProduct& made, CarriedCubes carried, const MeasuredSolid& solid,
                  const HexahedraOptions& options, const Context& context);

} // namespace tetrarch::program
