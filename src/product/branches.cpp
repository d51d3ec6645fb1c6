// SPDX-License-Identifier: GPL-2.0-or-later
#include "branches.hpp"

#include "tetrarch/mesh/distance.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tetrarch::product {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// How much nearer the other tree may be than the own one.
constexpr double nearer = 2;

struct Road {
  int to = 0;
  double length = 0;
};
using Roads = std::vector<std::vector<Road>>;

Roads roads(const mesh::TriangleMesh& mesh) {
  Roads result(static_cast<std::size_t>(mesh.surface.vertex_count()));
  for (int k = 0; k < mesh.surface.side_count(); ++k) {
    const mesh::Side s(k);
    const int a = mesh.surface.from(s);
    const int b = mesh.surface.to(s);
    const double length = mesh::distance(mesh.points[a], mesh.points[b]);
    result[a].push_back({b, length});
    if (mesh.surface.is_boundary(s)) result[b].push_back({a, length}); // else the mate's
  }
  return result;
}

/// Shortest ways from some vertices to all others.
struct Ways {
  std::vector<double> distance;
  std::vector<int> before; ///< the vertex before each one on its way; -1: none
};

/// `cost(a, road)`: infinite where one cannot go.
template <class Cost>
Ways ways(const Roads& roads, const std::vector<int>& from, const Cost& cost) {
  Ways found{std::vector<double>(roads.size(), infinite), std::vector<int>(roads.size(), -1)};
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
  for (const int v : from) {
    found.distance[v] = 0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > found.distance[v]) continue;
    for (const Road& road : roads[v]) {
      const double next = d + cost(v, road);
      if (!(next < found.distance[road.to])) continue;
      found.distance[road.to] = next;
      found.before[road.to] = v;
      queue.emplace(next, road.to);
    }
  }
  return found;
}

std::vector<double> distances(const Roads& roads, const std::vector<int>& from) {
  return ways(roads, from, [](int, const Road& road) { return road.length; }).distance;
}

} // namespace

std::array<std::vector<int>, 2> opposite_trees(const mesh::TriangleMesh& ring,
                                               const std::array<std::vector<int>, 2>& banks, int branches) {
  const Roads all = roads(ring);
  std::array<std::vector<int>, 2> trees = banks;
  std::array<std::vector<double>, 2> distance{distances(all, banks[0]), distances(all, banks[1])};
  std::array<std::vector<char>, 2> lost;
  lost.fill(std::vector<char>(all.size(), 0));
  for (int made = 0; made < branches;) {
    double farthest = 0;
    int tip = -1;
    int grows = 0;
    for (const int k : {0, 1})
      for (int v = 0; v < static_cast<int>(all.size()); ++v) {
        const double d = std::min(distance[k][v], nearer * distance[1 - k][v]);
        if (d <= farthest || lost[k][v] != 0) continue;
        farthest = d;
        tip = v;
        grows = k;
      }
    if (tip < 0) break;
    const std::vector<double>& other = distance[1 - grows];
    const Ways found = ways(all, trees[grows], [&](int v, const Road& road) {
      return other[road.to] > 0 ? 2 * road.length / (other[v] + other[road.to]) : infinite;
    });
    if (found.distance[tip] == infinite) { // walled in by the other tree
      lost[grows][tip] = 1;
      continue;
    }
    for (int v = tip; found.before[v] >= 0; v = found.before[v]) trees[grows].push_back(v);
    distance[grows] = distances(all, trees[grows]);
    ++made;
  }
  return trees;
}

std::vector<double> distances(const mesh::TriangleMesh& mesh, const std::vector<int>& from) {
  return distances(roads(mesh), from);
}

} // namespace tetrarch::product
