// SPDX-License-Identifier: GPL-2.0-or-later
#include "places.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace tetrarch::diagram {
namespace {

/// The triangulated disk of one part. Points: nodes, two for each arc (the one of dart d lies at d's end),
/// for each region but the outer one a middle; and where the boundary of a region passes a node twice, a ring
/// inside it, three points for each dart (at its node, at its own point, at the point of the other half), so
/// that no two triangles have all corners in common.
class Disk {
public:
  Disk(const Diagram& diagram, const Classes& region, const std::vector<int>& darts) : diagram_(diagram) {
    node_.assign(static_cast<std::size_t>(diagram.node_count()), -1);
    point_.assign(static_cast<std::size_t>(diagram.dart_count()), -1);
    ring_.assign(static_cast<std::size_t>(diagram.dart_count()), -1);
    for (const int d : darts) {
      int& n = node_[diagram.node_of(d)];
      if (n < 0) n = count_++;
    }
    for (const int d : darts) point_[d] = count_++;
    const std::vector<bool> simple = simple_regions(region, darts);
    for (const int d : darts)
      if (!simple[region.of[d]]) {
        ring_[d] = count_;
        count_ += 3;
      }
    const int outer = largest(region, darts);
    std::vector<int> middle(static_cast<std::size_t>(region.count), -1);
    for (const int d : darts)
      if (int& m = middle[region.of[d]]; m < 0 && region.of[d] != outer) m = count_++;
    next_.resize(static_cast<std::size_t>(count_));
    boundary_.assign(static_cast<std::size_t>(count_), false);
    for (const int d : darts) add_strip(d, middle[region.of[d]]);
    for (int v = 0; v < count_; ++v) flowers_.push_back(flower(v));
  }

  int node(int n) const { return node_[n]; }
  int point(int d) const { return point_[d]; }
  const std::vector<std::vector<int>>& flowers() const { return flowers_; }
  const std::vector<bool>& boundary() const { return boundary_; }

private:
  /// The region with most corners.
  static int largest(const Classes& region, const std::vector<int>& darts) {
    std::vector<int> size(static_cast<std::size_t>(region.count), 0);
    for (const int d : darts) ++size[region.of[d]];
    return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  }

  /// Of each region, whether its boundary passes no node twice.
  std::vector<bool> simple_regions(const Classes& region, const std::vector<int>& darts) const {
    std::vector<bool> simple(static_cast<std::size_t>(region.count), true);
    std::vector<std::pair<int, int>> corners;
    corners.reserve(darts.size());
    for (const int d : darts) corners.emplace_back(region.of[d], diagram_.node_of(d));
    std::sort(corners.begin(), corners.end());
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
      if (corners[k] == corners[k + 1]) simple[corners[k].first] = false;
    return simple;
  }

  /// Counterclockwise.
  void add_triangle(int a, int b, int c) {
    next_[a].emplace_back(b, c);
    next_[b].emplace_back(c, a);
    next_[c].emplace_back(a, b);
  }

  /// The way along dart d from its node to the next, the ring to its left, and the middle of the region; -1:
  /// it is the outer one.
  void add_strip(int d, int middle) {
    const int after = diagram_.next_on_left(d);
    const std::array<int, 4> way{node_[diagram_.node_of(d)], point_[d], point_[diagram_.opposite(d)],
                                 node_[diagram_.node_of(after)]};
    const bool has_ring = ring_[d] >= 0;
    const std::array<int, 4> ring =
        has_ring ? std::array<int, 4>{ring_[d], ring_[d] + 1, ring_[d] + 2, ring_[after]} : way;
    for (std::size_t k = 0; k < 3; ++k) {
      if (has_ring) {
        add_triangle(way[k], way[k + 1], ring[k + 1]);
        add_triangle(way[k], ring[k + 1], ring[k]);
      }
      if (middle >= 0)
        add_triangle(ring[k], ring[k + 1], middle);
      else
        boundary_[ring[k]] = true;
    }
  }

  std::vector<int> flower(int v) const {
    const auto& pairs = next_[v];
    int first = pairs.front().first;
    if (boundary_[v])
      for (const auto& [a, b] : pairs)
        if (std::none_of(pairs.begin(), pairs.end(), [a = a](const auto& p) { return p.second == a; }))
          first = a;
    std::vector<int> flower{first};
    while (true) {
      const auto found =
          std::find_if(pairs.begin(), pairs.end(), [&](const auto& p) { return p.first == flower.back(); });
      if (found == pairs.end() || found->second == first) return flower;
      flower.push_back(found->second);
    }
  }

  const Diagram& diagram_;
  std::vector<int> node_;
  std::vector<int> point_;
  std::vector<int> ring_; ///< of each dart the first of three; -1: the region has none
  std::vector<std::vector<std::pair<int, int>>> next_; ///< of each vertex, the other two of its triangles
  std::vector<std::vector<int>> flowers_;
  std::vector<bool> boundary_;
  int count_ = 0;
};

/// Shifts a part to the right of what there is.
void set_beside(const std::vector<PackedCircle*>& circles, double& right) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double bottom = low;
  double top = -low;
  for (const PackedCircle* c : circles) {
    low = std::min(low, c->center[0] - c->radius);
    high = std::max(high, c->center[0] + c->radius);
    bottom = std::min(bottom, c->center[1] - c->radius);
    top = std::max(top, c->center[1] + c->radius);
  }
  // All parts are as high as one another.
  const double scale = 1 / std::max(top - bottom, 1e-300);
  for (PackedCircle* c : circles) {
    c->center = {right + scale * (c->center[0] - low), scale * (c->center[1] - (top + bottom) / 2)};
    c->radius *= scale;
  }
  constexpr double margin = 0.1;
  right += scale * (high - low) + margin;
}

} // namespace

Places places_of(const Diagram& diagram, const Progress& progress) {
  const Classes part = parts(diagram);
  const Classes region = regions(diagram);
  std::vector<std::vector<int>> darts(static_cast<std::size_t>(part.count));
  for (int d = 0; d < diagram.dart_count(); ++d) darts[part.of[d]].push_back(d);
  Places places{std::vector<PackedCircle>(static_cast<std::size_t>(diagram.node_count())),
                std::vector<PackedCircle>(static_cast<std::size_t>(diagram.dart_count()))};
  double right = 0;
  for (const auto& list : darts) {
    const Disk disk(diagram, region, list);
    const std::vector<PackedCircle> circles = packed(disk.flowers(), disk.boundary(), progress);
    std::vector<PackedCircle*> drawn;
    for (const int d : list) {
      const int n = diagram.node_of(d);
      if (diagram.place_of(d) == 0) {
        places.node[n] = circles[disk.node(n)];
        drawn.push_back(&places.node[n]);
      }
      places.point[d] = circles[disk.point(d)];
      drawn.push_back(&places.point[d]);
    }
    set_beside(drawn, right);
  }
  return places;
}

} // namespace tetrarch::diagram
