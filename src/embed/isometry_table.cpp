// SPDX-License-Identifier: GPL-2.0-or-later
#include "isometry_table.hpp"

#include "tetrarch/numeric/maximum.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::embed {
namespace {

constexpr double cells_per_unit = 1024;
constexpr double shift = 0.3819660112501051;
/// In cells: what `same_isometry` may move a coordinate by.
constexpr double margin = 2 * same_isometry * cells_per_unit;

/// max |M - N| over the largest entry, which is the last one on the diagonal.
double largest_difference(const Matrix4<double>& m, const Matrix4<double>& n) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) most = numeric::maximum(most, std::abs(m[i][j] - n[i][j]));
  return most / n[3][3];
}

/// In cells.
std::array<double, 6> coordinates(const Matrix4<double>& m) {
  std::array<double, 6> at;
  for (int k = 0; k < 3; ++k) {
    at[k] = m[k][3] / m[3][3] * cells_per_unit + shift;
    at[3 + k] = m[3][k] / m[3][3] * cells_per_unit + shift;
  }
  return at;
}

std::array<int, 6> cell_of(const std::array<double, 6>& at) {
  std::array<int, 6> cell;
  for (int k = 0; k < 6; ++k) cell[k] = static_cast<int>(std::floor(at[k]));
  return cell;
}

} // namespace

IsometryTable::IsometryTable(const std::vector<Matrix4<double>>& isometries)
    : isometries_(&isometries), slots_(1024, -1) {}

std::uint64_t IsometryTable::slot(const std::array<int, 6>& cell) const {
  std::uint64_t h = 0x9e3779b97f4a7c15U;
  for (const int x : cell) {
    h ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    h *= 0xff51afd7ed558ccdU;
    h ^= h >> 32U;
  }
  return h & (slots_.size() - 1);
}

int IsometryTable::find_in(const std::array<int, 6>& cell, const Matrix4<double>& m) {
  for (std::uint64_t s = slot(cell); slots_[s] >= 0; s = (s + 1) & (slots_.size() - 1)) {
    const double apart = largest_difference(m, (*isometries_)[slots_[s]]);
    if (apart < same_isometry) {
      largest_duplicate_ = std::max(largest_duplicate_, apart);
      return slots_[s];
    }
    closest_ = std::min(closest_, apart);
  }
  return -1;
}

int IsometryTable::find(const Matrix4<double>& m) {
  const auto at = coordinates(m);
  const auto home = cell_of(at);
  std::array<int, 6> step{};
  std::array<int, 6> near_border;
  int borders = 0;
  for (int k = 0; k < 6; ++k) {
    const double above = at[k] - home[k];
    if (above < margin)
      step[k] = -1;
    else if (above > 1 - margin)
      step[k] = 1;
    if (step[k] != 0) near_border[borders++] = k;
  }
  for (unsigned choice = 0; choice < (1U << static_cast<unsigned>(borders)); ++choice) {
    auto cell = home;
    for (int b = 0; b < borders; ++b)
      if ((choice >> static_cast<unsigned>(b)) & 1U) cell[near_border[b]] += step[near_border[b]];
    const int found = find_in(cell, m);
    if (found >= 0) return found;
  }
  return -1;
}

void IsometryTable::enter(int index) {
  std::uint64_t s = slot(cell_of(coordinates((*isometries_)[index])));
  while (slots_[s] >= 0) s = (s + 1) & (slots_.size() - 1);
  slots_[s] = index;
}

void IsometryTable::add_last() {
  const int count = static_cast<int>(isometries_->size());
  if (2 * static_cast<std::size_t>(count) <= slots_.size()) {
    enter(count - 1);
    return;
  }
  slots_.assign(2 * slots_.size(), -1);
  for (int i = 0; i < count; ++i) enter(i);
}

} // namespace tetrarch::embed
