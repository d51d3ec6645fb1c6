// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>

namespace tetrarch::polycube {
namespace {

/// The gaps at each plane.
struct Constraints {
  Constraints(std::size_t planes, const std::vector<Gap>& all) : gaps(all), above(planes), below(planes) {
    for (std::size_t g = 0; g < all.size(); ++g) {
      above[all[g].low].push_back(static_cast<int>(g));
      below[all[g].high].push_back(static_cast<int>(g));
    }
  }
  const std::vector<Gap>& gaps;
  std::vector<std::vector<int>> above;
  std::vector<std::vector<int>> below;
};

/// Planes after all those below them; fewer than there are where gaps run in a circle.
std::vector<int> upwards(const Constraints& constraints) {
  std::vector<std::size_t> waits;
  std::vector<int> order;
  for (const auto& below : constraints.below) {
    waits.push_back(below.size());
    if (below.empty()) order.push_back(static_cast<int>(waits.size()) - 1);
  }
  for (std::size_t k = 0; k < order.size(); ++k)
    for (const int g : constraints.above[order[k]])
      if (--waits[constraints.gaps[g].high] == 0) order.push_back(constraints.gaps[g].high);
  return order;
}

/// The planes that move when one does, each by 1: those that would come too near.
std::vector<int> pushed(const Constraints& constraints, const std::vector<int>& at, int plane, int by) {
  std::vector<int> moved{plane};
  std::vector<char> is_moved(at.size());
  is_moved[plane] = 1;
  for (std::size_t k = 0; k < moved.size(); ++k)
    for (const int g : by > 0 ? constraints.above[moved[k]] : constraints.below[moved[k]]) {
      const Gap& gap = constraints.gaps[g];
      const int other = by > 0 ? gap.high : gap.low;
      if (is_moved[other] != 0 || at[gap.high] - at[gap.low] > 1) continue;
      is_moved[other] = 1;
      moved.push_back(other);
    }
  return moved;
}

/// By what the sum of squares grows if these planes move.
double growth(const Constraints& constraints, const std::vector<int>& at, const std::vector<double>& places,
              const std::vector<int>& moved, int by) {
  std::vector<char> is_moved(at.size());
  for (const int plane : moved) is_moved[plane] = 1;
  double sum = 0;
  const auto change = [by](double off) { return by * (2 * off + by); };
  constexpr double of_place = 1e-3; // planes in no gap, and a choice among equals
  for (const int plane : moved) {
    sum += of_place * change(at[plane] - places[plane]);
    for (const int g : constraints.above[plane]) {
      const Gap& gap = constraints.gaps[g];
      if (is_moved[gap.high] == 0)
        sum += gap.weight * -by * (2 * (at[gap.high] - at[gap.low] - gap.width) - by);
    }
    for (const int g : constraints.below[plane]) {
      const Gap& gap = constraints.gaps[g];
      if (is_moved[gap.low] == 0) sum += gap.weight * change(at[gap.high] - at[gap.low] - gap.width);
    }
  }
  return sum;
}

} // namespace

std::optional<std::vector<int>> rounded_places(const std::vector<double>& places,
                                               const std::vector<Gap>& gaps, const Progress& progress) {
  const Constraints constraints(places.size(), gaps);
  const std::vector<int> order = upwards(constraints);
  if (order.size() < places.size()) return std::nullopt;
  std::vector<int> at(places.size());
  for (const int plane : order) {
    at[plane] = static_cast<int>(std::lround(places[plane]));
    for (const int g : constraints.below[plane]) at[plane] = std::max(at[plane], at[gaps[g].low] + 1);
  }
  constexpr double least = 1e-9;
  constexpr int most_rounds = 1000;
  bool is_changed = true;
  for (int round = 0; is_changed && round < most_rounds; ++round) {
    progress.step("rounding");
    is_changed = false;
    for (int plane = 0; plane < static_cast<int>(at.size()); ++plane)
      for (const int by : {1, -1}) {
        const std::vector<int> moved = pushed(constraints, at, plane, by);
        if (growth(constraints, at, places, moved, by) >= -least) continue;
        for (const int p : moved) at[p] += by;
        is_changed = true;
      }
  }
  return at;
}

} // namespace tetrarch::polycube
