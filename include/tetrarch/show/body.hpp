// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A picture in hyperbolic space, before the choice of a model: one body, and many copies of it.
///
/// A body is made of *patches* (convex polygons of a plane or of a horosphere) and *arcs* (pieces of
/// geodesics or of horocycles). A fundamental domain becomes a body with eight patches for each tetrahedron,
/// its copies the isometries of a piece of the universal cover; an unrolled boundary component a flat body.
/// In a model patches and arcs are curved: in_model.hpp makes scenes and drawings of bodies, page.hpp a page.

#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/embed/cover.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::show {

using Vector4 = embed::Vector4<double>;
using Matrix4 = embed::Matrix4<double>;

struct Patch {
  enum class Kind : std::uint8_t { face, boundary, cusp };
  Kind kind = Kind::face;
  std::vector<Vector4> corners; ///< counterclockwise from outside
  /// Per side, from corner k to corner k+1: the horosphere in which it is a horocycle, or 0 for a geodesic.
  std::vector<Vector4> cusps;
  Vector4 normal{}; ///< outward, of the plane; of a cusp's patch the horosphere's vector
  int tet = 0;
  int number = 0;     ///< face class; of kind boundary or cusp: the vertex class
  bool inner = false; ///< the same copy lies on the other side
};

struct Arc {
  Vector4 from{};
  Vector4 to{};
  Vector4 cusp{};   ///< the horosphere of a horocycle, or 0
  bool edge = true; ///< an edge of a tetrahedron; else a side of a truncation
  int tet = 0;
  int number = 0;     ///< edge class; else vertex class
  bool inner = false; ///< drawn by another tetrahedron of the same copy too
};

/// Preferences for looking at a body.
enum class View : std::uint8_t { space, vertical, horizontal };

struct Body {
  std::string name;
  View view = View::space;
  std::vector<Patch> patches;
  std::vector<Arc> arcs;
  std::vector<int> parent;     ///< the tree that joins the tetrahedra (or triangles); -1: root
  std::vector<Vector4> middle; ///< of each tetrahedron (or triangle)
  Matrix4 half_space{};        ///< comes before the half space model; the ball models show the body as it is
  std::vector<Matrix4> copies; ///< the first is the identity
  std::vector<int> length;     ///< word length per copy
};

/// The domain and its copies.
Body body_of(const Triangulation& tri, const Skeleton& skeleton, const embed::Domain<double>& domain,
             const embed::Piece& piece);
/// Keeps the `count` copies whose base points are nearest to that of the first copy, nearest first.
void keep_nearest(Body& body, std::size_t count);

/// A boundary component and its copies (a piece of the lift's group).
Body body_of(const Skeleton& skeleton, const embed::BoundaryLift& lift, const embed::Piece& piece);

} // namespace tetrarch::show
