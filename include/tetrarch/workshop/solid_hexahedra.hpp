// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra that were carried into a solid: improved, measured against it, and told with what is to be
/// doubted.
///
///     MeasuredHexahedra found;
///     found.of = product::hexahedra(field, grid, nodes);
///     improve_and_measure(found, measure_of(solid));
///     if (found.doubts().empty()) use(found.of.mesh);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/deviation.hpp"
#include "tetrarch/product/grid.hpp"
#include "tetrarch/product/hexahedra.hpp"
#include "tetrarch/product/smooth.hpp"
#include "tetrarch/product/untangle.hpp"
#include "tetrarch/workshop/fields.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

struct HexahedraOptions {
  bool smooth = false; ///< untangle them where that is needed, and smooth them
  /// Cells with straight edges cut the corners of what is round: of a circle in n chords 6.6 / n^2 of the
  /// area is lost, which is 2 % with 18. Up to there it is the resolution that was asked for; beyond, a part
  /// of the solid is likely to be missing.
  double volume_tolerance = 0.02;
};

/// What hexahedra are measured against.
struct SolidMeasure {
  double volume = 0;
  std::vector<std::array<product::Point, 3>> boundary; ///< its triangles
};
/// O(n).
SolidMeasure measure_of(const product::Solid& solid);

/// It owns all that it speaks of.
struct MeasuredHexahedra {
  product::SolidHexahedra of;
  std::string carried_by;                 ///< of a polycube: by which map, in words
  std::optional<product::FloorGrid> grid; ///< of those between floor and ceiling; nothing: of a polycube

  std::optional<product::Untangled> untangled;
  struct Smoothing {
    product::Smoothed done;
    product::HexQuality before;
  };
  std::optional<Smoothing> smoothing;

  product::HexQuality quality;
  double volume = 0;
  double solid_volume = 0;
  hex::Deviation deviation;    ///< between the surfaces of both
  double volume_tolerance = 0; ///< relative

  double volume_error() const; ///< relative to the solid's
  /// Why these are no mesh of the solid to rely on, a clause each; empty: they are.
  std::vector<std::string> doubts() const;
};

/// Improves `found.of` if that is asked for, and fills in all below. Points of the mesh's surface slide in
/// its planes and along its straight ridges, all others of the surface stay. O(n log n) and O(n) an
/// iteration. Throws Stopped.
void improve_and_measure(MeasuredHexahedra& found, const SolidMeasure& solid,
                         const HexahedraOptions& options = {}, const Progress& progress = {});

Rows rows_of(const MeasuredHexahedra& found);

template <>
const FieldList<MeasuredHexahedra>& fields_of<MeasuredHexahedra>();

} // namespace tetrarch::workshop
