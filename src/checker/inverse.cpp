// SPDX-License-Identifier: GPL-2.0-or-later
#include "inverse.hpp"

#include <cmath>
#include <utility>

namespace tetrarch::checker {

std::optional<std::vector<std::vector<double>>> inverse(std::vector<std::vector<double>> m) {
  const std::size_t n = m.size();
  std::vector<std::vector<double>> result(n, std::vector<double>(n, 0));
  for (std::size_t i = 0; i < n; ++i) result[i][i] = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (!(std::abs(m[pivot][c]) > 0)) return std::nullopt;
    std::swap(m[pivot], m[c]);
    std::swap(result[pivot], result[c]);
    const double scale = 1 / m[c][c];
    for (std::size_t k = 0; k < n; ++k) {
      m[c][k] *= scale;
      result[c][k] *= scale;
    }
    for (std::size_t r = 0; r < n; ++r) {
      const double times = m[r][c];
      if (r == c || times == 0) continue;
      for (std::size_t k = 0; k < n; ++k) {
        m[r][k] -= times * m[c][k];
        result[r][k] -= times * result[c][k];
      }
    }
  }
  return result;
}

} // namespace tetrarch::checker
