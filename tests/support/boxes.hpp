// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Boxes to fold and to unfold.

#include "support/random.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tetrarch::support {

/// A box of n x n x n cubes, six tetrahedra each, around the diagonal.
struct Box {
  explicit Box(int size) : n(size) {
    for (int z = 0; z <= n; ++z)
      for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
          points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
          const bool is_outside = x == 0 || y == 0 || z == 0 || x == n || y == n || z == n;
          problem.freedom.push_back(
              {is_outside ? unfold::Freedom::Kind::fixed : unfold::Freedom::Kind::free, {}});
        }
    using numeric::operator-;
    constexpr std::array<std::array<int, 4>, 6> six{
        {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
          for (const auto& tet : six) {
            std::array<int, 4> v{};
            for (std::size_t k = 0; k < 4; ++k)
              v[k] = at(x + (tet[k] & 1), y + (tet[k] >> 1 & 1), z + (tet[k] >> 2));
            const unfold::Point o = points[v[0]];
            problem.elements.push_back(
                unfold::element(v, {points[v[1]] - o, points[v[2]] - o, points[v[3]] - o}));
          }
  }
  int at(int x, int y, int z) const { return x + (n + 1) * (y + (n + 1) * z); }
  /// Moves what may move by up to `by` along each axis.
  void shake(double by, int seed) {
    Random random(seed);
    for (std::size_t v = 0; v < points.size(); ++v)
      for (double& x : points[v])
        if (problem.freedom[v].kind != unfold::Freedom::Kind::fixed) x += by * (2 * random.uniform() - 1);
  }

  int n;
  unfold::Problem problem;
  std::vector<unfold::Point> points;
};

} // namespace tetrarch::support
