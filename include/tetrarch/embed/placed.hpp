// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One (partially) truncated tetrahedron, put into hyperbolic space as in the dissertation's figure 4.12.
///
///        | vertex 1 above         In the upper half space the edge 01 lies on the z axis; face 3 (0,1,2) in
///        |                        the vertical plane y = 0 on the side x > 0, face 2 (0,1,3) in the vertical
///      .-+-.       . 2, in y = 0  plane at the angle theta_01 from it, on the side y > 0. The truncation at
///     /  |  \                     0 is the unit hemisphere, that at 1 the hemisphere of radius e^l: circles
///    |   0   |  radius 1          around 0 at infinity. An ideal vertex 0 has its horosphere, a finite one
///                                 its point, at height 1.
///
/// Everything else follows from the four vectors: faces are the planes through three of them, truncations the
/// polar planes of the hyperideal ones. Source: Yin, section 4.4.2.

#include "tetrarch/core/tet.hpp"
#include "tetrarch/embed/lorentz.hpp"
#include "tetrarch/hyperbolic/tetrahedron.hpp"

namespace tetrarch::embed {

using hyperbolic::SixNumbers;
using hyperbolic::VertexType;
using hyperbolic::VertexTypes;

/// The vectors of the vertices 0..3: <v,v> = 1, 0, -1 for hyperideal, ideal and finite ones.
template <class Scalar>
using VertexVectors = std::array<Vector4<Scalar>, 4>;

/// As drawn above, with hold[0], hold[1], hold[2], hold[3] in the places of 0, 1, 2, 3; the result is indexed
/// by the tetrahedron's own numbers. Positively handed in the models iff `hold` is even. Throws
/// PreconditionError where no such tetrahedron exists.
template <class Scalar>
VertexVectors<Scalar> place(const SixNumbers<Scalar>& lengths, const VertexTypes& types, Perm4 hold = {});

/// The isometry that takes the base point into the middle of the tetrahedron and its axes x, y, z into
/// directions read from the vertices 0, 1, 2 in the same way for all congruent tetrahedra.
template <class Scalar>
Matrix4<Scalar> frame(const VertexVectors<Scalar>& v, const VertexTypes& types);
/// The isometry that takes the tetrahedron `from` to the congruent tetrahedron `to`.
template <class Scalar>
Matrix4<Scalar> motion(const VertexVectors<Scalar>& from, const VertexVectors<Scalar>& to,
                       const VertexTypes& types);

/// The unit normal of face f, pointing away from vertex f.
template <class Scalar>
Vector4<Scalar> face_normal(const VertexVectors<Scalar>& v, int f);

/// Where edge ij leaves vertex i: on its truncation, on its horosphere, or the vertex itself.
template <class Scalar>
Vector4<Scalar> corner(const VertexVectors<Scalar>& v, const VertexTypes& types, int i, int j);

/// The point in the middle of its twelve corners (in the sense of the centroid in R^{3,1}).
template <class Scalar>
Vector4<Scalar> center(const VertexVectors<Scalar>& v, const VertexTypes& types);

} // namespace tetrarch::embed
