// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/flat_locator.hpp"

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace tetrarch::numeric {
namespace {

namespace geometry = boost::geometry;
using Complex = std::complex<double>;
using FlatPoint = geometry::model::d2::point_xy<double>;
using Box = geometry::model::box<FlatPoint>;
using BoxTree = geometry::index::rtree<std::pair<Box, int>, geometry::index::quadratic<16>>;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Weights below this are rounding: the point is on the side.
constexpr double on_side = 1e-10;
/// A point whose weights are no less than -on_side is not farther from the triangle than this part of its
/// extent.
constexpr double margin = 1e-9;

void tidy(std::array<double, 3>& weight) {
  double sum = 0;
  for (double& x : weight) {
    if (x < on_side) x = 0;
    sum += x;
  }
  for (double& x : weight) x /= sum;
}

Box box_of(const FlatTriangle& p) {
  const auto [left, right] = std::minmax({p[0].real(), p[1].real(), p[2].real()});
  const auto [below, above] = std::minmax({p[0].imag(), p[1].imag(), p[2].imag()});
  return {{left, below}, {right, above}};
}

/// Twice the areas of the triangles between the point and the sides, by opposite corners.
std::array<double, 3> parts(const FlatTriangle& p, Complex z) {
  return {cross(p[1] - z, p[2] - z), cross(p[2] - z, p[0] - z), cross(p[0] - z, p[1] - z)};
}

std::array<double, 3> weights(const FlatTriangle& p, Complex z) {
  const double whole = twice_area(p);
  std::array<double, 3> weight = parts(p, z);
  for (double& x : weight) x /= whole;
  return weight;
}

/// The point of the triangle's sides that is nearest to z.
FlatPlace on_sides(const FlatTriangle& p, Complex z) {
  FlatPlace best;
  best.outside = infinite;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const Complex side = p[next] - p[c];
    const double part = nearest_part(p[c], p[next], z);
    const double distance = std::abs(p[c] + part * side - z);
    if (!(distance < best.outside)) continue;
    best.outside = distance;
    best.weight = {};
    best.weight[c] = 1 - part;
    best.weight[next] = part;
  }
  return best;
}

/// With the depth, negative, as the distance of a point inside.
FlatPlace by_depth(const FlatTriangle& p, Complex z) {
  const std::array<double, 3> areas = parts(p, z);
  if (!(*std::min_element(areas.begin(), areas.end()) >= 0)) return on_sides(p, z);
  FlatPlace place;
  place.outside = -infinite;
  const double sum = areas[0] + areas[1] + areas[2];
  for (std::size_t c = 0; c < 3; ++c) {
    place.weight[c] = areas[c] / sum;
    place.outside = std::max(place.outside, -areas[c] / std::abs(p[(c + 2) % 3] - p[(c + 1) % 3]));
  }
  return place;
}

} // namespace

struct FlatLocator::Tree {
  std::vector<FlatTriangle> triangles;
  BoxTree boxes; ///< of those that are not turned over
  double reach = 0;

  /// The place of least `outside`; `see(triangle, z)` says how a triangle sees the point. Of equals the first
  /// that is met stays, or that of the least number.
  template <class See>
  FlatPlace least(Complex z, bool least_number, const See& see) const {
    const FlatPoint point(z.real(), z.imag());
    FlatPlace best;
    best.outside = infinite;
    // Nearest boxes, more and more of them, until all others are farther than the best triangle. Queries that
    // go on one by one sort all that they have met, which takes too long.
    double reached = 0;
    for (std::size_t count = 8; reached <= std::max(best.outside, 0.0); count *= 4) {
      std::vector<std::pair<Box, int>> near;
      boxes.query(geometry::index::nearest(point, static_cast<unsigned>(count)), std::back_inserter(near));
      for (const auto& [box, triangle] : near) {
        reached = std::max(reached, geometry::distance(point, box));
        FlatPlace here = see(triangles[triangle], z);
        here.triangle = triangle;
        const bool equal = least_number && here.outside == best.outside && triangle < best.triangle;
        if (here.outside < best.outside || equal) best = here;
      }
      if (near.size() == boxes.size()) break;
    }
    return best;
  }
};

FlatLocator::FlatLocator(std::vector<FlatTriangle> triangles) {
  std::vector<std::pair<Box, int>> upright;
  double longest = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double twice = twice_area(triangles[t]);
    if (!(twice > 0)) continue;
    area_ += twice / 2;
    longest = std::max(longest, longest_squared(triangles[t]));
    upright.emplace_back(box_of(triangles[t]), static_cast<int>(t));
  }
  tree_ =
      std::make_shared<const Tree>(Tree{std::move(triangles), BoxTree(upright), margin * std::sqrt(longest)});
}

bool FlatLocator::empty() const {
  return tree_->boxes.empty();
}

FlatPlace FlatLocator::inside(Complex z) const {
  const Box around{{z.real() - tree_->reach, z.imag() - tree_->reach},
                   {z.real() + tree_->reach, z.imag() + tree_->reach}};
  std::vector<std::pair<Box, int>> near;
  tree_->boxes.query(geometry::index::intersects(around), std::back_inserter(near));
  FlatPlace best;
  double depth = -on_side;
  for (const auto& [box, triangle] : near) {
    const std::array<double, 3> weight = weights(tree_->triangles[triangle], z);
    const double least = *std::min_element(weight.begin(), weight.end());
    const bool first_of_equals = best.triangle >= 0 && least == depth && triangle < best.triangle;
    if (!(least > depth) && !first_of_equals) continue;
    depth = least;
    best = {triangle, weight, 0};
  }
  if (best.triangle >= 0) tidy(best.weight);
  return best;
}

FlatPlace FlatLocator::nearest(Complex z) const {
  FlatPlace best = inside(z);
  if (best.triangle >= 0) return best;
  best = tree_->least(z, true, on_sides);
  if (best.triangle >= 0) tidy(best.weight);
  return best;
}

FlatPlace FlatLocator::deepest(Complex z) const {
  FlatPlace best = tree_->least(z, false, by_depth);
  best.outside = std::max(best.outside, 0.0);
  return best;
}

} // namespace tetrarch::numeric
