// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra of `product`: made, measured, and told with what is to be doubted.

#include "command.hpp"
#include "product_files.hpp"

#include "tetrarch/product/product.hpp"

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

/// From the polycube. Throws InputError.
void add_polycube(SolidProduct& made, const product::Solid& solid, const product::Partition& partition,
                  const HexahedraOptions& options, const Context& context);

} // namespace tetrarch::program
