// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Discrete Ricci flow: a flat metric with prescribed boundary curvature, and the map that unrolls it.
///
///       u                 A number u(v) at each vertex scales the lengths of its edges; angles follow,
///      / \   l e^(u+v)/2  and with them the curvature of each vertex (2 pi less its angles; on the boundary
///     /   \               pi less them). Given the curvatures, the numbers are the minimum of a convex
///    v-----w              function whose second derivative is the cotangent Laplacian: Newton, not a flow.
///
/// Edges are flipped as the metric changes, so that it stays Delaunay; the new diagonal has the length that
/// Ptolemy's theorem gives it, as if the four points were on a circle. So no triangle inside breaks down, and
/// what is found depends on the metric and not on the way to it. Boundary edges stay, and where a triangle
/// there breaks down its angles are taken as 0, 0, pi: the function is convex still, but such a minimum is no
/// metric. This happens on loops of few edges, if the mesh is too coarse for the prescribed curvature.
///
/// Scaling by Moebius maps of the plane is exact: what is a disk with round holes, or a rectangle, up to such
/// a map is found up to rounding. Elsewhere maps converge with the mesh. Sources: Luo, "Combinatorial Yamabe
/// flow on surfaces" (2004); Springborn, Schroeder and Pinkall, "Conformal equivalence of triangle meshes"
/// (2008); Bobenko, Pinkall and Springborn, "Discrete conformal maps and ideal hyperbolic polyhedra" (2015);
/// Gu, Luo, Sun and Wu, "A discrete uniformization theorem for polyhedral surfaces" (2018); Yin, section
/// 3.4.2.

#include "tetrarch/slit/circular_map.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::slit {

struct RicciOptions {
  double tolerance = 1e-10; ///< of the curvature at each vertex, in radians
  int most_steps = 100;     ///< of Newton's method
};

struct Curvatures {
  std::vector<double> at; ///< of each vertex
  /// Of each vertex whether its number is held at 0, whatever its curvature becomes. Empty: none.
  std::vector<char> held;
  /// One vertex of each hole that is to be inscribed in a circle. Its curvatures are not read from `at`:
  /// where two sides under arcs a and b meet, it is -(a + b)/2.
  std::vector<int> round_holes;
};

struct ScaledMetric {
  /// With the new lengths. Edges are not those of the mesh, vertices are.
  surface::IntrinsicTriangulation triangulation;
  std::vector<double> log_scale; ///< u, of each vertex; 0 at vertex 0 where none is held
  /// The greatest deviation from a curvature that was asked for; vertex 0 is left out where none is held, as
  /// Gauss and Bonnet see to it.
  double residual = 0;
  int steps = 0;
  bool found = false; ///< whether the residual is below the tolerance and no triangle has broken down
};

/// Throws InputError where triangles have no area, unless the numbers are finite, and where no vertex is
/// held, unless all curvatures add up to 2 pi times the Euler number (a round hole to -2 pi);
/// PreconditionError unless the mesh is oriented and there is a number for each vertex. Such a metric need
/// not exist: check `found`. One sparse factorization a step, in practice less than 10 steps.
[[nodiscard]] ScaledMetric scaled_metric(const surface::TriangleMesh& mesh, const Curvatures& curvatures,
                                         const RicciOptions& options = {}, const Progress& progress = {});

/// A metric unrolled in the plane, triangle by triangle, with cuts between triangles where a walk around a
/// hole or a vertex changes the place.
struct Layout {
  std::vector<std::complex<double>> corner;   ///< corner c of triangle t is at 3 t + c
  std::vector<std::complex<double>> position; ///< of each vertex: that of one of its corners
  double gap = 0; ///< greatest distance between the two places of the end of an edge
};

/// The first side of triangle 0 starts at 0 and runs along the positive real axis. O(n).
Layout laid_out(const surface::IntrinsicTriangulation& metric);

/// The motion of the plane that a walk once around a loop makes, with the surface to the left: a turn by
/// `rotation`, in (-pi, pi], and a move of the start vertex by `translation`, as seen from a start at 0 along
/// the positive real axis.
struct Holonomy {
  double rotation = 0;
  std::complex<double> translation;
};

/// Of the loop through a vertex. Throws InputError if the vertex is not on the boundary. O(n).
Holonomy holonomy(const surface::IntrinsicTriangulation& metric, int vertex);

struct RicciCircles {
  /// The circles are fitted to the vertices, whose distance from them is `circularity`; there are no curves.
  /// `domain.found` is that of the metric, `domain.rounds` the steps.
  CircularMap map;
  double residual = 0;
};

/// The second route to `circular_map`, with the same loops and normalization; where there is one loop,
/// `inner` is -1, and it is to `disk_map` with the `innermost_vertex` as its center. Throws InputError unless
/// the mesh is an oriented sphere with holes, these are two of its loops, and the outer one has a vertex with
/// no neighbors on the boundary but the two next to it. Check `map.domain.found`. Cost as above.
///
/// A vertex of the outer loop goes to infinity, so that the loop becomes a straight line: the problem is then
/// convex, which it is not for the curvature of a circle. A Moebius map leads back.
[[nodiscard]] RicciCircles ricci_circles(const surface::TriangleMesh& mesh, int outer, int inner,
                                         const RicciOptions& options = {}, const Progress& progress = {});

/// A corner on the side of a loop that starts at `vertex`, this part of its length further: the right angle
/// is shared out, (1 - part) to this vertex and `part` to the next.
struct LoopCorner {
  int vertex = -1;
  double part = 0;
};

struct RicciRectangles {
  std::vector<std::complex<double>> position; ///< of each vertex
  double height = 0;                          ///< of the outer rectangle; its width is 1
  /// Of each loop, in the order of the hints.
  std::vector<std::array<LoopCorner, 4>> corners;
  /// The greatest over all holes of how far one is moved in going round, in terms of its circumference, and
  /// of the angle between its sides and those of the outer rectangle.
  double holonomy = 0;
  double residual = 0; ///< of curvatures
  int rounds = 0;      ///< in which corners were moved
  bool found = false;
};

struct RectangleOptions {
  RicciOptions metric;
  double tolerance = 1e-9; ///< of the holonomy
  int most_rounds = 40;
};

/// The rectangle with rectangular holes. `hints[k]` are vertices, four of each loop, the outer loop first;
/// the outer corners stay there, from 0 by 1 to 1 + i height and i height, the first hint's being 0. A
/// rectangle's worth of right angles does not close a hole, nor does it make it parallel to the outer one:
/// three equations for the four corners of each hole, which are moved along their loops by least steps. One
/// parameter for each hole is free, so what is found is the solution near the hints; where they are far off,
/// by half a side, it may not be. Throws InputError unless the mesh is an oriented sphere with holes and each
/// loop has its four vertices, no two of them neighbors on it. Check `found`. Some 5 rounds, each a metric
/// and four more right-hand sides for each hole.
[[nodiscard]] RicciRectangles ricci_rectangles(const surface::TriangleMesh& mesh,
                                               const std::vector<std::array<int, 4>>& hints,
                                               const RectangleOptions& options = {},
                                               const Progress& progress = {});

/// Four vertices of a loop to be the corners: the sharpest, if four of them turn by an eighth of a turn at
/// least and no two are neighbors, else those that part its length into quarters. In their order along the
/// loop. Throws InputError if the loop has fewer than 8 edges. O(n).
[[nodiscard]] std::array<int, 4> corners_of(const surface::TriangleMesh& mesh,
                                            const surface::BoundaryLoop& loop);

/// Hints for all loops from the corners of the outer one: in the rectangle with round holes, the vertices of
/// each hole that lie farthest along the diagonals. Throws InputError as `ricci_rectangles`, or if there is
/// no such rectangle. One metric.
[[nodiscard]] std::vector<std::array<int, 4>> rectangle_hints(const surface::TriangleMesh& mesh,
                                                              const std::array<int, 4>& outer,
                                                              const RicciOptions& options = {},
                                                              const Progress& progress = {});

} // namespace tetrarch::slit
