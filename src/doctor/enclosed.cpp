// SPDX-License-Identifier: GPL-2.0-or-later
#include "enclosed.hpp"

#include <algorithm>
#include <limits>

namespace tetrarch::doctor {
namespace {

using Point = std::array<double, 3>;

struct Box {
  Point least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()};
  Point greatest{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                 -std::numeric_limits<double>::infinity()};

  void add(const Point& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], p[axis]);
      greatest[axis] = std::max(greatest[axis], p[axis]);
    }
  }
  bool holds(const Box& other) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (other.least[axis] < least[axis] || other.greatest[axis] > greatest[axis]) return false;
    return true;
  }
  double size() const {
    return std::max({greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]});
  }
};

/// Six times the volume of the cone over a triangle from `origin`.
double cone(const format::Soup& soup, const std::array<int, 3>& corners, const Point& origin) {
  std::array<Point, 3> p{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[c][axis] = soup.points[static_cast<std::size_t>(corners[c])][axis] - origin[axis];
  return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
         p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
         p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
}

/// `turned`: triangles that count as turned round.
Enclosed enclosed(const format::Soup& soup, const Surface& surface, const Signs& signs,
                  const std::vector<char>& left_out, const std::vector<char>& turned) {
  const auto parts = static_cast<std::size_t>(signs.parts.count);
  std::vector<char> closed(signs.orientable);
  std::vector<Box> box(parts);
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const int part = signs.parts.of[t];
    if (left_out[t]) {
      closed[part] = 0;
      continue;
    }
    for (const Side s : sides_of(t))
      if (surface.is_boundary(s)) closed[part] = 0;
    for (const int v : soup.triangles[t]) box[part].add(soup.points[static_cast<std::size_t>(v)]);
  }
  Enclosed result{std::vector<double>(parts, 0), std::vector<char>(parts, 0)};
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const int part = signs.parts.of[t];
    if (closed[part])
      result.volume[part] += (turned[t] ? -1 : 1) * cone(soup, soup.triangles[t], box[part].least) / 6;
  }
  // What rounding makes of a volume of zero says nothing.
  constexpr double least = 1e-12;
  // A dust of many thousand components is not worth all pairs.
  constexpr std::size_t most_pairs = 20'000'000;
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const double size = box[k].size();
    if (!closed[k] || !(result.volume[k] < -least * size * size * size)) continue;
    pairs += parts;
    bool in_other = pairs > most_pairs;
    for (std::size_t other = 0; other < parts && !in_other; ++other)
      in_other = other != k && closed[other] && box[other].holds(box[k]);
    result.inside_out[k] = static_cast<char>(!in_other);
  }
  return result;
}

} // namespace

Enclosed enclosed_volumes(const format::Soup& soup, const Surface& surface, const Signs& signs,
                          const std::vector<char>& left_out) {
  return enclosed(soup, surface, signs, left_out, minority(signs));
}

std::vector<char> oriented_inside_out(const format::Soup& soup, const Surface& surface, const Signs& signs,
                                      const std::vector<char>& left_out) {
  return enclosed(soup, surface, signs, left_out, std::vector<char>(soup.triangles.size(), 0)).inside_out;
}

} // namespace tetrarch::doctor
