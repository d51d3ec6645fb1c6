// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A circle bundle over a triangulated surface, as a triangulation.
///
///      T2 ----- T1      Over each triangle of the surface stands a ring of N prisms, N being the
///       | \   / |       *resolution* of the fibers. A prism is cut into three tetrahedra as its cutting
///       |  T0   |       pattern says: order its corners r0, r1, r2 so that the diagonals run from the
///       |   |   |       bottom of the earlier to the top of the later corner; then, from below,
///      B2 --|-- B1      B0 B1 B2 T2, B0 B1 T1 T2, B0 T0 T1 T2.
///         \ | /
///           B0
///
/// Over an edge, level j over an end of side s is glued to level j + `shift` over the same end of its mate,
/// or to level -j + shift where mates are turned. The shift may change by t = 0, +1 or -1 along the edge, its
/// *twist*; what is a base edge on one bank is then a diagonal on the other:
///
///        mates opposite   t = 0: values +1,-1 or -1,+1    t = +1: -1,-1    t = -1: +1,+1
///        mates turned     t = 0: the same                 t = +1: +1,+1    t = -1: -1,-1
///
/// If the shifts cancel around every vertex (mod N), each fiber is a circle of N edges, and the bundle has
/// Euler number e = sum of t over turned edges minus sum of t over the others, divided by N. The unit tangent
/// bundle is the one with e = chi; by it the total space is oriented. With boundary there is no Euler number.
/// Source: Yin, Definitions 6.2.1 to 6.3.1 and 7.2.1 to 7.3.1, which are special cases.

#include "tetrarch/bundle/cutting_pattern.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tetrarch::bundle {

/// How the fibers over the two banks of an edge are glued: the shifts at the start and the end of a side.
struct Shift {
  int start = 0;
  int stop = 0;
  int twist() const { return stop - start; }
  int at(bool at_start) const { return at_start ? start : stop; }
  friend bool operator==(Shift, Shift) = default;
};

/// The shift of the mate of a side with this shift: the inverse.
Shift inverse(Shift shift, bool turned);

/// The data from which a bundle is made.
struct Recipe {
  surface::Surface base;
  int fiber = 1;                  ///< N >= 1, the resolution
  std::vector<Shift> shift;       ///< of each side; mates have inverse ones
  std::vector<std::int8_t> value; ///< of each side, as in a cutting pattern
};

/// The bundle over `base`, and how its tetrahedra lie over it.
struct CircleBundle {
  surface::Surface base;
  int fiber = 1;
  /// 3 * fiber * (triangles of the base) tetrahedra: number 3 * (fiber * t + j) + k is the k-th from below in
  /// the prism of level j over triangle t.
  Triangulation total;
  /// Of each triangle, its corners in the order r0, r1, r2.
  std::vector<std::array<std::uint8_t, 3>> order;

  /// The projection: the triangle below a tetrahedron, the corner of it below a vertex.
  int triangle(int tet) const { return tet / (3 * fiber); }
  int corner(TetVertex v) const;
  /// The level of the vertex over its triangle, 0 to N; N is 0 again.
  int level(TetVertex v) const;
};

/// Glues the prisms. Throws `PreconditionError` if a triangle has three equal values, or if values and shifts
/// do not fit. Vertices are not checked here: see proof.hpp. O(tetrahedra).
CircleBundle assemble(Recipe recipe, const Progress& progress = {});

/// Peak memory in bytes for planning, assembling, proving and describing a bundle, as measured on 57,000 to
/// 1,800,000 tetrahedra over 900 to 19,000 triangles (within 11 %). Of few triangles under long fibers it
/// takes up to a quarter more.
inline double bundle_bytes(double tetrahedra, double triangles) {
  constexpr double always = 5e6;
  return always + 287 * tetrahedra + 1350 * triangles;
}

} // namespace tetrarch::bundle
