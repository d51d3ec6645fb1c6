// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangulated surface: the corners of its triangles, and which sides are *mates*.
///
/// An interior edge is a pair of mates; a boundary edge is one side without a mate. Mates run in opposite
/// directions if their triangles are oriented alike. Otherwise they are *turned*: they run in the same
/// direction, and crossing the edge exchanges left and right. Every non-orientable surface has turned mates.
/// Two triangles may share several edges or vertices, a triangle may be glued to itself, and an edge may be a
/// loop: covering disks of surfaces and triangulations with one vertex have all of these.
///
/// Why not OpenMesh, CGAL or the like: all ask for simplicial, oriented meshes; here a cut is a mate taken
/// away, so that a surface and its covering disk have the same triangles and sides. And a triangle is six
/// integers, of which walks touch two or three.

#include "tetrarch/core/ids.hpp"
#include "tetrarch/core/surface.hpp"
#include "tetrarch/surface/side.hpp"

#include <array>
#include <vector>

namespace tetrarch::surface {

/// Triangles by their vertices, with their mates.
class Surface {
public:
  using Triangle = std::array<int, 3>;

  Surface() = default;
  /// From the corners of triangles, on vertices 0 .. vertices-1; sides with the same two ends are mates.
  /// Throws `InputError`, naming the triangle or vertex (counted from 0), unless all indices are in range,
  /// the corners of a triangle differ, every vertex is used, and no edge is on three triangles. There is no
  /// search for vertices at which several fans of triangles meet. O(n).
  Surface(int vertices, std::vector<Triangle> triangles);

  /// From gluings: the mate of each side, none on the boundary; and which sides have a turned mate (empty:
  /// none). Vertices are numbered by first corner. Throws `PreconditionError` if mates are not mutual. O(n).
  explicit Surface(const Table<Side, Side>& mate, std::vector<char> turned = {});

  /// From both: corners on vertices 0 .. vertices-1 and the mate of each side, none turned. A triangle may
  /// have a corner twice. Throws `PreconditionError` unless mates are mutual and join the same two vertices,
  /// one running against the other. O(n).
  Surface(int vertices, std::vector<Triangle> triangles, const Table<Side, Side>& mate);

  int triangle_count() const { return static_cast<int>(triangles_.size()); }
  int side_count() const { return 3 * triangle_count(); }
  int vertex_count() const { return vertices_; }
  /// O(n).
  int edge_count() const;
  const Triangle& corners(int triangle) const { return triangles_[static_cast<std::size_t>(triangle)]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  int from(Side s) const { return corners(s.triangle())[s.next().corner()]; }
  int to(Side s) const { return corners(s.triangle())[s.previous().corner()]; }
  /// The corner that the side lies opposite.
  int apex(Side s) const { return corners(s.triangle())[s.corner()]; }
  int vertex(SideEnd e) const { return corners(e.side.triangle())[e.corner()]; }
  /// The other side of the edge; none on the boundary.
  Side mate(Side s) const { return mate_[static_cast<std::size_t>(s.value)]; }
  bool is_boundary(Side s) const { return !mate(s).exists(); }
  /// Whether side s and its mate run in the same direction.
  bool is_turned(Side s) const { return !turned_.empty() && turned_[static_cast<std::size_t>(s.value)] != 0; }
  /// The same end of the edge, seen from the mate. The side must have one.
  SideEnd across(SideEnd e) const { return {mate(e.side), is_turned(e.side) ? e.at_start : !e.at_start}; }

  /// Takes the gluing of this edge away. Vertices keep their names.
  void unglue(Side s);

  /// Turns triangles over, those for which `over` is not 0: corners 1 and 2 are exchanged, and with them
  /// sides 1 and 2. O(n).
  void turn(const std::vector<char>& over);

  /// Puts a vertex on the edge of side s and joins it with the apexes. The halves of a side keep its mate and
  /// direction; s becomes its first half (unless its mate is the side before it: then that half is in a new
  /// triangle). Returns the new vertex. `carried`, a number for each side, grows: both halves of a side
  /// inherit its number, new sides get 0. `origin`, a number for each triangle, likewise. O(1).
  int split_edge(Side s, std::vector<int>* carried = nullptr, std::vector<int>* origin = nullptr);
  /// Puts a vertex into a triangle and joins it with the corners. As above. O(1).
  int split_face(int triangle, std::vector<int>* carried = nullptr, std::vector<int>* origin = nullptr);

  /// Replaces an edge between two different triangles, whose mates are not turned, by the other diagonal of
  /// the quadrilateral. Side s and its mate become the sides that its next sides were. `carried` as above.
  /// O(1).
  void flip_edge(Side s, std::vector<int>* carried = nullptr);

private:
  void name_vertices();
  void glue(Side s, Side m, bool turned);
  int add_triangle(Triangle corners, std::vector<int>* carried, std::vector<int>* origin, int like);
  void move_side(Side from, Side to, std::vector<int>* carried);
  Side halve(Side s, int middle, std::vector<int>* carried, std::vector<int>* origin);

  int vertices_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<Side> mate_;   ///< of each side
  std::vector<char> turned_; ///< of each side; empty: no mate is turned
};

/// The ends around the vertex of `e`, one for each triangle there, from a boundary side on if there is one.
/// O(result).
std::vector<SideEnd> fan(const Surface& surface, SideEnd e);

/// The side that follows boundary side `e.side` on the boundary beyond its end `e`, seen from the shared
/// vertex.
SideEnd next_on_boundary(const Surface& surface, SideEnd e);

/// Each boundary curve once, as the ends at which a walk enters its sides. Curves and their first sides come
/// in the order of the sides; if no mates are turned, the surface lies to the left. O(n).
std::vector<std::vector<SideEnd>> boundary_curves(const Surface& surface);

/// The connected parts: `of[t]` is numbered by first triangle. O(n).
struct Parts {
  int count = 0;
  std::vector<int> of;
};
Parts parts(const Surface& surface);

/// One part of a surface, and the numbers of its triangles in the whole.
struct Part {
  Surface surface;
  std::vector<int> triangles;
  Side in_whole(Side s) const { return {triangles[static_cast<std::size_t>(s.triangle())], s.corner()}; }
};
/// Part k is the k-th of `parts`, its triangles in their order. O(n).
std::vector<Part> split(const Surface& surface, const Parts& parts);

/// For each triangle +1 or -1 such that mates are turned exactly where the signs differ; the first triangle
/// of each part gets +1. Empty if the surface is not orientable. O(n).
std::vector<int> orientation(const Surface& surface);

/// The type of a connected surface. Throws `PreconditionError` if it is not connected. Where the vertices are
/// given (not found from gluings), a vertex with several fans makes the type wrong. O(n).
SurfaceType type_of(const Surface& surface);

} // namespace tetrarch::surface
