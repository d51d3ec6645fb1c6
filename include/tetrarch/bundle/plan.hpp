// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From a surface to the recipe of its unit tangent bundle, or of the circle bundle of any Euler number.
///
/// | surface         | cut along                             | twisted                         |
/// | --------------- | ------------------------------------- | ------------------------------- |
/// | disk            | nothing (chapter 5)                   | nothing                         |
/// | sphere          | an equator of abs(e) N edges (chap. 6) | all of it, by -1 for e > 0      |
/// | genus g >= 1    | 2g canonical loops (chapter 7)        | N edges on each of loops 3 - 2g |
/// | everything else | a short cut graph                     | abs(e) N edges of it            |
///
/// The text has equators and twisted loops of exactly abs(e) N and N edges. Shorter ones are split; of longer
/// ones the rest is not twisted. Canonical loops serve for every Euler number; a number other than chi is
/// spread over the last loops.

#include "tetrarch/bundle/circle_bundle.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace tetrarch::bundle {

struct PlanOptions {
  int fiber = 8;                          ///< N >= 1
  std::optional<int> euler;               ///< e, of a closed surface; chi unless given
  std::optional<BoundaryValues> boundary; ///< one for each of `boundary_sides`, of a surface with boundary
  enum class Cut : std::uint8_t {
    dissertation,
    any
  } cut = Cut::dissertation; ///< any: always a short cut graph
};

/// How the bundle is made: where the surface is cut, and where it is twisted.
struct Plan {
  enum class Method : std::uint8_t { disk, equator, canonical_loops, cut_graph } method = Method::disk;
  surface::MarkedSurface cut; ///< the surface, refined, some of its triangles turned over
  Recipe recipe;              ///< of the refined surface
  int euler = 0;              ///< 0 also where there is boundary
  /// Splits in all; the history is `cut.splits`.
  int splits() const { return static_cast<int>(cut.splits.size()); }
};

/// The recipe, or the reason why the boundary values allow none. The surface loses its marks. Throws
/// `PreconditionError` if it is not connected, if the resolution is less than 1, or if the surface can have
/// no Euler number or no boundary values but gets some. Coordinates may be of any finite size. Near-linear,
/// times the genus.
[[nodiscard]] std::variant<Plan, Obstruction> plan(surface::MarkedSurface surface, const PlanOptions& options,
                                                   const Progress& progress = {});

} // namespace tetrarch::bundle
