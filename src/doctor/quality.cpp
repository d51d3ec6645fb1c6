// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/quality.hpp"

#include "orient_solid.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace tetrarch::doctor {
namespace {

using namespace numeric;

constexpr double degrees = 180 / std::numbers::pi;

/// Between two vectors, without loss near 0 and 180 degrees.
double angle(const Point& a, const Point& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * degrees;
}

/// Coordinates as large as 1e200 would overflow in products, as small as 1e-200 vanish: all is measured in
/// units of the longest edge. Nothing happens to an element without extent.
template <std::size_t N>
std::array<Point, N> scaled(std::array<Point, N> p) {
  double longest = 0;
  for (std::size_t k = 0; k < N; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      longest = std::max(longest, std::fabs(p[k][axis] - p[0][axis]));
  if (!(longest > 0) || !std::isfinite(longest)) return p;
  const Point origin = p[0];
  for (Point& q : p)
    for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = (q[axis] - origin[axis]) / longest;
  return p;
}

double quotient(double a, double b) {
  return b > 0 ? a / b : 0;
}

template <std::size_t N>
Quality quality_of_all(const format::Soup& soup, const std::vector<std::array<int, N>>& elements, int worst) {
  const auto better = [](const ElementQuality& a, const ElementQuality& b) {
    return a.scaled_jacobian != b.scaled_jacobian ? a.scaled_jacobian < b.scaled_jacobian
                                                  : a.element < b.element;
  };
  std::priority_queue<ElementQuality, std::vector<ElementQuality>, decltype(better)> kept(better);
  Quality all{std::numeric_limits<double>::infinity(), 0, std::numeric_limits<double>::infinity(), {}};
  for (std::size_t t = 0; t < elements.size(); ++t) {
    std::array<Point, N> p{};
    for (std::size_t c = 0; c < N; ++c) p[c] = soup.points[static_cast<std::size_t>(elements[t][c])];
    ElementQuality one = quality_of(p);
    one.element = static_cast<int>(t);
    all.least_angle = std::min(all.least_angle, one.least_angle);
    all.greatest_angle = std::max(all.greatest_angle, one.greatest_angle);
    all.least_scaled_jacobian = std::min(all.least_scaled_jacobian, one.scaled_jacobian);
    kept.push(one);
    if (kept.size() > static_cast<std::size_t>(std::max(worst, 0))) kept.pop();
  }
  if (elements.empty()) return {};
  for (; !kept.empty(); kept.pop()) all.worst.push_back(kept.top());
  std::reverse(all.worst.begin(), all.worst.end());
  return all;
}

} // namespace

ElementQuality quality_of(const std::array<Point, 4>& tetrahedron) {
  const std::array<Point, 4> p = scaled(tetrahedron);
  ElementQuality out{0, std::numeric_limits<double>::infinity(), 0, 0};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) {
      const std::size_t c = a == 0 ? (b == 1 ? 2 : 1) : 0;
      const std::size_t d = 6 - a - b - c;
      const Vector edge = p[b] - p[a];
      const double here = angle(cross(edge, p[c] - p[a]), cross(edge, p[d] - p[a]));
      out.least_angle = std::min(out.least_angle, here);
      out.greatest_angle = std::max(out.greatest_angle, here);
    }
  const double determinant = dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]));
  double greatest = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    double product = 1;
    for (std::size_t b = 0; b < 4; ++b)
      if (b != a) product *= length(p[b] - p[a]);
    greatest = std::max(greatest, product);
  }
  out.scaled_jacobian = quotient(std::numbers::sqrt2 * determinant, greatest);
  return out;
}

ElementQuality quality_of(const std::array<Point, 3>& triangle) {
  const std::array<Point, 3> p = scaled(triangle);
  ElementQuality out{0, std::numeric_limits<double>::infinity(), 0, 0};
  for (std::size_t a = 0; a < 3; ++a) {
    const double here = angle(p[(a + 1) % 3] - p[a], p[(a + 2) % 3] - p[a]);
    out.least_angle = std::min(out.least_angle, here);
    out.greatest_angle = std::max(out.greatest_angle, here);
  }
  out.scaled_jacobian = std::sin(out.least_angle / degrees) * 2 / std::numbers::sqrt3;
  return out;
}

Quality quality(const format::Soup& soup, int worst) {
  return soup.tetrahedra.empty() ? quality_of_all(soup, soup.triangles, worst)
                                 : quality_of_all(soup, soup.tetrahedra, worst);
}

namespace {

template <class Elements>
void grow(Extent& extent, const format::Soup& soup, const Elements& elements) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  extent.least = {infinity, infinity, infinity};
  extent.greatest = {-infinity, -infinity, -infinity};
  for (const auto& corners : elements)
    for (const int v : corners)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = soup.points[static_cast<std::size_t>(v)][axis];
        extent.least[axis] = std::min(extent.least[axis], x);
        extent.greatest[axis] = std::max(extent.greatest[axis], x);
      }
}

} // namespace

Extent extent(const format::Soup& soup) {
  Extent out;
  if (!soup.tetrahedra.empty()) {
    grow(out, soup, soup.tetrahedra);
    for (const auto& corners : soup.tetrahedra) out.volume += rounded_volume(soup, corners);
  } else if (!soup.triangles.empty()) {
    grow(out, soup, soup.triangles);
    for (const auto& corners : soup.triangles) {
      std::array<Point, 3> p{};
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = soup.points[static_cast<std::size_t>(corners[c])] - out.least;
      const Point normal = cross(p[1] - p[0], p[2] - p[0]);
      out.area += length(normal) / 2;
      out.volume += dot(p[0], cross(p[1], p[2])) / 6;
    }
  }
  return out;
}

} // namespace tetrarch::doctor
