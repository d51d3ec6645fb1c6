// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where points of the plane lie among triangles that cover a part of it.
///
///      +---+---+       The plane is cut into square buckets, about as many as triangles; a bucket knows the
///      | /\|   |       triangles that reach into it. Of several triangles the one is taken in which the
///      |/__\   |       point lies deepest, of none the nearest. Triangles that are turned over are left out:
///      +---+\--+       where the drawing covers the plane once, counted with signs, others cover the same.

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::product {

using FlatCorners = std::array<std::complex<double>, 3>;

struct FlatPlace {
  int triangle = -1;              ///< -1 where there are no triangles
  std::array<double, 3> weight{}; ///< of its corners; exactly 0 on sides
  double outside = 0;             ///< the distance from the triangle
};

/// The nearest point to z of the segment from `from` to `to`, as the part of the way.
double nearest_part(std::complex<double> from, std::complex<double> to, std::complex<double> z);

class FlatLocator {
public:
  explicit FlatLocator(std::vector<FlatCorners> triangles);

  /// The triangle in which the point is, -1 if there is none. O(triangles in a bucket).
  FlatPlace inside(std::complex<double> z) const;
  /// The same, or the nearest: then O(triangles).
  FlatPlace nearest(std::complex<double> z) const;
  double area() const { return area_; } ///< of all triangles that are not turned over

private:
  struct Cell {
    int column = 0;
    int row = 0;
  };
  Cell cell_of(std::complex<double> z) const;

  std::vector<FlatCorners> triangles_;
  std::vector<char> upright_;
  std::complex<double> low_;
  double width_ = 1; ///< of a bucket
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::vector<int>> bucket_;
  double area_ = 0;
};

} // namespace tetrarch::product
