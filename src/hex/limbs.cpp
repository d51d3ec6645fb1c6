// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/limbs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;

/// So many ways are laid at most.
constexpr int most_ways = 400;

/// The cell of a place along an axis.
int place_of(const std::vector<double>& plane, double x) {
  const auto above = std::upper_bound(plane.begin(), plane.end(), x);
  return std::clamp(static_cast<int>(above - plane.begin()) - 1, 0, static_cast<int>(plane.size()) - 2);
}

/// Calls `visit` with the cells that share a face with one.
template <class Visit>
void visit_neighbors(const Grid& grid, std::size_t cell, const Visit& visit) {
  const std::array<int, 3> at = grid.cell(cell);
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      std::array<int, 3> next = at;
      next[axis] += step;
      if (next[axis] >= 0 && next[axis] < grid.cells(axis)) visit(grid.index(next[0], next[1], next[2]));
    }
}

/// One side, inside or outside: how full cells are of it, which of them it meets, and its largest piece.
class Half {
public:
  Half(const Grid& grid, std::vector<float> fullness, std::vector<char> met, const std::vector<char>& taken)
      : grid_(grid), fullness_(std::move(fullness)), met_(std::move(met)), piece_(largest_piece(taken)),
        covered_(piece_.size()) {
    for (std::size_t k = 0; k < piece_.size(); ++k)
      if (piece_[k] != 0) cover(k);
  }

  /// The cells of a way to what is lost farthest, which is not sought again; none: nothing is lost, or it
  /// cannot be reached.
  std::vector<std::size_t> way() {
    std::vector<double> reached(piece_.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> before(piece_.size());
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t k = 0; k < piece_.size(); ++k)
      if (piece_[k] != 0) {
        reached[k] = 0;
        visit_neighbors(grid_, k, [&](std::size_t n) { relax(k, n, reached, before, queue); });
      }
    Entry farthest{0, 0};
    while (!queue.empty()) {
      const double so_far = queue.top().first;
      const std::size_t k = queue.top().second;
      queue.pop();
      if (so_far > reached[k]) continue;
      if (covered_[k] == 0) farthest = std::max(farthest, {so_far, k});
      visit_neighbors(grid_, k, [&](std::size_t n) { relax(k, n, reached, before, queue); });
    }
    std::vector<std::size_t> result;
    if (!(farthest.first > 0)) return result;
    for (std::size_t k = farthest.second; piece_[k] == 0; k = before[k]) result.push_back(k);
    for (const std::size_t k : result) cover(k);
    std::reverse(result.begin(), result.end());
    return result;
  }

  void lay(const std::vector<std::size_t>& way) {
    for (const std::size_t k : way) piece_[k] = 1;
  }

private:
  template <class Queue>
  void relax(std::size_t from, std::size_t to, std::vector<double>& reached, std::vector<std::size_t>& before,
             Queue& queue) const {
    if (met_[to] == 0) return;
    constexpr double empty = 0.1; // dear, but passable
    const double there = reached[from] + 1 / (empty + fullness_[to]);
    if (!(there < reached[to])) return;
    reached[to] = there;
    before[to] = from;
    queue.emplace(there, to);
  }

  void cover(std::size_t cell) {
    const auto [x, y, z] = grid_.cell(cell);
    for (int k = std::max(0, z - 1); k <= std::min(z + 1, grid_.cells(2) - 1); ++k)
      for (int j = std::max(0, y - 1); j <= std::min(y + 1, grid_.cells(1) - 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(x + 1, grid_.cells(0) - 1); ++i)
          covered_[grid_.index(i, j, k)] = 1;
  }

  /// Joined by faces. Where none is taken it begins with the fullest cell.
  std::vector<char> largest_piece(const std::vector<char>& taken) const {
    std::vector<char> seen(taken.size());
    std::vector<std::size_t> best;
    for (std::size_t first = 0; first < taken.size(); ++first) {
      if (taken[first] == 0 || seen[first] != 0) continue;
      std::vector<std::size_t> piece{first};
      seen[first] = 1;
      for (std::size_t k = 0; k < piece.size(); ++k)
        visit_neighbors(grid_, piece[k], [&](std::size_t n) {
          if (taken[n] == 0 || seen[n] != 0) return;
          seen[n] = 1;
          piece.push_back(n);
        });
      if (piece.size() > best.size()) best = std::move(piece);
    }
    if (best.empty() && !fullness_.empty())
      best = {
          static_cast<std::size_t>(std::max_element(fullness_.begin(), fullness_.end()) - fullness_.begin())};
    std::vector<char> result(taken.size());
    for (const std::size_t k : best) result[k] = 1;
    return result;
  }

  const Grid& grid_;
  std::vector<float> fullness_;
  std::vector<char> met_;
  std::vector<char> piece_;
  std::vector<char> covered_;
};

} // namespace

std::vector<char> met_cells(const product::Solid& solid, const Grid& grid, const std::vector<float>& filled,
                            const Progress& progress) {
  constexpr double steps = 3; // in a cell
  std::vector<char> met(filled.size());
  for (std::size_t k = 0; k < met.size(); ++k) met[k] = filled[k] > 0 ? 1 : 0;
  const auto& plane = grid.plane[0];
  const double edge = (plane.back() - plane.front()) / static_cast<double>(plane.size() - 1);
  for (int t = 0; t < solid.size(); ++t) {
    if (t % 1024 == 0) progress.step("limbs", t / static_cast<double>(solid.size()));
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Point& p = solid.point(solid.corners(t)[i]);
        const Point& q = solid.point(solid.corners(t)[j]);
        // A grid of more cells along a line does not fit into memory.
        const int n = static_cast<int>(std::clamp(std::ceil(steps * distance(p, q) / edge), 1.0, 1e5));
        for (int k = 0; k <= n; ++k) {
          const Point x = p + k / static_cast<double>(n) * (q - p);
          met[grid.index(place_of(grid.plane[0], x[0]), place_of(grid.plane[1], x[1]),
                         place_of(grid.plane[2], x[2]))] = 1;
        }
      }
  }
  return met;
}

std::vector<float> with_limbs(const Grid& grid, std::vector<float> filled, const std::vector<char>& met,
                              double full, const CanBeChosen& can_be_chosen, const Progress& progress) {
  for (const bool is_inside : {true, false}) {
    std::vector<float> fullness = filled;
    std::vector<char> meets = met;
    std::vector<char> taken(filled.size());
    for (std::size_t k = 0; k < filled.size(); ++k) {
      const bool is_taken = filled[k] >= full && filled[k] > 0;
      taken[k] = is_taken == is_inside ? 1 : 0;
      if (is_inside) continue;
      fullness[k] = 1 - filled[k];
      meets[k] = filled[k] < 1 ? 1 : 0;
    }
    Half side(grid, std::move(fullness), std::move(meets), taken);
    for (int ways = 0; ways < most_ways; ++ways) {
      progress.step("limbs", ways / static_cast<double>(most_ways));
      std::vector<std::size_t> way = side.way();
      if (way.empty()) break;
      const std::size_t length = way.size();
      for (std::size_t quarters = 4; quarters > 0; --quarters) {
        way.resize(length * quarters / 4);
        std::vector<float> with_way = filled;
        for (const std::size_t k : way) with_way[k] = is_inside ? 1 : 0;
        if (way.empty() || !can_be_chosen(with_way)) continue;
        filled = std::move(with_way);
        side.lay(way);
        break;
      }
    }
  }
  return filled;
}

} // namespace tetrarch::hex
