// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Points spread over a triangle.
///
///          c              Rows run along the longest side, no farther apart than the spacing, and so are the
///         . .             points of a row. A long and narrow triangle gets as many as its area asks for, not
///       .  .  .           as many as a wide one of its length would.
///     a . . . . b

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetrarch::hex {

/// No farther apart than `spacing` along rows and across, the corners among them; but there are at most
/// `most_parts` parts of a row, and as many rows. O(points).
inline std::vector<numeric::Point> spread_points(const std::array<numeric::Point, 3>& triangle,
                                                 double spacing, int most_parts) {
  using namespace numeric;
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (distance(triangle[k], triangle[(k + 1) % 3]) >
        distance(triangle[longest], triangle[(longest + 1) % 3]))
      longest = k;
  const Point& a = triangle[longest];
  const Point& b = triangle[(longest + 1) % 3];
  const Point& c = triangle[(longest + 2) % 3];
  const double length = distance(a, b);
  const double height = length > 0 ? norm(cross(b - a, c - a)) / length : 0;
  const auto parts_of = [&](double way) {
    const double wanted = std::ceil(way / spacing);
    return wanted >= most_parts ? most_parts : std::max(1, static_cast<int>(wanted));
  };
  const int rows = parts_of(height);
  std::vector<Point> result;
  for (int j = 0; j <= rows; ++j) {
    const double up = j / static_cast<double>(rows);
    const int parts = j == rows ? 0 : parts_of((1 - up) * length);
    for (int i = 0; i <= parts; ++i) {
      const double u = parts == 0 ? 0 : i / static_cast<double>(parts);
      result.push_back((1 - up) * ((1 - u) * a + u * b) + up * c);
    }
  }
  return result;
}

} // namespace tetrarch::hex
