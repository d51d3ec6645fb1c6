// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/nearest_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace tetrarch::numeric {
namespace {

constexpr int leaf_size = 4;

Point on_segment(const Point& p, const Point& a, const Point& b) {
  const Vector ab = b - a;
  const double square = dot(ab, ab);
  if (!(square > 0)) return a;
  return a + std::clamp(dot(p - a, ab) / square, 0.0, 1.0) * ab;
}

double squared(const Vector& v) {
  return dot(v, v);
}

Point on_triangle(const Point& p, const std::array<Point, 3>& t, const Vector& normal) {
  const Point flat = p - dot(normal, p - t[0]) * normal;
  bool is_inside = squared(normal) > 0;
  for (std::size_t k = 0; k < 3 && is_inside; ++k)
    is_inside = dot(normal, cross(t[(k + 1) % 3] - t[k], flat - t[k])) >= 0;
  if (is_inside) return flat;
  Point best = on_segment(p, t[0], t[1]);
  for (std::size_t k = 1; k < 3; ++k) {
    const Point other = on_segment(p, t[k], t[(k + 1) % 3]);
    if (squared(other - p) < squared(best - p)) best = other;
  }
  return best;
}

double distance_to_box(const Point& p, const Point& least, const Point& most) {
  Vector away{};
  for (std::size_t a = 0; a < 3; ++a) away[a] = std::max({least[a] - p[a], 0.0, p[a] - most[a]});
  return norm(away);
}

} // namespace

NearestTriangle::NearestTriangle(std::vector<std::array<Point, 3>> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  normals_.reserve(triangles_.size());
  for (const auto& t : triangles_)
    normals_.push_back(direction(cross(t[1] - t[0], t[2] - t[0])).value_or(Vector{}));
  std::iota(order_.begin(), order_.end(), 0);
  if (!triangles_.empty()) build(0, size());
}

int NearestTriangle::build(int first, int count) {
  const int here = static_cast<int>(boxes_.size());
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far, far}, {-far, -far, -far}, first, count, -1};
  for (int k = first; k < first + count; ++k)
    for (const Point& p : triangles_[order_[k]])
      for (std::size_t a = 0; a < 3; ++a) {
        box.least[a] = std::min(box.least[a], p[a]);
        box.most[a] = std::max(box.most[a], p[a]);
      }
  boxes_.push_back(box);
  if (count <= leaf_size) return here;
  const Vector extent = box.most - box.least;
  const auto axis = static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
  const auto middle = [&](int t) {
    return triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis];
  };
  const int half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count,
                   [&](int s, int t) { return std::pair(middle(s), s) < std::pair(middle(t), t); });
  build(first, half);
  boxes_[here].second = build(first + half, count - half);
  return here;
}

void NearestTriangle::search(int box, const Point& p, const Vector* facing, Foot& best) const {
  const Box& b = boxes_[box];
  if (b.second < 0) {
    for (int k = b.first; k < b.first + b.count; ++k) {
      const int t = order_[k];
      if (facing != nullptr && dot(*facing, normals_[t]) < 0) continue;
      const Point at = on_triangle(p, triangles_[t], normals_[t]);
      const double there = norm(at - p);
      if (there < best.distance) best = {t, at, there};
    }
    return;
  }
  std::array<std::pair<double, int>, 2> halves{};
  for (std::size_t k = 0; k < 2; ++k) {
    const int half = k == 0 ? box + 1 : b.second;
    halves[k] = {distance_to_box(p, boxes_[half].least, boxes_[half].most), half};
  }
  std::sort(halves.begin(), halves.end());
  for (const auto& [near, half] : halves)
    if (near < best.distance) search(half, p, facing, best);
}

Foot NearestTriangle::nearest(const Point& p, const Vector* facing) const {
  Foot best{-1, {}, std::numeric_limits<double>::infinity()};
  if (boxes_.empty()) return best;
  search(0, p, facing, best);
  return best.triangle < 0 && facing != nullptr ? nearest(p) : best;
}

} // namespace tetrarch::numeric
