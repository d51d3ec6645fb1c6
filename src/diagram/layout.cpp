// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/layout.hpp"

#include "places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetrarch::diagram {
namespace {

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
