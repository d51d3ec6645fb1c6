// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/match.hpp"

#include "tetrarch/hex/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using product::outward_sides;
using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The surface of a mesh of hexahedra.
struct Squares {
  std::vector<SurfaceSquare> at;
  std::vector<std::array<int, 4>> corners;
  std::vector<std::vector<int>> neighbors; ///< of each point along edges of the surface
  std::vector<std::vector<int>> around;    ///< of each point the squares
  std::map<Edge, std::vector<int>> beside; ///< of each edge the squares
  double mean_edge = 0;

  explicit Squares(const product::HexMesh& mesh)
      : at(surface_of(mesh)), neighbors(mesh.points.size()), around(mesh.points.size()) {
    for (int q = 0; q < static_cast<int>(at.size()); ++q) {
      std::array<int, 4> square{};
      for (std::size_t k = 0; k < 4; ++k)
        square[k] = mesh.hexahedra[at[q].hexahedron][outward_sides[at[q].side][k]];
      corners.push_back(square);
      for (std::size_t k = 0; k < 4; ++k) {
        around[square[k]].push_back(q);
        beside[edge_of(square[k], square[(k + 1) % 4])].push_back(q);
      }
    }
    for (const auto& [edge, squares] : beside) {
      neighbors[edge.first].push_back(edge.second);
      neighbors[edge.second].push_back(edge.first);
      mean_edge += distance(mesh.points[edge.first], mesh.points[edge.second]);
    }
    mean_edge /= std::max(1.0, static_cast<double>(beside.size()));
  }
};

double length_of(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += distance(line[k - 1], line[k]);
  return sum;
}

/// The point at a part of the length of a line.
Point along(const std::vector<Point>& line, double part) {
  double left = part * length_of(line);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double step = distance(line[k - 1], line[k]);
    if (left <= step && step > 0) return line[k - 1] + left / step * (line[k] - line[k - 1]);
    left -= step;
  }
  return line.back();
}

class Matcher {
public:
  Matcher(const product::HexMesh& mesh, const product::Solid& solid, const Targets& targets)
      : mesh_(mesh), solid_(solid), targets_(targets), squares_(mesh), normals_(surface_normals(mesh)) {
    result_.home.assign(mesh.points.size(), {});
    for (std::size_t v = 0; v < result_.home.size(); ++v)
      if (!squares_.around[v].empty()) result_.home[v].kind = Home::Kind::surface;
  }

  /// Ridges are sought in this order. The ridge that found no way is returned; -1: all did, and the patches
  /// came out; -2: there is no match in any order.
  int run(const std::vector<int>& order, const Progress& progress) {
    if (!place_corners()) return -2;
    for (const int r : order) {
      progress.step("ridges");
      if (!place_ridge(r)) return r;
    }
    if (!fill_patches()) return -2;
    find_cramped();
    find_folded();
    return -1;
  }

  Match take() { return std::move(result_); }

private:
  bool is_taken(int v) const { return result_.home[v].kind != Home::Kind::surface; }

  /// The free point of the surface nearest to a place, with at least so many edges.
  int nearest_free(const Point& p, std::size_t edges) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < static_cast<int>(mesh_.points.size()); ++v) {
      if (is_taken(v) || squares_.neighbors[v].size() < edges) continue;
      const double d = distance(mesh_.points[v], p);
      if (d < least) {
        least = d;
        best = v;
      }
    }
    return best;
  }

  /// The point for a corner with so many ridges. If none with as many edges is near, it is one with fewer:
  /// then the corner is crowded.
  int nearest_for(const Point& p, std::size_t ends) const {
    constexpr std::size_t fewest = 3;
    constexpr double too_far = 2; // in terms of edges
    const int nearest = nearest_free(p, fewest);
    if (nearest < 0) return nearest;
    const double farthest = distance(mesh_.points[nearest], p) + too_far * squares_.mean_edge;
    for (std::size_t edges = ends; edges > fewest; --edges) {
      const int v = nearest_free(p, edges);
      if (v >= 0 && distance(mesh_.points[v], p) <= farthest) return v;
    }
    return nearest;
  }

  bool place_corners() {
    std::map<int, std::size_t> ends;
    for (const Ridge& ridge : targets_.features().ridges) {
      ++ends[ridge.vertices.front()];
      ++ends[ridge.vertices.back()];
    }
    const std::vector<int>& corners = targets_.features().corners;
    for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
      const int v = nearest_for(targets_.corner(k), ends[corners[k]]);
      if (v < 0) return false;
      if (squares_.neighbors[v].size() < ends[corners[k]]) is_crowded_.insert(v);
      result_.home[v] = {Home::Kind::corner, k};
      node_of_corner_[corners[k]] = v;
      for (const int n : squares_.neighbors[v]) corner_beside_[n] = v;
    }
    return true;
  }

  bool place_ridge(int r) {
    const Ridge& ridge = targets_.features().ridges[r];
    std::vector<int> stops;
    if (!ridge.is_closed) {
      stops = {node_of_corner_.at(ridge.vertices.front()), node_of_corner_.at(ridge.vertices.back())};
    }
    // A closed ridge, or one from a corner to itself, goes round by way of places on it.
    if (ridge.is_closed || stops[0] == stops[1]) {
      const std::vector<Point> line = targets_.ridge(r);
      constexpr int parts = 4;
      std::vector<int> places;
      for (int k = ridge.is_closed ? 0 : 1; k < parts; ++k) {
        const int v = nearest_free(along(line, k / static_cast<double>(parts)), 3);
        if (v < 0) return false;
        result_.home[v] = {Home::Kind::ridge, r};
        places.push_back(v);
      }
      if (ridge.is_closed)
        places.push_back(places.front());
      else {
        places.insert(places.begin(), stops[0]);
        places.push_back(stops[1]);
      }
      stops = std::move(places);
    }
    for (std::size_t k = 0; k + 1 < stops.size(); ++k)
      if (!connect(stops[k], stops[k + 1], r)) return false;
    return true;
  }

  double cost(int a, int b, int r) const {
    const Point middle = 0.5 * (mesh_.points[a] + mesh_.points[b]);
    const double away = targets_.place({Home::Kind::ridge, r}, middle).distance / squares_.mean_edge;
    constexpr double dear = 8; // what a cell's length off the ridge costs
    return distance(mesh_.points[a], mesh_.points[b]) * (1 + dear * away * away);
  }

  /// The points of ridges within a few edges of a crowded corner: its other ridges may run along them, too.
  std::set<int> stems(int corner) const {
    constexpr int longest = 3;
    std::set<int> result;
    if (!is_crowded_.contains(corner)) return result;
    std::vector<int> ends{corner};
    for (int length = 0; length < longest; ++length) {
      std::vector<int> next;
      for (const int v : ends)
        for (const int n : squares_.neighbors[v])
          if (is_rim_.contains(edge_of(v, n)) && result_.home[n].kind == Home::Kind::ridge &&
              result.insert(n).second)
            next.push_back(n);
      ends = std::move(next);
    }
    return result;
  }

  /// The two ends of a way, and the stems along which it may leave the one and come to the other.
  struct Ends {
    int from = 0;
    int to = 0;
    std::set<int> leaving;
    std::set<int> arriving;

    bool leaves(int v) const { return v == from || leaving.contains(v); }
    bool arrives(int v) const { return v == to || arriving.contains(v); }
  };

  Ends ends_of(int from, int to) const {
    Ends ends{from, to, stems(from), stems(to)};
    // A ridge between the two would be crossed by who came to it and left it again.
    for (const int v : std::set<int>(ends.leaving))
      if (ends.arriving.erase(v) > 0) ends.leaving.erase(v);
    return ends;
  }

  /// Whether a way may take the step. A stem is left on one side only, so no ridge is crossed.
  bool may_step(const Ends& ends, int v, int n) const {
    if (is_rim_.contains(edge_of(v, n)))
      return (ends.leaves(v) && ends.leaving.contains(n)) || (ends.arriving.contains(v) && ends.arrives(n));
    if (ends.arriving.contains(v)) return false;
    return !is_taken(n) || ends.arrives(n);
  }

  bool connect(int from, int to, int r) {
    constexpr double narrow = 6; // times as dear
    const Ends ends = ends_of(from, to);
    std::map<int, double> reached{{from, 0}};
    std::map<int, int> before;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0, from);
    while (!queue.empty()) {
      const auto [so_far, v] = queue.top();
      queue.pop();
      if (v == to) break;
      if (so_far > reached[v]) continue;
      for (const int n : squares_.neighbors[v]) {
        if (!may_step(ends, v, n)) continue;
        // Where another corner's ridges may have to start there is a way for few.
        const auto beside = corner_beside_.find(n);
        const bool is_narrow =
            (beside != corner_beside_.end() && beside->second != from && beside->second != to) ||
            is_rim_.contains(edge_of(v, n));
        const double there = so_far + (is_narrow ? narrow : 1) * cost(v, n, r);
        const auto found = reached.find(n);
        if (found != reached.end() && found->second <= there) continue;
        reached[n] = there;
        before[n] = v;
        queue.emplace(there, n);
      }
    }
    if (!before.contains(to)) return false;
    for (int v = to; v != from; v = before[v]) {
      is_rim_.insert(edge_of(v, before[v]));
      if (!is_taken(v)) result_.home[v] = {Home::Kind::ridge, r};
    }
    return true;
  }

  int vote(const std::vector<int>& region) const {
    std::map<int, int> votes;
    for (const int q : region) {
      Point middle{};
      Vector normal{};
      for (const int v : squares_.corners[q]) {
        middle = middle + 0.25 * mesh_.points[v];
        normal = normal + normals_[v];
      }
      ++votes[targets_.patch_of(targets_.whole().nearest(middle, &normal).triangle)];
    }
    return std::max_element(votes.begin(), votes.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  bool fill_patches() {
    std::vector<int>& patch = result_.patch;
    patch.assign(squares_.at.size(), -1);
    std::vector<char> used(static_cast<std::size_t>(targets_.features().patches));
    int regions = 0;
    for (int q = 0; q < static_cast<int>(patch.size()); ++q) {
      if (patch[q] >= 0) continue;
      std::vector<int> region{q};
      patch[q] = 0;
      for (std::size_t k = 0; k < region.size(); ++k) {
        const auto& square = squares_.corners[region[k]];
        for (std::size_t i = 0; i < 4; ++i) {
          const Edge edge = edge_of(square[i], square[(i + 1) % 4]);
          if (is_rim_.contains(edge)) continue;
          for (const int next : squares_.beside.at(edge))
            if (patch[next] < 0) {
              patch[next] = 0;
              region.push_back(next);
            }
        }
      }
      const int p = vote(region);
      if (used[p] != 0) return false;
      used[p] = 1;
      ++regions;
      for (const int s : region) {
        patch[s] = p;
        for (const int v : squares_.corners[s])
          if (result_.home[v].kind == Home::Kind::surface) result_.home[v] = {Home::Kind::patch, p};
      }
    }
    return regions == targets_.features().patches;
  }

  /// The angle of a patch at a corner of the solid, in radians.
  std::map<int, double> angles_at(int vertex) const {
    std::map<int, double> angle;
    for (int t = 0; t < solid_.boundary.triangle_count(); ++t)
      for (int c = 0; c < 3; ++c) {
        if (solid_.corner(t, c) != vertex) continue;
        const Point& p = solid_.point(vertex);
        const Vector a = solid_.point(solid_.corner(t, (c + 1) % 3)) - p;
        const Vector b = solid_.point(solid_.corner(t, (c + 2) % 3)) - p;
        angle[targets_.patch_of(t)] += std::atan2(norm(cross(a, b)), dot(a, b));
      }
    return angle;
  }

  void find_cramped() {
    result_.is_cramped.assign(static_cast<std::size_t>(targets_.features().patches), 0);
    constexpr double widest = 150 * std::numbers::pi / 180; // of a square
    for (int v = 0; v < static_cast<int>(result_.home.size()); ++v) {
      const Home& home = result_.home[v];
      if (home.kind != Home::Kind::ridge && home.kind != Home::Kind::corner) continue;
      std::map<int, int> count;
      for (const int q : squares_.around[v]) ++count[result_.patch[q]];
      std::map<int, double> angle;
      if (home.kind == Home::Kind::corner) angle = angles_at(targets_.features().corners[home.index]);
      for (const auto& [p, n] : count) {
        const double there = home.kind == Home::Kind::ridge ? std::numbers::pi : angle[p];
        if (there / n > widest) result_.is_cramped[p] = 1;
      }
      for (const int n : squares_.neighbors[v])
        if (home.kind == Home::Kind::ridge && result_.home[n].kind == Home::Kind::ridge &&
            result_.home[n].index == home.index && !is_rim_.contains(edge_of(v, n)))
          result_.is_cramped[result_.patch[squares_.beside.at(edge_of(v, n)).front()]] = 1;
    }
  }

  void find_folded() {
    for (const auto& [edge, pair] : squares_.beside)
      if (pair.size() == 2 && squares_.at[pair[0]].hexahedron == squares_.at[pair[1]].hexahedron &&
          !is_rim_.contains(edge))
        result_.is_unfolded = false;
  }

  const product::HexMesh& mesh_;
  const product::Solid& solid_;
  const Targets& targets_;
  Squares squares_;
  std::vector<Vector> normals_;
  std::map<int, int> node_of_corner_;
  std::map<int, int> corner_beside_; ///< of a point beside a corner: the last such corner
  std::set<int> is_crowded_;         ///< points of corners with fewer edges than ridges
  std::set<Edge> is_rim_;            ///< edges of paths
  Match result_;
};

} // namespace

Match unmatched(const product::HexMesh& mesh) {
  Match result;
  result.home.assign(mesh.points.size(), {});
  for (const SurfaceSquare& s : surface_of(mesh)) {
    for (const int c : outward_sides[s.side])
      result.home[mesh.hexahedra[s.hexahedron][c]].kind = Home::Kind::surface;
    result.patch.push_back(0);
  }
  result.is_cramped = {0};
  result.is_unfolded = false;
  return result;
}

std::optional<Match> matched(const product::HexMesh& mesh, const product::Solid& solid,
                             const Targets& targets, const Progress& progress) {
  std::vector<std::pair<double, int>> by_length;
  by_length.reserve(targets.features().ridges.size());
  for (int r = 0; r < static_cast<int>(targets.features().ridges.size()); ++r)
    by_length.emplace_back(length_of(targets.ridge(r)), r);
  std::sort(by_length.begin(), by_length.end()); // short ones have the least choice
  std::vector<int> order;
  order.reserve(by_length.size());
  for (const auto& [length, r] : by_length) order.push_back(r);
  // Whoever finds no way goes first in the next attempt.
  constexpr int most_attempts = 12;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    Matcher matcher(mesh, solid, targets);
    const int failed = matcher.run(order, progress);
    if (failed == -1) return matcher.take();
    if (failed == -2 || (attempt > 0 && order.front() == failed)) break;
    order.erase(std::find(order.begin(), order.end(), failed));
    order.insert(order.begin(), failed);
  }
  return std::nullopt;
}

} // namespace tetrarch::hex
