// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/features.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using surface::Side;

constexpr double degree = std::numbers::pi / 180;

Vector area_vector(const product::Solid& solid, int t) {
  const Point& p = solid.point(solid.corner(t, 0));
  return 0.5 * cross(solid.point(solid.corner(t, 1)) - p, solid.point(solid.corner(t, 2)) - p);
}

/// Patches of triangles, joined across all edges that are not sharp.
class Patches {
public:
  Patches(const product::Solid& solid, const FeatureOptions& options)
      : solid_(solid), of_(static_cast<std::size_t>(solid.boundary.triangle_count()), -1) {
    const double cosine = std::cos(options.sharp * degree);
    const surface::Surface& surface = solid.boundary;
    std::vector<Vector> normal;
    for (int t = 0; t < surface.triangle_count(); ++t) {
      const Vector a = area_vector(solid, t);
      normal.push_back(direction(a).value_or(Vector{}));
    }
    for (int t = 0; t < surface.triangle_count(); ++t) {
      if (of_[t] >= 0) continue;
      std::vector<int> stack{t};
      of_[t] = count_;
      while (!stack.empty()) {
        const int here = stack.back();
        stack.pop_back();
        for (int c = 0; c < 3; ++c) {
          const int there = surface.mate(Side(here, c)).triangle();
          if (of_[there] >= 0 || dot(normal[here], normal[there]) < cosine) continue;
          of_[there] = count_;
          stack.push_back(there);
        }
      }
      ++count_;
    }
  }

  /// The smallest patch joins a neighbor, as long as it is too small.
  void join_small(double least_extent) {
    while (count_ > 1) {
      const std::vector<double> extent = extents();
      const auto smallest = std::min_element(extent.begin(), extent.end());
      if (*smallest >= least_extent) return;
      const int gone = static_cast<int>(smallest - extent.begin());
      const int into = longest_neighbor(gone);
      for (int& p : of_) p = p == gone ? into : p;
      for (int& p : of_) p = p > gone ? p - 1 : p;
      --count_;
    }
  }

  bool separates(Side s) const { return of_[s.triangle()] != of_[solid_.boundary.mate(s).triangle()]; }
  int count() const { return count_; }
  std::vector<int> take() { return std::move(of_); }

private:
  /// The diagonal of each patch's box.
  std::vector<double> extents() const {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<Point> least(static_cast<std::size_t>(count_), {far, far, far});
    std::vector<Point> most(least.size(), {-far, -far, -far});
    for (int t = 0; t < static_cast<int>(of_.size()); ++t)
      for (int c = 0; c < 3; ++c)
        for (std::size_t a = 0; a < 3; ++a) {
          const double x = solid_.point(solid_.corner(t, c))[a];
          least[of_[t]][a] = std::min(least[of_[t]][a], x);
          most[of_[t]][a] = std::max(most[of_[t]][a], x);
        }
    std::vector<double> result;
    for (std::size_t p = 0; p < least.size(); ++p) result.push_back(distance(least[p], most[p]));
    return result;
  }

  int longest_neighbor(int patch) const {
    const surface::Surface& surface = solid_.boundary;
    std::map<int, double> length;
    for (int t = 0; t < surface.triangle_count(); ++t)
      for (int c = 0; c < 3 && of_[t] == patch; ++c) {
        const Side s(t, c);
        const int other = of_[surface.mate(s).triangle()];
        if (other == patch) continue;
        length[other] += distance(solid_.point(solid_.vertex[surface.from(s)]),
                                  solid_.point(solid_.vertex[surface.to(s)]));
      }
    return std::max_element(length.begin(), length.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  const product::Solid& solid_;
  std::vector<int> of_;
  int count_ = 0;
};

/// Sharp edges by their vertices.
using Sharp = std::map<int, std::vector<int>>;

Sharp sharp_edges(const product::Solid& solid, const Patches& patches) {
  Sharp sharp;
  const surface::Surface& surface = solid.boundary;
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      if (const Side s(t, c); patches.separates(s))
        sharp[solid.vertex[surface.from(s)]].push_back(solid.vertex[surface.to(s)]);
  return sharp;
}

bool is_corner(const product::Solid& solid, int v, const std::vector<int>& ends, double turn) {
  if (ends.size() != 2) return true;
  const auto a = direction(solid.point(ends[0]) - solid.point(v));
  const auto b = direction(solid.point(v) - solid.point(ends[1]));
  return a && b && dot(*a, *b) < std::cos(turn * degree);
}

/// From a vertex along a sharp edge, to a corner or back.
Ridge walked(const Sharp& sharp, const std::set<int>& corners, int from, int to,
             std::set<std::pair<int, int>>& done) {
  Ridge ridge{{from}, false};
  while (true) {
    done.insert({from, to});
    done.insert({to, from});
    ridge.vertices.push_back(to);
    if (corners.contains(to) || to == ridge.vertices.front()) break;
    const std::vector<int>& ends = sharp.at(to);
    const int next = ends[0] == from ? ends[1] : ends[0];
    from = std::exchange(to, next);
  }
  ridge.is_closed = !corners.contains(ridge.vertices.front());
  return ridge;
}

} // namespace

Features features(const product::Solid& solid, const FeatureOptions& options) {
  Patches patches(solid, options);
  patches.join_small(options.least_extent);
  const Sharp sharp = sharp_edges(solid, patches);
  Features result;
  std::set<int> corners;
  for (const auto& [v, ends] : sharp)
    if (is_corner(solid, v, ends, options.turn)) corners.insert(v);
  std::set<std::pair<int, int>> done;
  const auto walk_from = [&](int v, const std::vector<int>& ends) {
    for (const int to : ends)
      if (!done.contains({v, to})) result.ridges.push_back(walked(sharp, corners, v, to, done));
  };
  for (const int v : corners) walk_from(v, sharp.at(v));
  for (const auto& [v, ends] : sharp) walk_from(v, ends);
  result.corners.assign(corners.begin(), corners.end());
  result.patches = patches.count();
  result.patch = patches.take();
  return result;
}

} // namespace tetrarch::hex
