// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/gaps.hpp"

#include "tetrarch/numeric/vector.hpp"
#include "walk.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <map>

namespace tetrarch::polycube {
namespace {

using namespace numeric;
using surface::Side;

/// Gaps between two planes, all of them together.
class GapSet {
public:
  explicit GapSet(const Image& image) : image_(image) {}
  /// `low` and `high` are planes.
  void add(int low, int high, double weight) {
    const double width = image_.of_planes[high] - image_.of_planes[low];
    if (low != high && width > 0) weight_[{low, high}] += weight;
  }
  std::vector<Gap> all() const {
    double total = 0;
    for (const auto& [ends, weight] : weight_) total += weight;
    std::vector<Gap> result;
    for (const auto& [ends, weight] : weight_)
      result.push_back({ends[0], ends[1], image_.of_planes[ends[1]] - image_.of_planes[ends[0]],
                        weight / total * static_cast<double>(weight_.size())});
    return result;
  }

private:
  const Image& image_;
  std::map<std::array<int, 2>, double> weight_;
};

/// What gaps are found in.
struct Parts {
  const LabeledSolid& labeled;
  const Charts& charts;
  const Planes& planes;
  const Image& image;
};

/// From the end of a line to the other.
void add_lines(const Parts& parts, GapSet& gaps) {
  const product::Solid& solid = parts.labeled.solid;
  for (const Line& line : parts.charts.lines) {
    if (line.is_closed || are_opposite(parts.charts.label[line.left], parts.charts.label[line.right]))
      continue;
    const std::size_t axis = parts.charts.axis(line);
    int low = parts.planes.holds[solid.vertex[line.vertices.front()]][axis];
    int high = parts.planes.holds[solid.vertex[line.vertices.back()]][axis];
    if (low < 0 || high < 0) continue; // a faulty corner
    double length = 0;
    for (std::size_t k = 1; k < line.vertices.size(); ++k)
      length += distance(solid.point(solid.vertex[line.vertices[k]]),
                         solid.point(solid.vertex[line.vertices[k - 1]]));
    constexpr double of_square = 0.1;
    gaps.add(low, high, of_square * length * length);
    gaps.add(high, low, of_square * length * length);
  }
}

/// From each triangle straight through the solid.
void add_walls(const Parts& parts, const Facets& facets, GapSet& gaps, const Progress& progress) {
  const product::Solid& solid = parts.labeled.solid;
  const ImageWalk walk(solid, parts.image.points);
  const double far = 2 * extent(parts.image.points);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (t % 256 == 0) progress.step("walls");
    const int tet = solid.face[t].tet;
    Point middle{};
    for (const int v : solid.corners(tet)) middle = middle + 0.25 * parts.image.points[v];
    const Label label = parts.labeled.label[t];
    const WalkEnd end = walk.walk(tet, middle, middle - far * direction_of(label));
    if (end.is_lost || end.triangle < 0 || !are_opposite(label, parts.labeled.label[end.triangle])) continue;
    const int here = parts.planes.of_chart[parts.charts.of[t]];
    const int there = parts.planes.of_chart[parts.charts.of[end.triangle]];
    sign_of(label) > 0 ? gaps.add(there, here, facets.area[t]) : gaps.add(here, there, facets.area[t]);
  }
}

/// Where a straight way along an axis, across the image of a chart, leaves the chart: a side, or none.
Side left_through(const Parts& parts, int triangle, const Point& from, std::size_t axis, double forward) {
  const product::Solid& solid = parts.labeled.solid;
  const surface::Surface& surface = solid.boundary;
  const std::size_t other = 3 - axis - axis_of(parts.charts.label[parts.charts.of[triangle]]);
  const auto at = [&](int v) -> const Point& { return parts.image.points[solid.vertex[v]]; };
  Side entry;
  for (int steps = 0; steps <= surface.triangle_count(); ++steps) {
    Side exit;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Side s : surface::sides_of(triangle)) {
      const Point& p = at(surface.from(s));
      const Point& q = at(surface.to(s));
      // The way crosses the side between its ends, and the last that is crossed is the exit.
      if (s == entry || (p[other] < from[other]) == (q[other] < from[other])) continue;
      const double part = (from[other] - p[other]) / (q[other] - p[other]);
      const double x = forward * (p[axis] + part * (q[axis] - p[axis]));
      if (x <= farthest) continue;
      farthest = x;
      exit = s;
    }
    if (!exit.exists()) return {};
    const Side beyond = surface.mate(exit);
    if (parts.charts.of[beyond.triangle()] != parts.charts.of[triangle]) return exit;
    triangle = beyond.triangle();
    entry = beyond;
  }
  return {};
}

/// From each side between charts straight across the chart.
void add_steps(const Parts& parts, const Facets& facets, GapSet& gaps, const Progress& progress) {
  const product::Solid& solid = parts.labeled.solid;
  const surface::Surface& surface = solid.boundary;
  const auto plane_beyond = [&](Side s) {
    return parts.planes.of_chart[parts.charts.of[surface.mate(s).triangle()]];
  };
  for (int t = 0; t < surface.triangle_count(); ++t) {
    if (t % 256 == 0) progress.step("walls");
    const int chart = parts.charts.of[t];
    for (const Side s : surface::sides_of(t)) {
      if (parts.charts.of[surface.mate(s).triangle()] == chart) continue;
      const int start = plane_beyond(s);
      const std::size_t axis = parts.planes.axis[start];
      if (axis == axis_of(parts.charts.label[chart])) continue; // opposite labels
      Point middle{};
      for (int c = 0; c < 3; ++c) middle = middle + 1.0 / 3 * parts.image.points[solid.corner(t, c)];
      const double forward = middle[axis] > parts.image.of_planes[start] ? 1 : -1;
      const Side exit = left_through(parts, t, middle, axis, forward);
      if (!exit.exists() || parts.planes.axis[plane_beyond(exit)] != axis) continue;
      const int end = plane_beyond(exit);
      forward > 0 ? gaps.add(start, end, facets.area[t]) : gaps.add(end, start, facets.area[t]);
    }
  }
}

} // namespace

std::vector<Gap> gaps(const LabeledSolid& labeled, const Charts& charts, const Planes& planes,
                      const Image& image, const Progress& progress) {
  const Parts parts{labeled, charts, planes, image};
  const Facets facets(labeled.solid);
  GapSet result(image);
  add_lines(parts, result);
  add_walls(parts, facets, result, progress);
  add_steps(parts, facets, result, progress);
  return result.all();
}

} // namespace tetrarch::polycube
