// SPDX-License-Identifier: GPL-2.0-or-later
#include "branches.hpp"

#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::product {
namespace {

/// How much nearer the other tree may be than the own one.
constexpr double nearer = 2;

struct Road {
  int to = 0;
  double length = 0;
};
using Roads = std::vector<std::vector<Road>>;

Roads roads(const surface::TriangleMesh& mesh) {
  Roads result(static_cast<std::size_t>(mesh.surface.vertex_count()));
  for (int k = 0; k < mesh.surface.side_count(); ++k) {
    const surface::Side s(k);
    const int a = mesh.surface.from(s);
    const int b = mesh.surface.to(s);
    const double length = numeric::distance(mesh.points[a], mesh.points[b]);
    result[a].push_back({b, length});
    if (mesh.surface.is_boundary(s)) result[b].push_back({a, length}); // else the mate's
  }
  return result;
}

/// Shortest ways from some vertices to all others; the last step is the vertex before, -1: none.
using Ways = numeric::ShortestPaths<int>;

/// `cost(a, road)`: numeric::infinity where one cannot go.
template <class Cost>
Ways ways(const Roads& roads, const std::vector<int>& from, const Cost& cost) {
  const auto steps = [&](int v, const auto& visit) {
    for (const Road& road : roads[v]) visit(road.to, cost(v, road), v);
  };
  return numeric::shortest_paths(roads.size(), from, -1, steps);
}

std::vector<double> distances(const Roads& roads, const std::vector<int>& from) {
  return ways(roads, from, [](int, const Road& road) { return road.length; }).distance;
}

double nearest_of(const std::vector<double>& distance, const std::vector<int>& vertices) {
  double least = numeric::infinity;
  for (const int v : vertices) least = std::min(least, distance[v]);
  return least;
}

class Growth {
public:
  Growth(const Roads& roads, const std::array<std::vector<int>, 2>& first)
      : roads_(roads), found_{first, first}, distance_{distances(roads, first[0]),
                                                       distances(roads, first[1])} {}

  /// Both banks of a loop, each to one tree, clear of the banks that come later.
  bool join(std::array<std::vector<int>, 2> banks, const std::vector<int>& later) {
    if (nearest_of(distance_[0], banks[0]) + nearest_of(distance_[1], banks[1]) >
        nearest_of(distance_[0], banks[1]) + nearest_of(distance_[1], banks[0]))
      banks[0].swap(banks[1]);
    for (const int k : {0, 1}) {
      std::vector<int> others = found_.trees[1 - k];
      others.insert(others.end(), later.begin(), later.end());
      if (k == 0) others.insert(others.end(), banks[1].begin(), banks[1].end());
      if (!grow(k, banks[k], distances(roads_, others))) return false;
      found_.banks[k].insert(found_.banks[k].end(), banks[k].begin(), banks[k].end());
    }
    return true;
  }

  /// To the vertex that needs it most; false if there is none left.
  bool branch() {
    if (lost_[0].empty()) lost_.fill(std::vector<char>(roads_.size(), 0));
    while (true) {
      double farthest = 0;
      int tip = -1;
      int grows = 0;
      for (const int k : {0, 1})
        for (int v = 0; v < static_cast<int>(roads_.size()); ++v) {
          const double d = std::min(distance_[k][v], nearer * distance_[1 - k][v]);
          if (d <= farthest || lost_[k][v] != 0) continue;
          farthest = d;
          tip = v;
          grows = k;
        }
      if (tip < 0) return false;
      if (grow(grows, {tip}, distance_[1 - grows])) return true;
      lost_[grows][tip] = 1; // walled in by the other tree
    }
  }

  OppositeTrees take() { return std::move(found_); }

private:
  /// Tree k by these vertices and a way to the nearest of them.
  bool grow(int k, const std::vector<int>& to, const std::vector<double>& from_others) {
    std::vector<int>& tree = found_.trees[k];
    const Ways found = ways(roads_, tree, [&](int v, const Road& road) {
      const double there = from_others[road.to];
      return there > 0 ? 2 * road.length / (from_others[v] + there) : numeric::infinity;
    });
    const int end = *std::min_element(
        to.begin(), to.end(), [&found](int a, int b) { return found.distance[a] < found.distance[b]; });
    if (found.distance[end] == numeric::infinity) return false;
    for (int v = found.last[end]; v >= 0 && found.last[v] >= 0; v = found.last[v]) tree.push_back(v);
    tree.insert(tree.end(), to.begin(), to.end());
    distance_[k] = distances(roads_, tree);
    return true;
  }

  const Roads& roads_;
  OppositeTrees found_;
  std::array<std::vector<double>, 2> distance_; ///< of each vertex from the trees
  std::array<std::vector<char>, 2> lost_;       ///< what a tree cannot reach any more
};

} // namespace

std::optional<OppositeTrees> opposite_trees(const surface::TriangleMesh& surface,
                                            const std::vector<std::array<std::vector<int>, 2>>& banks,
                                            int branches) {
  const Roads all = roads(surface);
  Growth growth(all, banks.front());
  for (std::size_t k = 1; k < banks.size(); ++k) {
    std::vector<int> later;
    for (std::size_t j = k + 1; j < banks.size(); ++j)
      for (const auto& bank : banks[j]) later.insert(later.end(), bank.begin(), bank.end());
    if (!growth.join(banks[k], later)) return {};
  }
  for (int made = 0; made < branches && growth.branch(); ++made) {
  }
  return growth.take();
}

std::vector<double> distances(const surface::TriangleMesh& mesh, const std::vector<int>& from) {
  return distances(roads(mesh), from);
}

} // namespace tetrarch::product
