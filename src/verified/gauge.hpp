// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What moves without changing the structure, and what it says of curvatures: horospheres, and points.
///
/// A finite vertex is any point of the manifold, so three dimensions of lengths belong to one structure. Its
/// link is a sphere of spherical triangles with cone points: an end of edge e there is a cone point of angle
/// 2 pi - K_e. Three lengths for each finite vertex are held fixed, and the equations of these edges dropped.
/// Why do they follow? Say that all other curvatures vanish, so that the ends of dropped edges are the only
/// cone points. Lay some triangles of the link out in the unit sphere, glued along a tree: a disk, in which
/// every end has a corner, at x in R^3.
///
///        x2       The loop that runs from a base point within the disk to a corner, around the cone point,
///       /  \      and back turns the sphere by -K around x. Arcs to different corners can be drawn without
///  x1--o----x3    a crossing. So the loops, one after the other in the order of the corners, are contractible
///       \  /      in the sphere without its cone points, and the product of the turns is the identity.
///        x4
///
/// As unit quaternions the turns are exp(-K x / 2), and their product is 1 or -1. Let a be the sum of |K| / 2
/// over the ends. If a <= 1, the product differs from 1 by at most e^a - 1 < 2, so it is 1; and it differs
/// from 1 - (sum of K x) / 2 by at most e^a - 1 - a <= a^2. Hence at each finite vertex
///
///     | sum over ends of dropped edges of K x |  <=  2 a^2.
///
/// At a cusp the sum of K over all ends is 0 exactly. Together: M K = q for the vector K of the dropped
/// curvatures, with a square matrix M of sums of x (or numbers of ends), and |q| <= n^2 |K|^2 / 2 in the
/// greatest component, where n is the greatest number of such ends at a finite vertex. If K were not 0, then
/// 1 <= |M^-1| n^2 |K| / 2. Balls show that to be false: M is regular, and |K| is below some 1e-12.
///
/// The rows of M are also how lengths change as a point moves (with x, in the directions of the other ends),
/// so the same edges serve as fixed lengths. Source: ours; the linear part is Casson's and Schlaefli's.

#include "tetrarch/hyperbolic/metric.hpp"
#include "tetrarch/numeric/ball.hpp"

#include <array>
#include <vector>

namespace tetrarch::verified {

class Gauge {
public:
  Gauge(const Triangulation& tri, const Skeleton& skeleton);

  bool has_points() const { return points_ > 0; }
  /// One for each cusp, three for each finite vertex.
  int dimensions() const { return static_cast<int>(cusps_.size()) + 3 * points_; }

  /// Entry [e][d]: by how much motion d shortens edge e, for each cusp and in three directions at each point;
  /// the sum of components of x over the edge's ends. Directions mean nothing where a triangle is none.
  template <class Scalar>
  std::vector<std::vector<Scalar>> motions(const hyperbolic::Metric<Scalar>& lengths) const;

  /// Edges whose lengths fix horospheres and points, in increasing order; fewer than there are dimensions
  /// where some motion changes no length. O(E dimensions^2).
  std::vector<EdgeId> choose(const hyperbolic::Metric<double>& lengths) const;

  /// Proves that the curvatures of the `dropped` edges are 0 at all lengths in the box at which those of the
  /// others are. `curvature` holds all values on the box.
  bool dropped_vanish(const std::vector<EdgeId>& dropped, const hyperbolic::Metric<numeric::Ball>& box,
                      const hyperbolic::Metric<numeric::Ball>& curvature) const;

private:
  /// A triangle of the link, and how it is reached.
  struct Step {
    int tet;
    int vertex; ///< of the tetrahedron, at which the triangle is
    int from;   ///< number of the triangle, laid out before, that it is glued to; -1: the first
    int side;   ///< the face of that triangle's tetrahedron that is crossed
  };
  /// Its corner on the edge to vertex `towards` of the tetrahedron.
  struct Corner {
    int triangle;
    int towards;
    EdgeId edge;
  };
  /// The layout of one finite vertex: triangles in order, and a corner for each end of an edge.
  struct Point {
    std::vector<Step> steps;
    std::vector<Corner> corners;
  };

  Point lay_out(VertexId v) const;
  /// Of each triangle in the layout the directions of its corners, by vertices of its tetrahedron.
  template <class Scalar>
  std::vector<std::array<std::array<Scalar, 3>, 4>>
  directions(const Point& point, const hyperbolic::Metric<Scalar>& lengths) const;
  int most_ends(const std::vector<EdgeId>& dropped) const;

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  Table<VertexId, hyperbolic::VertexType> types_;
  std::vector<VertexId> cusps_;
  std::vector<Point> layouts_;
  int points_ = 0;
};

} // namespace tetrarch::verified
