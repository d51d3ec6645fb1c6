// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::format {
namespace {

using Point = std::array<double, 3>;
using Flat = std::array<double, 2>;

/// Twice the vector area of a closed polygon, as Newell sums it.
Point normal_of(const std::vector<Point>& corners) {
  Point normal{};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point& p = corners[k];
    const Point& q = corners[(k + 1) % corners.size()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = (axis + 1) % 3;
      const std::size_t j = (axis + 2) % 3;
      normal[axis] += (p[i] - q[i]) * (p[j] + q[j]);
    }
  }
  return normal;
}

/// The polygon seen along the axis that its normal is closest to, counterclockwise.
std::vector<Flat> flattened(std::span<const int> corners, const std::vector<Point>& points) {
  std::vector<Point> around;
  for (const int v : corners) {
    const bool exists = v >= 0 && static_cast<std::size_t>(v) < points.size();
    around.push_back(exists ? points[static_cast<std::size_t>(v)] : Point{});
  }
  // From its first corner on, so that a polygon far away from the origin loses no digits.
  const Point origin = around.front();
  for (Point& p : around)
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= origin[axis];
  const Point normal = normal_of(around);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
  std::vector<Flat> flat;
  for (const Point& p : around) {
    const Flat seen{p[(axis + 1) % 3], p[(axis + 2) % 3]};
    flat.push_back(normal[axis] < 0 ? Flat{seen[1], seen[0]} : seen);
  }
  return flat;
}

/// Twice the area of abc; positive if counterclockwise.
double area(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Of points against ears, a second's work: only a polygon of many thousand corners that winds about needs
/// more, and any triangles of its corners make the same surface.
constexpr std::size_t most_tests = 200'000'000;

/// Cuts ears off a polygon until a triangle is left.
class EarClipper {
public:
  explicit EarClipper(const std::vector<Flat>& corners)
      : corners_(corners), next_(corners.size()), previous_(corners.size()) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      next_[k] = (k + 1) % corners.size();
      previous_[next_[k]] = k;
    }
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (turn(k) < 0) reflex_.push_back(k);
  }

  std::vector<std::array<std::size_t, 3>> run() && {
    std::vector<std::array<std::size_t, 3>> triangles;
    std::size_t at = 0;
    std::size_t looked_at = 0;
    for (std::size_t left = corners_.size(); left > 2;) {
      // If no corner is an ear, which happens only where the polygon meets itself, any will do; so it will
      // where the search has taken too long.
      if (looked_at++ < left && tests_ < most_tests && !is_ear(at)) {
        at = next_[at];
        continue;
      }
      triangles.push_back({previous_[at], at, next_[at]});
      next_[previous_[at]] = next_[at];
      previous_[next_[at]] = previous_[at];
      at = next_[next_[at]]; // not the same corner again: that would make a fan of slivers
      looked_at = 0;
      --left;
    }
    return triangles;
  }

private:
  double turn(std::size_t k) const { return area(corners_[previous_[k]], corners_[k], corners_[next_[k]]); }

  bool is_ear(std::size_t k) {
    if (!(turn(k) > 0)) return false;
    // A corner that has become convex stays so: reflex corners only get fewer.
    std::erase_if(reflex_, [this](std::size_t r) { return next_[previous_[r]] != r || turn(r) >= 0; });
    const Flat& a = corners_[previous_[k]];
    const Flat& b = corners_[k];
    const Flat& c = corners_[next_[k]];
    tests_ += reflex_.size();
    return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t r) {
      if (r == previous_[k] || r == next_[k]) return false;
      const Flat& p = corners_[r];
      if (p == a || p == b || p == c) return false;
      return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
    });
  }

  const std::vector<Flat>& corners_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> reflex_;
  std::size_t tests_ = 0;
};

} // namespace

std::vector<std::array<std::size_t, 3>> cut_polygon(std::span<const int> corners,
                                                    const std::vector<std::array<double, 3>>& points) {
  const std::vector<Flat> flat = flattened(corners, points);
  const std::size_t n = corners.size();
  bool convex = true;
  for (std::size_t k = 0; k < n; ++k)
    convex = convex && area(flat[k], flat[(k + 1) % n], flat[(k + 2) % n]) > 0; // strictly: no flat triangles
  if (!convex) return EarClipper(flat).run();
  std::vector<std::array<std::size_t, 3>> fan;
  const auto first =
      static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) - corners.begin());
  for (std::size_t k = 1; k + 1 < n; ++k) fan.push_back({first, (first + k) % n, (first + k + 1) % n});
  return fan;
}

} // namespace tetrarch::format
