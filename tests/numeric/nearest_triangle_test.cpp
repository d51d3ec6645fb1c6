// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/nearest_triangle.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

using namespace tetrarch;
using namespace tetrarch::numeric;

TEST_CASE("the nearest point is that of all triangles tried", "[nearest_triangle]") {
  support::Random random(3);
  const auto point = [&] { return Point{random.uniform(), random.uniform(), random.uniform()}; };
  std::vector<std::array<Point, 3>> triangles;
  for (int k = 0; k < 200; ++k) {
    const Point at = point();
    triangles.push_back({at, at + 0.1 * point(), k % 7 == 0 ? at : at + 0.1 * point()});
  }
  const NearestTriangle tree(triangles);
  for (int k = 0; k < 100; ++k) {
    const Point p = point();
    // Second route: points of each triangle on a fine grid of weights are never nearer.
    double least = std::numeric_limits<double>::infinity();
    constexpr int n = 20;
    for (const auto& t : triangles)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
          const double u = i / double{n};
          const double v = j / double{n};
          least = std::min(least, distance(p, (1 - u - v) * t[0] + u * t[1] + v * t[2]));
        }
    const Foot foot = tree.nearest(p);
    CHECK(foot.distance <= least + 1e-12);
    CHECK(foot.distance > least - 0.1 / n);
    CHECK(distance(foot.at, p) == Approx(foot.distance));
    CHECK(NearestTriangle({tree.corners(foot.triangle)}).nearest(foot.at).distance < 1e-12);
  }
  CHECK(NearestTriangle({}).nearest({}).triangle == -1);
}
