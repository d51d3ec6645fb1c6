// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The shape of a cusp: what a cusp's cross-section looks like, whichever horosphere cuts it off.
///
/// Lengths of edges that run into a cusp are measured to a horosphere, which may be any of those around the
/// cusp. The cross-section's *shape* is the same for all of them: unrolled in the plane, its triangles repeat
/// along a lattice, spanned by a shortest translation a and a shortest one b that is not along a,
///
///        .-----------.-----------.
///       /           /           /        shape = b / a, a complex number with |shape| >= 1,
///    b /           /           /         -1/2 < Re shape <= 1/2 (Re >= 0 where |shape| = 1) and
///     .-----------.-----------.          Im shape > 0, seen from the cusp; mirrored, minus its conjugate
///           a
///
/// A Klein bottle has the shape of the torus that covers it twice, a rectangle or a rhombus.

#include "tetrarch/hyperbolic/metric.hpp"

#include <complex>
#include <vector>

namespace tetrarch::hyperbolic {

/// The side of the horosphere's triangle at ideal vertex i that lies in face ijk, squared: the squared
/// distance in R^{3,1} of its ends, read from the Gram matrix.
template <class Scalar>
Scalar squared_horosphere_side(const numeric::Matrix4<Scalar>& w, int i, int j, int k) {
  return w[j][j] / (w[i][j] * w[i][j]) + w[k][k] / (w[i][k] * w[i][k]) - 2 * w[j][k] / (w[i][j] * w[i][k]);
}

/// A cusp of a structure.
struct Cusp {
  VertexId vertex;
  bool orientable = true;     ///< a torus; else a Klein bottle
  std::complex<double> shape; ///< of the torus, or of the torus that covers the Klein bottle twice
  double area = 0;            ///< of the cross-section that the lengths are measured to
  /// The largest distance of a translation of the unrolled triangles from the lattice, in lengths of a.
  double residual = 0;
};

/// One for each vertex class whose link is a torus or a Klein bottle. `lengths` are those of a structure;
/// where they are none, the residual tells. On an oriented manifold the shapes of all cusps are seen in the
/// orientation of tetrahedron 0. Throws PreconditionError if the skeleton is stale or has a link that no
/// hyperbolic vertex has. O(n log n).
std::vector<Cusp> cusps(const Triangulation& tri, const Skeleton& skeleton, const Metric<double>& lengths);

/// The shape of one cusp in another scalar.
template <class Scalar>
struct CuspShape {
  VertexId vertex;
  Scalar real{}, imaginary{};
};

/// The shapes alone, in the same order; in balls they are proved if the lengths hold those of a structure.
/// The translations a and b span the lattice for sure. That they are the shortest is decided in doubles:
/// where two choices are equally good to ten digits the shape may be that of the other one. Balls grow while
/// triangles are unrolled: for up to seven tetrahedra 13 to 32 bits are lost. For double and balls; O(n log
/// n).
template <class Scalar>
std::vector<CuspShape<Scalar>> cusp_shapes(const Triangulation& tri, const Skeleton& skeleton,
                                           const Metric<Scalar>& lengths);

} // namespace tetrarch::hyperbolic
