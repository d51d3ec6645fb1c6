// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The nearest point of a set of triangles.
///
///          p            A tree of boxes: each holds two halves of its triangles, split across its longest
///          :            side. A search goes into the nearer box first and leaves out what is farther than
///      .---x----.       the best point so far. Triangles without area stand for segments or points.
///
/// Source: Ericson, "Real-Time Collision Detection" (2005), chapters 5 and 6.

#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <vector>

namespace tetrarch::numeric {

/// A nearest point.
struct Foot {
  int triangle = -1; ///< -1: there is none
  Point at{};
  double distance = 0;
};

/// Answers the question for one set of triangles.
class NearestTriangle {
public:
  /// O(n log n).
  explicit NearestTriangle(std::vector<std::array<Point, 3>> triangles);

  int size() const { return static_cast<int>(triangles_.size()); }
  /// Unit, counterclockwise; zero where a triangle has no area.
  const Vector& normal(int triangle) const { return normals_[static_cast<std::size_t>(triangle)]; }
  const std::array<Point, 3>& corners(int triangle) const {
    return triangles_[static_cast<std::size_t>(triangle)];
  }
  /// Of equally near ones the one met first. With `facing`, triangles whose normal points away from it are
  /// passed over, unless all do. O(log n) on the average.
  Foot nearest(const Point& p, const Vector* facing = nullptr) const;

private:
  struct Box {
    Point least{};
    Point most{};
    int first = 0; ///< triangles order_[first .. first + count)
    int count = 0;
    int second = -1; ///< the other half; the first half is the next box; -1: a leaf
  };
  int build(int first, int count);
  void search(int box, const Point& p, const Vector* facing, Foot& best) const;

  std::vector<std::array<Point, 3>> triangles_;
  std::vector<Vector> normals_;
  std::vector<int> order_;
  std::vector<Box> boxes_;
};

} // namespace tetrarch::numeric
