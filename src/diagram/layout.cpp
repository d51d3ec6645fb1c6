// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/layout.hpp"

#include "packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Circles of nodes and of the points of darts.
struct Places {
  std::vector<PackedCircle> node;
  std::vector<PackedCircle> point;
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

/// A point of a smooth curve between p1 and p2, whose direction at each is that between its neighbors.
/// Source: Barry and Goldman, "A recursive evaluation algorithm for a class of Catmull-Rom splines" (1988);
/// parameters grow as the root of the distance (centripetal), so that no loops appear.
PlanePoint spline(const std::array<PlanePoint, 4>& p, double s) {
  std::array<double, 4> t{};
  for (std::size_t k = 1; k < 4; ++k)
    t[k] = t[k - 1] + std::sqrt(std::max(1e-12, std::hypot(p[k][0] - p[k - 1][0], p[k][1] - p[k - 1][1])));
  const double at = t[1] + s * (t[2] - t[1]);
  const auto mix = [at](const PlanePoint& a, const PlanePoint& b, double ta, double tb) {
    const double w = (at - ta) / (tb - ta);
    return PlanePoint{(1 - w) * a[0] + w * b[0], (1 - w) * a[1] + w * b[1]};
  };
  const PlanePoint a1 = mix(p[0], p[1], t[0], t[1]);
  const PlanePoint a2 = mix(p[1], p[2], t[1], t[2]);
  const PlanePoint a3 = mix(p[2], p[3], t[2], t[3]);
  return mix(mix(a1, a2, t[0], t[2]), mix(a2, a3, t[1], t[3]), t[1], t[2]);
}

/// The way of an edge of the graph through the picture.
struct Route {
  std::vector<PlanePoint> points;
  std::vector<double> gap; ///< 0, or where it passes below how far round it is not drawn
  bool closed = false;
};

class Drawing {
public:
  Drawing(const Diagram& diagram, const Places& places)
      : diagram_(diagram), places_(places), edge_(edges(diagram)),
        done_(static_cast<std::size_t>(diagram.dart_count()), false) {}

  Layout run() {
    // From ends first; what is left are circles.
    for (const bool ends : {true, false})
      for (int d = 0; d < diagram_.dart_count(); ++d)
        if (!done_[d] && (!ends || is_end(d))) draw(route(d), edge_.of[d]);
    out_.vertex_radius = std::numeric_limits<double>::infinity();
    for (int n = 0; n < diagram_.node_count(); ++n) {
      const Node& node = diagram_.node(n);
      if (node.crossing || node.darts.size() == 2) continue;
      out_.vertices.push_back(places_.node[n].center);
      out_.vertex_radius = std::min(out_.vertex_radius, places_.node[n].radius);
    }
    frame();
    return std::move(out_);
  }

private:
  bool is_end(int d) const {
    return !diagram_.at_crossing(d) && diagram_.node(diagram_.node_of(d)).darts.size() != 2;
  }

  void add_node(Route& route, int dart) {
    const PackedCircle& c = places_.node[diagram_.node_of(dart)];
    // Parts are 1 high; a gap is some line widths, but leaves something of the strand.
    constexpr double part_of_circle = 0.6;
    constexpr double widest = 0.022;
    const bool below = diagram_.at_crossing(dart) && !diagram_.is_over(dart);
    route.points.push_back(c.center);
    route.gap.push_back(below ? std::min(widest, part_of_circle * c.radius) : 0);
  }

  Route route(int dart) {
    Route route;
    add_node(route, dart);
    int d = dart;
    while (true) {
      const int e = diagram_.opposite(d);
      done_[d] = done_[e] = true;
      for (const int half : {d, e}) {
        route.points.push_back(places_.point[half].center);
        route.gap.push_back(0);
      }
      const int next = is_end(e) ? -1 : diagram_.turned(e, diagram_.at_crossing(e) ? 2 : 1);
      if (next == dart) {
        route.closed = true;
        return route;
      }
      add_node(route, e);
      if (next < 0) return route;
      d = next;
    }
  }

  /// Samples the curve, and ends a stroke where it dives.
  void draw(const Route& route, int edge) {
    const int count = static_cast<int>(route.points.size());
    const auto at = [&](int k) {
      if (route.closed) return route.points[static_cast<std::size_t>((k % count + count) % count)];
      if (k >= 0 && k < count) return route.points[static_cast<std::size_t>(k)];
      // Beyond an end the curve goes on straight.
      const PlanePoint& end = route.points[k < 0 ? 0 : static_cast<std::size_t>(count - 1)];
      const PlanePoint& before = route.points[k < 0 ? 1 : static_cast<std::size_t>(count - 2)];
      return PlanePoint{2 * end[0] - before[0], 2 * end[1] - before[1]};
    };
    std::vector<Stroke> strokes(1);
    bool cut = false;
    const auto add = [&](const PlanePoint& p, int near) {
      for (const int k : {near, near + 1}) {
        const std::size_t index = static_cast<std::size_t>(k % count);
        if (std::hypot(p[0] - route.points[index][0], p[1] - route.points[index][1]) < route.gap[index]) {
          cut = true;
          if (!strokes.back().points.empty()) strokes.emplace_back();
          return;
        }
      }
      strokes.back().points.push_back(p);
    };
    constexpr int samples = 24;
    const int segments = route.closed ? count : count - 1;
    for (int k = 0; k < segments; ++k)
      for (int s = 0; s < samples; ++s)
        add(spline({at(k - 1), at(k), at(k + 1), at(k + 2)}, double(s) / samples), k);
    if (!route.closed) add(at(count - 1), count - 2);
    finish(std::move(strokes), route, cut, edge);
  }

  /// The last stroke of a closed edge runs on into the first, unless there is a gap at the start.
  void finish(std::vector<Stroke> strokes, const Route& route, bool cut, int edge) {
    strokes.front().closed = route.closed && !cut;
    if (route.closed && cut && route.gap.front() == 0 && strokes.size() > 1) {
      auto& last = strokes.back().points;
      const auto& first = strokes.front().points;
      last.insert(last.end(), first.begin(), first.end());
      std::swap(strokes.front(), strokes.back());
      strokes.pop_back();
    }
    for (Stroke& stroke : strokes) {
      stroke.edge = edge;
      if (stroke.points.size() > 1) out_.strokes.push_back(std::move(stroke));
    }
  }

  void frame() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    out_.lower = {infinity, infinity};
    out_.upper = {-infinity, -infinity};
    for (const Stroke& stroke : out_.strokes)
      for (const PlanePoint& p : stroke.points)
        for (std::size_t i = 0; i < 2; ++i) {
          out_.lower[i] = std::min(out_.lower[i], p[i]);
          out_.upper[i] = std::max(out_.upper[i], p[i]);
        }
    constexpr double margin = 0.04;
    for (std::size_t i = 0; i < 2; ++i) {
      out_.lower[i] -= margin;
      out_.upper[i] += margin;
    }
  }

  const Diagram& diagram_;
  const Places& places_;
  Classes edge_;
  std::vector<bool> done_;
  Layout out_;
};

} // namespace

Layout layout(const Diagram& diagram, const Progress& progress) {
  const Places places = places_of(diagram, progress);
  return Drawing(diagram, places).run();
}

} // namespace tetrarch::diagram
