// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where points of hexahedra belong on the surface of a solid.

#include "tetrarch/hex/features.hpp"
#include "tetrarch/numeric/nearest_triangle.hpp"

#include <vector>

namespace tetrarch::hex {

using numeric::NearestTriangle;
using numeric::Vector;

/// Where a point of a mesh of hexahedra is to be.
struct Home {
  enum class Kind : char { inside, surface, patch, ridge, corner } kind = Kind::inside;
  int index = 0; ///< of the patch, ridge or corner
};

/// Where it is nearest, and what the surface or ridge looks like there.
struct Place {
  Point at{};
  double distance = 0;
  Vector direction{}; ///< the surface's normal, or along the ridge
};

/// The surface of a solid, whole and in its parts.
class Targets {
public:
  /// O(n log n).
  Targets(const product::Solid& solid, Features features);

  const Features& features() const { return features_; }
  const NearestTriangle& whole() const { return whole_; }
  /// The patch of a triangle of the boundary.
  int patch_of(int triangle) const { return features_.patch[static_cast<std::size_t>(triangle)]; }
  Point corner(int k) const { return corners_[static_cast<std::size_t>(k)]; }
  /// Along a ridge, from its first vertex to its last.
  std::vector<Point> ridge(int k) const;
  /// The nearest place at home. `facing` as in `NearestTriangle`. Throws PreconditionError for a point
  /// inside.
  Place place(const Home& home, const Point& p, const Vector* facing = nullptr) const;

private:
  Features features_;
  NearestTriangle whole_;
  std::vector<NearestTriangle> patches_;
  std::vector<NearestTriangle> ridges_;
  std::vector<std::vector<Point>> lines_;
  std::vector<Point> corners_;
};

} // namespace tetrarch::hex
