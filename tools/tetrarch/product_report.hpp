// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `product` says, as JSON and as text. Vertices go by the names of the input: those put in by splitting
/// edges have the numbers after them.

#include "report.hpp"

#include "tetrarch/hex/deviation.hpp"
#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/grid.hpp"
#include "tetrarch/product/hexahedra.hpp"
#include "tetrarch/product/product.hpp"
#include "tetrarch/product/smooth.hpp"
#include "tetrarch/product/untangle.hpp"

#include <string>

namespace tetrarch::program {

/// `how` the partition was found.
Report partition_report(const product::Solid& solid, const product::Partition& partition,
                        const std::string& how);
Report floor_report(const product::FloorMap& floor);
Report field_report(const product::HarmonicField& field, double height, int splits, bool clamped);
Report critical_report(const product::Solid& solid, const product::CriticalPlaces& places);
Report coordinates_report(const product::Coordinates& coordinates);
/// Flipped tetrahedra go by their numbers in the files that are written.
Report quality_report(const product::Solid& solid, const product::Quality& quality);
Report confirmation_report(const product::Confirmation& confirmation);

/// Hexahedra with what they are measured by.
struct MeasuredHexahedra {
  const product::SolidHexahedra& of;
  const product::HexQuality& quality;
  double volume = 0;
  double solid_volume = 0;
  hex::Deviation deviation;    ///< between the surfaces of both
  double volume_error() const; ///< relative to the solid's
};
Report hexahedra_report(const MeasuredHexahedra& hexahedra);
Report grid_report(const product::FloorGrid& grid);

/// Why these hexahedra are no mesh of the solid to rely on; none: they are.
std::vector<std::string> doubts_about(const MeasuredHexahedra& hexahedra, double volume_tolerance);
/// Why these coordinates are none to rely on; none: the solid is a product, and they show it.
std::vector<std::string> doubts_about(const product::Coordinates& coordinates,
                                      const product::Quality& quality,
                                      const product::Confirmation& confirmation);
/// The answer to a question: "yes" with what it rests on, or "undecided" with all doubts.
struct Verdict {
  std::string key;      ///< in JSON
  std::string question; ///< in the table
  std::vector<std::string> doubts;
  std::string because;
};
Report verdict_report(const Verdict& verdict);
Report untangled_report(const product::Untangled& untangled);
Report smoothed_report(const product::Smoothed& smoothed, const product::HexQuality& before);

} // namespace tetrarch::program
