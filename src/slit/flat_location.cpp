// SPDX-License-Identifier: GPL-2.0-or-later
#include "flat_location.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace tetrarch::slit {
namespace {

namespace geometry = boost::geometry;
using Complex = std::complex<double>;
using Corners = std::array<Complex, 3>;

double cross(Complex a, Complex b) {
  return (std::conj(a) * b).imag();
}

/// A point as seen from a triangle.
struct View {
  double distance = 0; ///< negative inside: how deep
  std::array<double, 3> weight{};
};

View view_inside(const Corners& p, const std::array<double, 3>& areas) {
  View view;
  view.distance = -std::numeric_limits<double>::infinity();
  const double sum = areas[0] + areas[1] + areas[2];
  for (std::size_t c = 0; c < 3; ++c) {
    view.weight[c] = areas[c] / sum;
    view.distance = std::max(view.distance, -areas[c] / std::abs(p[(c + 2) % 3] - p[(c + 1) % 3]));
  }
  return view;
}

View view_from_sides(const Corners& p, Complex z) {
  View best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const Complex side = p[next] - p[c];
    const double part = std::clamp((std::conj(side) * (z - p[c])).real() / std::norm(side), 0.0, 1.0);
    const double distance = std::abs(p[c] + part * side - z);
    if (!(distance < best.distance)) continue;
    best = {distance, {}};
    best.weight[c] = 1 - part;
    best.weight[next] = part;
  }
  return best;
}

View view(const Corners& p, Complex z) {
  // Twice the areas of the triangles between the point and the sides, by opposite corners.
  const std::array<double, 3> areas = {cross(p[1] - z, p[2] - z), cross(p[2] - z, p[0] - z),
                                       cross(p[0] - z, p[1] - z)};
  const bool is_inside = *std::min_element(areas.begin(), areas.end()) >= 0;
  return is_inside ? view_inside(p, areas) : view_from_sides(p, z);
}

/// The triangles that are not turned over, by their boxes.
class Tiles {
public:
  Tiles(const mesh::Surface& surface, const std::vector<Complex>& position)
      : surface_(surface), position_(position) {
    std::vector<std::pair<Box, int>> upright;
    for (int t = 0; t < surface.triangle_count(); ++t) {
      const Corners p = corners(t);
      if (!(cross(p[1] - p[0], p[2] - p[0]) > 0)) continue;
      const auto [left, right] = std::minmax({p[0].real(), p[1].real(), p[2].real()});
      const auto [low, high] = std::minmax({p[0].imag(), p[1].imag(), p[2].imag()});
      upright.emplace_back(Box{{left, low}, {right, high}}, t);
    }
    if (upright.empty()) throw PreconditionError("all triangles are inverted in the plane");
    boxes_ = Tree(upright);
  }

  FlatPoint nearest(Complex z) const {
    const Point point(z.real(), z.imag());
    View best;
    best.distance = std::numeric_limits<double>::infinity();
    FlatPoint found;
    // Nearest boxes, more and more of them, until all others are farther than the best triangle. Queries that
    // go on one by one sort all that they have met, which takes too long.
    double reached = 0;
    for (std::size_t count = 8; reached <= std::max(best.distance, 0.0); count *= 4) {
      std::vector<std::pair<Box, int>> boxes;
      boxes_.query(geometry::index::nearest(point, static_cast<unsigned>(count)), std::back_inserter(boxes));
      for (const auto& [box, triangle] : boxes) {
        reached = std::max(reached, geometry::distance(point, box));
        const View here = view(corners(triangle), z);
        if (!(here.distance < best.distance)) continue;
        best = here;
        found.at.triangle = triangle;
      }
      if (boxes.size() == boxes_.size()) break;
    }
    found.at.weight = best.weight;
    found.outside = std::max(best.distance, 0.0);
    return found;
  }

private:
  using Point = geometry::model::d2::point_xy<double>;
  using Box = geometry::model::box<Point>;
  using Tree = geometry::index::rtree<std::pair<Box, int>, geometry::index::quadratic<16>>;
  Corners corners(int triangle) const {
    const auto& v = surface_.corners(triangle);
    return {position_[v[0]], position_[v[1]], position_[v[2]]};
  }

  const mesh::Surface& surface_;
  const std::vector<Complex>& position_;
  Tree boxes_;
};

} // namespace

std::vector<FlatPoint> flat_points(const mesh::Surface& surface, const std::vector<Complex>& position,
                                   const std::vector<Complex>& points) {
  const Tiles tiles(surface, position);
  std::vector<FlatPoint> result;
  result.reserve(points.size());
  for (const Complex z : points) result.push_back(tiles.nearest(z));
  return result;
}

} // namespace tetrarch::slit
