// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangulation whose tetrahedra carry the inner products of their vertex vectors.
///
/// Vertex vectors live in R^{3,1}: of norm +1 where the vertex is hyperideal (its polar plane truncates), 0
/// where it is ideal (a chosen horosphere fixes the length). The Gram matrix of a tetrahedron holds
/// everything that the canonical decomposition asks: how the neighbour across a face lies (`Across`), and
/// what a new edge measures. Inner products ride along with moves, so no structure is ever solved again.
/// Source: Epstein-Penner 1988, Kojima 1990; tilts by Weeks 1993, Ushijima 2002.

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/hyperbolic/matrix4.hpp"
#include "tetrarch/moves/ball.hpp"

#include <array>
#include <vector>

namespace tetrarch::canonical {

/// Symmetric, entry (i, j) is the inner product of vertex vectors i and j.
template <class Scalar>
using Gram = hyperbolic::Matrix4<Scalar>;

template <class Scalar>
struct Decorated {
  Triangulation tri;
  std::vector<Gram<Scalar>> gram; ///< by tetrahedron
};

/// How the neighbour's far vertex v' lies, in the basis of this tetrahedron's vertices: v' = sum of a[j] v_j.
/// The face is convex where `tilt` = sum a[j] - 1 is positive, flat where it is zero, concave where it is
/// negative.
template <class Scalar>
struct Across {
  std::array<Scalar, 4> a;
  Scalar tilt;
};

/// Looks across an interior face. Takes for granted that the two tetrahedra lie on different sides of it,
/// which fixes the sign of a[f.face]. O(1).
template <class Scalar>
Across<Scalar> look_across(const Decorated<Scalar>& m, TetFace f);

/// <v_f, v'>: the inner product that an edge from vertex f.face to the neighbour's far vertex would have.
template <class Scalar>
Scalar product_across(const Decorated<Scalar>& m, TetFace f, const Across<Scalar>& across);

/// Makes the move; the new tetrahedra's inner products come from the old ones, that of the new edge between
/// corners p and q is `product` (ignored where p == q: the move makes no edge). O(n).
template <class Scalar>
Decorated<Scalar> move(const Decorated<Scalar>& m, const moves::Ball& ball, int p, int q,
                       const Scalar& product);

/// Scales the vectors of every cusp such that its cross-section has the given area. `vertex` numbers the
/// vertex classes per t-vertex (4 t + v); only classes whose vectors have norm 0 are touched. O(n).
template <class Scalar>
void set_cusp_areas(Decorated<Scalar>& m, const std::vector<int>& vertex, int vertex_count,
                    const Scalar& area);

} // namespace tetrarch::canonical
