// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `product` says, as JSON and as text. Vertices go by the names of the input: those put in by splitting
/// edges have the numbers after them.

#include "report.hpp"

#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/grid.hpp"
#include "tetrarch/product/hexahedra.hpp"
#include "tetrarch/product/product.hpp"
#include "tetrarch/product/smooth.hpp"

#include <string>

namespace tetrarch::program {

/// `how` the partition was found.
Report partition_report(const product::Solid& solid, const product::Partition& partition,
                        const std::string& how);
Report floor_report(const product::FloorMap& floor);
Report field_report(const product::HarmonicField& field, double height, int splits, bool clamped);
Report critical_report(const product::Solid& solid, const product::CriticalPlaces& places);
Report coordinates_report(const product::Coordinates& coordinates);
Report quality_report(const product::Quality& quality);
Report confirmation_report(const product::Confirmation& confirmation);
Report hexahedra_report(const product::SolidHexahedra& hexahedra, const product::HexQuality& quality);
Report grid_report(const product::FloorGrid& grid);
Report smoothed_report(const product::Smoothed& smoothed, const product::HexQuality& before);

} // namespace tetrarch::program
