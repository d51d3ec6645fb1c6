// SPDX-License-Identifier: GPL-2.0-or-later
#include "start.hpp"

#include "tetrarch/hex/limbs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetrarch::hex {
namespace {

/// Where flat patches lie that face along an axis: there the grid gets a plane.
std::array<std::vector<double>, 3> flat_sides(const Targets& targets) {
  constexpr double along = 0.9999;
  std::array<std::vector<double>, 3> result;
  const Features& features = targets.features();
  std::vector<Vector> least(static_cast<std::size_t>(features.patches), {1, 1, 1});
  std::vector<Point> at(least.size());
  for (int t = 0; t < targets.whole().size(); ++t) {
    const int p = features.patch[t];
    for (std::size_t a = 0; a < 3; ++a)
      least[p][a] = std::min(least[p][a], std::abs(targets.whole().normal(t)[a]));
    at[p] = targets.whole().corners(t)[0];
  }
  for (std::size_t p = 0; p < least.size(); ++p)
    for (std::size_t a = 0; a < 3; ++a)
      if (least[p][a] > along) result[a].push_back(at[p][a]);
  return result;
}

} // namespace

std::optional<SizedHexahedra> cells_in(const product::Solid& solid, const Targets& targets, double edge,
                                       const Progress& progress) {
  const int genus = product::genus(solid);
  const auto sides = flat_sides(targets);
  // Flat cells, as the second grid may have them, are for solids that are thin between flat sides.
  for (const double apart : {0.4, 0.001}) {
    const Grid grid = grid_around(solid.mesh.points, edge, sides, apart);
    const std::vector<float> full = filled(solid, solid.mesh.points, grid, progress);
    const std::vector<char> met = met_cells(solid, grid, full, progress);
    for (const double least : {0.5, 0.35, 0.65, 0.2, 0.8}) {
      if (!chosen_cells(grid, full, genus, least)) continue;
      const auto can_be_chosen = [&](const std::vector<float>& f) {
        return chosen_cells(grid, f, genus, least).has_value();
      };
      const std::vector<float> fuller = with_limbs(grid, full, met, least, can_be_chosen, progress);
      return cells_of(grid, *chosen_cells(grid, fuller, genus, least));
    }
  }
  return std::nullopt;
}

} // namespace tetrarch::hex
