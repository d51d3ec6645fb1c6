// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/shortest_paths.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

struct Road {
  int from = 0;
  int to = 0;
  double length = 0;
};

/// Small whole lengths, so that ways of equal length abound and sums are exact; some are 0, some infinite.
std::vector<Road> random_roads(support::Random& random, int nodes, int count) {
  std::vector<Road> roads;
  for (int k = 0; k < count; ++k) {
    const int length = random.below(7);
    roads.push_back({random.below(nodes), random.below(nodes), length == 6 ? infinity : length});
  }
  return roads;
}

auto steps_along(const std::vector<Road>& roads) {
  return [&roads](int node, const auto& visit) {
    for (int k = 0; k < static_cast<int>(roads.size()); ++k)
      if (roads[k].from == node) visit(roads[k].to, roads[k].length, k);
  };
}

/// The second route: Bellman and Ford's.
std::vector<double> relaxed(const std::vector<Road>& roads, int nodes, const std::vector<int>& roots) {
  std::vector<double> distance(static_cast<std::size_t>(nodes), infinity);
  for (const int root : roots) distance[root] = 0;
  for (int round = 0; round < nodes; ++round)
    for (const Road& r : roads) distance[r.to] = std::min(distance[r.to], distance[r.from] + r.length);
  return distance;
}

} // namespace

TEST_CASE("distances are those of relaxation, and steps lead there") {
  support::Random random(5);
  for (int k = 0; k < 300; ++k) {
    const int nodes = 2 + random.below(12);
    const std::vector<Road> roads = random_roads(random, nodes, random.below(30));
    const std::vector<int> roots{0, random.below(nodes)};
    const auto paths = shortest_paths(static_cast<std::size_t>(nodes), roots, -1, steps_along(roads));
    REQUIRE(paths.distance == relaxed(roads, nodes, roots));
    for (int v = 0; v < nodes; ++v) {
      const bool is_root = std::find(roots.begin(), roots.end(), v) != roots.end();
      REQUIRE((paths.last[v] < 0) == (is_root || paths.distance[v] == infinity));
      if (paths.last[v] < 0) continue;
      const Road& last = roads[paths.last[v]];
      REQUIRE(last.to == v);
      REQUIRE(paths.distance[last.from] + last.length == paths.distance[v]);
    }
  }
}

TEST_CASE("of two ways equally long that one stays which was found first") {
  // 0 -> 1 -> 3 and 0 -> 2 -> 3, all of length 1: node 1 leaves the queue before node 2.
  const std::vector<Road> roads{{0, 2, 1}, {0, 1, 1}, {2, 3, 1}, {1, 3, 1}};
  CHECK(shortest_paths(4, {0}, -1, steps_along(roads)).last == std::vector<int>{-1, 1, 0, 3});
}
