// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fibres: the curves along which a field runs from the floor to the ceiling.
///
///     =====*=====       In each tetrahedron the field is a constant vector, so a fibre is a polygon. At a
///          \            face, an edge or a vertex it goes on into that tetrahedron, face or edge around the
///           |           point where the way is steepest: where the field points into a face from both sides,
///     ------*------     it slides along the face, so it always goes on but at an extremum. On a wall the
///            \          choice is among the faces and edges of the wall: a fibre that starts there stays
///     ========*===      there.
///
/// Source: Yin, section 3.4.4, whose tracing knows no sliding and has no next tetrahedron at a few per cent
/// of the faces.

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

Point point_at(const Solid& solid, const Location& location);
/// Of a function that is linear on each tetrahedron.
double value_at(const Solid& solid, const std::vector<double>& f, const Location& location);

enum class Way : std::uint8_t { down, up };
enum class FiberEnd : std::uint8_t {
  base,  ///< arrived on the floor, or on the ceiling
  level, ///< arrived at the level that was asked for
  stuck, ///< no way on: the field vanishes or has an extremum there
  budget ///< too many steps
};

struct Fiber {
  FiberEnd end = FiberEnd::stuck;
  Location at; ///< where it ends; on a base only the weights of vertices on the base are not 0
  int steps = 0;
  double length = 0;
};

/// The field of a function that is 0 on the floor and greater elsewhere, ready for tracing. Keeps references
/// to solid and partition.
class FiberField {
public:
  /// `w`: of each vertex. O(n), 40 bytes for each tetrahedron.
  FiberField(const Solid& solid, const Partition& partition, std::vector<double> w);

  const std::vector<double>& w() const { return w_; }
  double height() const { return height_; } ///< w on the ceiling

  /// Location of a vertex of the mesh.
  Location at_vertex(int v) const;
  /// Location of a point on a triangle of the boundary; weights by its corners.
  Location on_triangle(int triangle, const std::array<double, 3>& weight) const;

  /// Follows the field down to the floor, or up to the ceiling. May be called by several threads at the same
  /// time. O(tetrahedra met).
  Fiber trace(const Location& from, Way way) const;
  /// Only as far as where w is `level`; at once where it is there or beyond.
  Fiber trace_to(const Location& from, Way way, double level) const;
  /// The same with the corners of the polygon, from start to end, put at the end of `path`.
  Fiber trace(const Location& from, Way way, std::vector<Point>& path) const;

private:
  struct Step;
  struct Walker;
  Fiber run(const Location& from, Way way, double level, std::vector<Point>* path) const;

  const Solid* solid_;
  const Partition* partition_;
  std::vector<double> w_;
  double height_ = 0;
  std::vector<std::array<double, 4>> rate_; ///< of each tetrahedron: how its weights change along grad w
  std::vector<double> slope_;               ///< |grad w|^2
  std::vector<char> wall_vertex_;           ///< of each vertex whether it is on a wall
  std::vector<TetVertex> corner_of_;        ///< of each vertex, one of its corners
};

} // namespace tetrarch::product
