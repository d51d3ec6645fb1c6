// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fibers: the curves along which a field runs from the floor to the ceiling.
///
///     =====*=====       In each tetrahedron the field is a constant vector, so a fiber is a polygon. At a
///          \            face, an edge or a vertex it goes on into that tetrahedron, face or edge around the
///           |           point where the way is steepest: where the field points into a face from both sides,
///     ------*------     it slides along the face, so it always goes on but at an extremum. On a wall the
///            \          choice is among the faces and edges of the wall: a fiber that starts there stays
///     ========*===      there.
///
/// Source: Yin, section 3.4.4; the tracing there does not slide, and finds no next tetrahedron at a few
/// percent of the faces.

#include "tetrarch/product/partition.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tetrarch::product {

/// A point of a solid. Weights are not negative and add up to 1; those that are exactly 0 tell which face,
/// edge or vertex of the tetrahedron the point lies on.
struct Location {
  int tet = -1;
  std::array<double, 4> weight{};
};

/// The gradient of a function that is linear on a tetrahedron.
Point gradient_in(const Solid& solid, int tet, const std::vector<double>& f);

Point point_at(const Solid& solid, const Location& location);
/// Of a function that is linear on each tetrahedron.
double value_at(const Solid& solid, const std::vector<double>& f, const Location& location);

enum class Way : std::uint8_t { down, up };

/// The vectors that a fiber follows.
enum class Direction : std::uint8_t {
  gradient, ///< of w, constant on each tetrahedron: rises all the way, but fibers may run into one another
  smoothed  ///< at each vertex the mean of those around it, linear on each tetrahedron: fibers stay apart
};

enum class FiberEnd : std::uint8_t {
  base,  ///< arrived on the floor, or on the ceiling
  level, ///< arrived at the level that was asked for
  stuck, ///< no way on: the field vanishes or has an extremum
  budget ///< too many steps
};

/// The end of a fiber: place and reason.
struct Fiber {
  FiberEnd end = FiberEnd::stuck;
  Location at; ///< where it ends; on a base only the weights of vertices on the base are not 0
  int steps = 0;
  double length = 0;
  /// Whether smoothed vectors led nowhere and the fiber followed the gradient from the start.
  bool by_gradient = false;
};

/// A field ready for tracing. Keeps references to solid and partition.
///
/// Smoothed vectors are means weighted by volume. At walls what points out of them is taken away, and on a
/// ridge between two walls all but what runs along it. They are of second order on regular meshes, where the
/// gradient is of first, and continuous; inside a tetrahedron a fiber then goes straight in the direction of
/// the middle of its way.
class FiberField {
public:
  /// The field of `w`, a value for each vertex: 0 on the floor, greatest on the ceiling. O(n).
  FiberField(const Solid& solid, const Partition& partition, std::vector<double> w,
             Direction direction = Direction::smoothed);

  const Solid& solid() const { return *solid_; }
  const std::vector<double>& w() const { return w_; }
  /// w on the ceiling.
  double height() const { return height_; }
  /// A vertex of the mesh, which must be in a tetrahedron.
  Location at_vertex(int v) const;
  /// Whether it is in one: files have points that belong to nothing.
  bool is_used(int v) const { return corner_[static_cast<std::size_t>(v)].tet >= 0; }
  /// A point of a triangle of the boundary, by weights of its corners.
  Location on_triangle(int triangle, const std::array<double, 3>& weight) const;

  /// Follows the field down to the floor, or up to the ceiling. May be called by several threads at the same
  /// time. O(tetrahedra met).
  Fiber trace(const Location& from, Way way) const;
  /// The same with the corners of the polygon, from start to end, put at the end of `path`.
  Fiber trace(const Location& from, Way way, std::vector<Point>& path) const;
  /// The same up to the point where w is `level`; it does not move if it starts there or beyond.
  Fiber trace_to(const Location& from, Way way, double level) const;

private:
  class Walker;
  Fiber run(const Location& from, Way way, double level, std::vector<Point>* path) const;

  const Solid* solid_;
  const Partition* partition_;
  std::vector<double> w_;
  double height_ = 0;
  std::vector<Point> gradient_;   ///< of each tetrahedron
  std::vector<Point> smoothed_;   ///< of each vertex; empty: the gradient is followed
  std::vector<int> base_;         ///< of each vertex, as `bases_of_vertices`
  std::vector<char> on_wall_;     ///< of each vertex
  std::vector<TetVertex> corner_; ///< of each vertex, one of its corners
};

} // namespace tetrarch::product
