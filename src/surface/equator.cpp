// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/equator.hpp"

#include "lay_path.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/canonical_loops.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace tetrarch::surface {
namespace {

/// A rim is worth taking for its shortness if its lesser disk has this part of the best one's triangles.
constexpr double nearly_even = 0.9;

/// A disk of triangles that grows.
class Growth {
public:
  Growth(const Surface& surface, int seed, const std::vector<double>& distance)
      : surface_(surface), distance_(distance),
        inside_(static_cast<std::size_t>(surface.triangle_count()), 0),
        on_rim_(static_cast<std::size_t>(surface.vertex_count()), 0) {
    take(seed);
    for (const int v : surface.corners(seed)) on_rim_[v] = 1;
    rim_ = 3;
  }
  int rim() const { return rim_; }
  const std::vector<int>& triangles() const { return order_; }
  /// Takes one more triangle, unless that is the last or none keeps the rim simple; then false.
  bool grow() {
    while (!queue_.empty() && size() + 1 < surface_.triangle_count()) {
      const int t = std::get<2>(queue_.top());
      const int rank = std::get<0>(queue_.top());
      queue_.pop();
      if (inside_[t] || rank != rank_of(t)) continue;
      const std::array<int, 3> corners = surface_.corners(t);
      if (rank == two_sides) {
        on_rim_[corners[free_corner(t)]] = 0;
        --rim_;
      } else {
        on_rim_[corners[free_corner(t)]] = 1;
        ++rim_;
      }
      take(t);
      return true;
    }
    return false;
  }

private:
  static constexpr int two_sides = 0;
  static constexpr int one_side = 1;
  static constexpr int none = 2;

  int size() const { return static_cast<int>(order_.size()); }
  bool is_rim(Side s) const { return inside_[surface_.mate(s).triangle()] != 0; }
  /// Opposite the only side on the rim, or between the two.
  int free_corner(int t) const {
    int only_rim = 0;
    int only_free = 0;
    int count = 0;
    for (const Side s : sides_of(t)) {
      (is_rim(s) ? only_rim : only_free) = s.corner();
      count += is_rim(s) ? 1 : 0;
    }
    return count == 1 ? only_rim : only_free;
  }
  int rank_of(int t) const {
    const auto& [a, b, c] = surface_.corners(t);
    if (a == b || b == c || c == a) return none;
    int count = 0;
    for (const Side s : sides_of(t)) count += is_rim(s) ? 1 : 0;
    if (count == 2) return two_sides;
    return count == 1 && !on_rim_[surface_.corners(t)[free_corner(t)]] ? one_side : none;
  }
  void take(int t) {
    inside_[t] = 1;
    order_.push_back(t);
    for (const Side s : sides_of(t)) {
      const int next = surface_.mate(s).triangle();
      if (inside_[next]) continue;
      const int rank = rank_of(next);
      if (rank != none) queue_.emplace(rank, distance_[surface_.corners(next)[free_corner(next)]], next);
    }
  }

  const Surface& surface_;
  const std::vector<double>& distance_;
  std::vector<char> inside_;
  std::vector<char> on_rim_;
  std::vector<int> order_;
  int rim_ = 0;
  using Entry = std::tuple<int, double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// All rims of one growth: the triangles in the order of their taking, and the rim of the first k+1 at [k].
struct Rims {
  std::vector<int> triangles;
  std::vector<int> rim;
};

Rims grow_from(const Surface& surface, int seed, const std::vector<double>& distance) {
  Growth growth(surface, seed, distance);
  Rims rims;
  do rims.rim.push_back(growth.rim());
  while (growth.grow());
  rims.triangles = growth.triangles();
  return rims;
}

/// Growths from triangles far from each other, whose corners differ.
std::vector<Rims> grow_all(const MarkedSurface& sphere, int seeds, const Progress& progress) {
  const Surface& surface = sphere.surface;
  std::vector<SideEnd> end_of(static_cast<std::size_t>(surface.vertex_count()));
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    const auto& [a, b, c] = surface.corners(s.triangle());
    if (a != b && b != c && c != a) end_of[surface.from(s)] = {s, true};
  }
  std::vector<double> from_all(end_of.size(), 0);
  const auto usable = std::find_if(end_of.begin(), end_of.end(), [](SideEnd e) { return e.side.exists(); });
  if (usable == end_of.end()) throw PreconditionError("no triangle of the sphere has three vertices");
  // The first vertex only says what is far away.
  from_all = path_lengths(sphere, surface, {*usable});
  std::vector<Rims> all;
  for (int k = 0; k < seeds; ++k) {
    progress.step("finding an equator", static_cast<double>(k) / seeds);
    int root = -1;
    for (int v = 0; v < surface.vertex_count(); ++v)
      if (end_of[v].side.exists() && (root < 0 || from_all[v] > from_all[root])) root = v;
    if (k > 0 && from_all[root] == 0) break;
    const std::vector<double> distance = path_lengths(sphere, surface, {end_of[root]});
    all.push_back(grow_from(surface, end_of[root].side.triangle(), distance));
    if (k == 0) from_all = distance;
    for (std::size_t v = 0; v < distance.size(); ++v) from_all[v] = std::min(from_all[v], distance[v]);
  }
  return all;
}

/// The triangles on one side of the best rim.
std::vector<int> choose(const std::vector<Rims>& all, int triangles, int edges) {
  const auto evenness = [&](std::size_t k) {
    const int taken = static_cast<int>(k) + 1;
    return std::min(taken, triangles - taken);
  };
  const auto each = [&](auto job) {
    for (const Rims& rims : all)
      for (std::size_t k = 0; k < rims.rim.size(); ++k) job(rims, k);
  };
  int shortest = std::numeric_limits<int>::max();
  int most_even = 0;
  each([&](const Rims& rims, std::size_t k) { shortest = std::min(shortest, rims.rim[k]); });
  const int limit = std::max(edges, shortest);
  each([&](const Rims& rims, std::size_t k) {
    if (rims.rim[k] <= limit) most_even = std::max(most_even, evenness(k));
  });
  std::vector<int> best;
  std::pair<int, int> score{limit + 1, 0};
  each([&](const Rims& rims, std::size_t k) {
    if (evenness(k) < nearly_even * most_even || std::pair{rims.rim[k], -evenness(k)} >= score) return;
    score = {rims.rim[k], -evenness(k)};
    best.assign(rims.triangles.begin(), rims.triangles.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  });
  return best;
}

void mark_rim(MarkedSurface& sphere, const std::vector<int>& disk) {
  std::vector<char> inside(static_cast<std::size_t>(sphere.surface.triangle_count()), 0);
  for (const int t : disk) inside[t] = 1;
  for (int k = 0; k < sphere.surface.side_count(); ++k) {
    const Side s(k);
    if (inside[s.triangle()] == inside[0] && inside[sphere.surface.mate(s).triangle()] != inside[0])
      set_mark(sphere, s, 1);
  }
}

/// Splits a triangle of each disk that has no interior vertex, and counts the triangles.
void give_interior_vertices(MarkedSurface& sphere, Equator& equator) {
  const Parts disks = parts(cut_open(sphere));
  for (const int disk : {0, 1}) {
    const auto first = std::find(disks.of.begin(), disks.of.end(), disk);
    auto& triangles = equator.triangles[static_cast<std::size_t>(disk)];
    triangles = static_cast<int>(std::count(first, disks.of.end(), disk));
    // A disk has edges - 2 triangles and two more for each interior vertex.
    if (triangles > equator.edges - 2) continue;
    split_face(sphere, static_cast<int>(first - disks.of.begin()));
    ++equator.face_splits;
    triangles += 2;
  }
}

} // namespace

Equator mark_equator(MarkedSurface& sphere, int edges, int seeds, const Progress& progress) {
  if (!type_of(sphere.surface).is_sphere()) throw PreconditionError("an equator needs a sphere");
  if (std::any_of(sphere.mark.begin(), sphere.mark.end(), [](int m) { return m != 0; }))
    throw PreconditionError("the surface is marked already");
  if (seeds < 1) throw PreconditionError("an equator needs a seed to grow from");
  mark_rim(sphere, choose(grow_all(sphere, seeds, progress), sphere.surface.triangle_count(), edges));
  Equator equator;
  equator.edge_splits = lengthen(sphere, 1, edges);
  equator.edges = length_of(sphere, 1);
  give_interior_vertices(sphere, equator);
  return equator;
}

} // namespace tetrarch::surface
