// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Shortest paths from some nodes of a graph to all others: Dijkstra's algorithm.
///
///      root ---2--- b          A step leads from one node to another and has a length, which is not
///      negative.
///        \          |          Whoever asks says which steps leave a node, so that no graph need be built:
///         5         1          edges of a surface, crossings between triangles, roads with prices.
///          \        |
///           `------ c          c is reached at distance 3, by the step from b.
///
/// Of two ways equally long that one stays which was found first; nodes leave the queue by distance, then by
/// number.

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace tetrarch::numeric {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Step>
struct ShortestPaths {
  std::vector<double> distance; ///< of each node from the nearest root; infinite: not reached
  std::vector<Step> last; ///< the last step of each node's way; `none` at roots and where there is no way
};

/// `steps(node, visit)` calls `visit(next, length, step)` for each step that leaves the node; a step of
/// infinite length is none. O((nodes + steps) log nodes).
template <class Step, class Steps>
ShortestPaths<Step> shortest_paths(std::size_t nodes, const std::vector<int>& roots, const Step& none,
                                   const Steps& steps) {
  ShortestPaths<Step> paths{std::vector<double>(nodes, infinity), std::vector<Step>(nodes, none)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int root : roots) {
    paths.distance[root] = 0;
    queue.emplace(0.0, root);
  }
  while (!queue.empty()) {
    const auto [distance, node] = queue.top();
    queue.pop();
    if (distance > paths.distance[node]) continue; // a shorter way was found since
    steps(node, [&, so_far = distance](int next, double length, const Step& step) {
      const double further = so_far + length;
      if (!(further < paths.distance[next])) return;
      paths.distance[next] = further;
      paths.last[next] = step;
      queue.emplace(further, next);
    });
  }
  return paths;
}

} // namespace tetrarch::numeric
