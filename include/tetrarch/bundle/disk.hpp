// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangulated disk, given by the corners of its triangles; and the sides of triangles, on which cutting
/// patterns live.
///
///            2
///           / \          Side s of a triangle lies opposite corner s and runs from corner s+1 to corner s+2
///    side 1/   \side 0   (mod 3): counterclockwise. An interior edge is two sides, its *mates*, that run in
///         / --> \        opposite directions; a boundary edge is one side. The disk's boundary runs along
///        0-------1       its sides, so that the disk lies to the left.
///          side 2
///
/// Two triangles may share several edges or vertices, a triangle may be glued to itself, and an edge may be a
/// loop: coarse covering disks of surfaces have all of that.
///
/// Why not `TriangulatedSurface`: that one takes 48 bytes for a triangle's gluings and knows no vertices,
/// while the algorithms ask at every edge whether its ends lie on the boundary. Here orientation says how
/// mates are glued, and a triangle is six integers.

#include "tetrarch/core/ids.hpp"

#include <array>
#include <vector>

namespace tetrarch::bundle {

/// One side of one triangle.
struct Side {
  int value = -1; ///< 3 * triangle + corner opposite; -1: none

  constexpr Side() = default;
  constexpr explicit Side(int index) : value(index) {}
  constexpr Side(int triangle, int corner) : value(3 * triangle + corner) {}

  constexpr bool exists() const { return value >= 0; }
  constexpr int triangle() const { return value / 3; }
  constexpr int corner() const { return value % 3; }
  /// The next side of the triangle, counterclockwise: it starts where this one ends.
  constexpr Side next() const { return corner() == 2 ? Side(value - 2) : Side(value + 1); }
  constexpr Side previous() const { return corner() == 0 ? Side(value + 2) : Side(value - 1); }
  friend constexpr bool operator==(Side, Side) = default;
};

/// The three sides of a triangle, for `for (Side s : sides_of(t))`.
constexpr std::array<Side, 3> sides_of(int triangle) {
  return {Side(triangle, 0), Side(triangle, 1), Side(triangle, 2)};
}

class Disk {
public:
  using Triangle = std::array<int, 3>;

  /// From the corners of triangles of consistent orientation, on vertices 0 .. vertices-1; sides with the
  /// same two ends are mates. Throws `InputError`, naming the triangle or vertex (counted from 0), unless
  /// this is a disk: every vertex used, every edge on one or two triangles that run along it in opposite
  /// directions, connected, with boundary, V - E + F = 1. O(n).
  Disk(int vertices, std::vector<Triangle> triangles);

  /// From gluings: the mate of each side, none on the boundary. Vertices are numbered by first corner. Throws
  /// `PreconditionError` if mates are not mutual, `InputError` unless this is a disk. O(n).
  explicit Disk(Table<Side, Side> mate);

  int triangle_count() const { return static_cast<int>(triangles_.size()); }
  int vertex_count() const { return vertices_; }
  int edge_count() const { return (3 * triangle_count() + static_cast<int>(boundary_.size())) / 2; }
  const Triangle& corners(int triangle) const { return triangles_[static_cast<std::size_t>(triangle)]; }

  int from(Side s) const { return corners(s.triangle())[s.next().corner()]; }
  int to(Side s) const { return corners(s.triangle())[s.previous().corner()]; }
  /// The corner that the side lies opposite.
  int apex(Side s) const { return corners(s.triangle())[s.corner()]; }
  /// The other side of the edge; none on the boundary.
  Side mate(Side s) const { return mate_[s]; }
  bool is_boundary(Side s) const { return !mate_[s].exists(); }
  /// The boundary sides in the order in which the boundary runs; the one of least number comes first.
  const std::vector<Side>& boundary() const { return boundary_; }
  /// For each vertex, whether it lies on the boundary. O(n).
  std::vector<char> boundary_vertices() const;

private:
  void name_vertices();
  void find_boundary();

  int vertices_ = 0;
  std::vector<Triangle> triangles_;
  Table<Side, Side> mate_;
  std::vector<Side> boundary_;
};

} // namespace tetrarch::bundle
