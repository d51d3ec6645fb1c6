// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangulation whose tetrahedra carry the inner products of their vertex vectors.
///
/// Vertex vectors live in R^{3,1}: of norm +1 where the vertex is hyperideal (its polar plane truncates), 0
/// where it is ideal (a chosen horosphere fixes the length). The Gram matrix of a tetrahedron holds
/// everything that the canonical decomposition asks: how the neighbour across a face lies (`Across`), and
/// what a new edge measures. Inner products ride along with moves, so no structure is solved between them.
/// Source: Epstein-Penner 1988, Kojima 1990; tilts by Weeks 1993, Ushijima 2002.

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/moves/ball.hpp"
#include "tetrarch/numeric/matrix4.hpp"

#include <array>
#include <vector>

namespace tetrarch::canonical {

/// Symmetric, entry (i, j) is the inner product of vertex vectors i and j.
template <class Scalar>
using Gram = numeric::Matrix4<Scalar>;

template <class Scalar>
struct Decorated {
  Triangulation tri;
  std::vector<Gram<Scalar>> gram; ///< by tetrahedron
  /// By tetrahedron: its four vectors lie in one hyperplane through the origin. Such a tetrahedron has no
  /// volume and only passes by (flips.hpp). Empty: none is flat.
  std::vector<bool> flat;
  bool is_flat(int tet) const { return !flat.empty() && flat[tet]; }
};

/// Small enough for every cusp known to us (the cells of 41 test structures were constant up to area 2).
inline constexpr double cusp_area = 0.05;

/// The inner products of a solved structure, every cusp with a cross-section of area `cusp_area`. `skeleton`
/// is that of `tri`. O(n).
template <class Scalar>
Decorated<Scalar> decorate(const Triangulation& tri, const Skeleton& skeleton,
                           const hyperbolic::Metric<Scalar>& lengths);
/// The edge lengths that the inner products tell, for the skeleton of m.tri. Horospheres are moved until
/// lengths are about 0, as if all tetrahedra were regular: lengths far from 0 are taken for running off.
/// O(n).
hyperbolic::Metric<double> edge_lengths(Decorated<double> m, const Skeleton& skeleton);

/// How the neighbour's far vertex v' lies, in the basis of this tetrahedron's vertices: v' = sum of a[j] v_j.
/// The face is convex where `tilt` = sum a[j] - 1 is positive, flat where it is zero, concave where it is
/// negative.
template <class Scalar>
struct Across {
  std::array<Scalar, 4> a;
  Scalar tilt;
};

/// Looks across an interior face from a tetrahedron that is not flat. Takes for granted that the two
/// tetrahedra lie on different sides of it, which fixes the sign of a[f.face]; it is 0 where the neighbour is
/// flat. O(1).
template <class Scalar>
Across<Scalar> look_across(const Decorated<Scalar>& m, TetFace f);

/// <v_f, v'>: the inner product that an edge from vertex f.face to the neighbour's far vertex would have.
template <class Scalar>
Scalar product_across(const Decorated<Scalar>& m, TetFace f, const Across<Scalar>& across);

/// sqrt(-det W): the volume of the simplex that the four vectors span with the origin, times 24; 0 of a flat
/// tetrahedron. O(1).
template <class Scalar>
Scalar cone_volume(const Decorated<Scalar>& m, int tet);

/// Makes the move; the new tetrahedra's inner products come from the old ones, that of the new edge between
/// corners p and q is `product` (ignored where p == q: the move makes no edge). The new tetrahedra are the
/// last ones, in the order of the filling, and not marked as flat. O(n).
template <class Scalar>
Decorated<Scalar> move(const Decorated<Scalar>& m, const moves::Ball& ball, int p, int q,
                       const Scalar& product);

/// Scales the vectors of every cusp such that its cross-section has the given area. `vertex` numbers the
/// vertex classes per t-vertex (4 t + v); only classes whose vectors have norm 0 are touched. O(n).
template <class Scalar>
void set_cusp_areas(Decorated<Scalar>& m, const std::vector<int>& vertex, int vertex_count,
                    const Scalar& area);

} // namespace tetrarch::canonical
