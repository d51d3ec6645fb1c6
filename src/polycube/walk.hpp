// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Straight walks through the image of a solid's mesh, from tetrahedron to tetrahedron.

#include "tetrarch/product/solid.hpp"

#include <array>
#include <vector>

namespace tetrarch::polycube {

using numeric::Point;

/// Barycentric coordinates in a tetrahedron.
using Weights = std::array<double, 4>;

struct WalkEnd {
  int tet = 0;
  Weights weight{};     ///< of the goal in the tetrahedron
  int triangle = -1;    ///< of the boundary, through which the walk would have left; -1: it arrived
  bool is_lost = false; ///< it went on for too long, as it may where tetrahedra are folded
};

class ImageWalk {
public:
  ImageWalk(const product::Solid& solid, const std::vector<Point>& image) : solid_(solid), image_(image) {}

  /// Not finite where the image of the tetrahedron has no volume.
  Weights weights(int tet, const Point& p) const;
  /// From a point in a tetrahedron. O(tetrahedra met).
  WalkEnd walk(int tet, const Point& from, const Point& to) const;

private:
  const product::Solid& solid_;
  const std::vector<Point>& image_;
};

} // namespace tetrarch::polycube
