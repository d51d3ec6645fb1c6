// SPDX-License-Identifier: GPL-2.0-or-later
#include "start.hpp"

#include "tetrarch/hex/limbs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
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

/// How many cells that the solid meets have neither been taken nor touch one that was, and how many that it
/// does not fill have neither been left nor touch one that was.
int lost_cells(const Grid& grid, const std::vector<float>& filled, const std::vector<char>& met,
               const std::vector<char>& chosen) {
  int count = 0;
  for (std::size_t cell = 0; cell < chosen.size(); ++cell) {
    const bool is_met = met[cell] != 0 && chosen[cell] == 0;
    const bool is_open = filled[cell] < 1 && chosen[cell] != 0;
    if (!is_met && !is_open) continue;
    const auto [x, y, z] = grid.cell(cell);
    bool is_lost = true;
    for (int k = std::max(0, z - 1); k <= std::min(z + 1, grid.cells(2) - 1); ++k)
      for (int j = std::max(0, y - 1); j <= std::min(y + 1, grid.cells(1) - 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(x + 1, grid.cells(0) - 1); ++i)
          if ((chosen[grid.index(i, j, k)] != 0) == is_met) is_lost = false;
    if (is_lost) ++count;
  }
  return count;
}

/// Fractions for which what is half full has the solid's genus: cells that were taken are, and of all it is
/// known still which are fuller. Of some choices that which loses least; nothing if none has the genus.
std::optional<std::vector<float>> fractions_for(const Grid& grid, const std::vector<float>& filled,
                                                const std::vector<char>& met, int genus,
                                                const Progress& progress) {
  // What is met is not empty, even if no sample point is inside.
  constexpr float hardly = 0.01F;
  std::vector<float> touched = filled;
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k] != 0) touched[k] = std::max(touched[k], hardly);
  constexpr int for_change = 10; // of the genus, in lost cells
  std::vector<char> best;
  int least = std::numeric_limits<int>::max();
  for (const double full : {0.5, 0.65, 0.35, 0.8, 0.2, 0.9, 0.1, 0.95, 0.05, 0.98, 0.02, 0.005}) {
    progress.step("cells");
    auto cells = thinned_cells(grid, touched, genus, full);
    if (!cells) continue;
    const int cost = for_change * cells->changes + lost_cells(grid, filled, met, cells->chosen);
    if (cost < least) best = std::move(cells->chosen);
    least = std::min(least, cost);
    if (least == 0) break;
  }
  if (best.empty()) return std::nullopt;
  constexpr float half = 0.5F;
  constexpr float less = 0.49F;
  for (std::size_t k = 0; k < best.size(); ++k)
    touched[k] = best[k] != 0 ? half + half * filled[k] : less * filled[k];
  return touched;
}

/// Cells have so many times the volume of the solid at most: they would have to be squeezed as much.
constexpr double fattest = 8;

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
    const auto fractions = fractions_for(grid, full, met, genus, progress);
    if (!fractions) continue;
    constexpr double half = 0.5;
    const auto can_be_chosen = [&](const std::vector<float>& f) {
      return chosen_cells(grid, f, genus, half).has_value();
    };
    const std::vector<float> fuller = with_limbs(grid, *fractions, met, half, can_be_chosen, progress);
    const auto chosen = chosen_cells(grid, fuller, genus, half);
    if (!chosen) continue;
    SizedHexahedra cells = cells_of(grid, *chosen);
    if (product::volume(cells.mesh) <= fattest * product::volume(solid)) return cells;
  }
  return std::nullopt;
}

} // namespace tetrarch::hex
