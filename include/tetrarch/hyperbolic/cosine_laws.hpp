// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The dissertation's own route between lengths and angles, for four hyperideal vertices: hexagons first,
/// then triangles.
///
/// Truncation turns the faces into right-angled hexagons, whose sides are alternately edges x of the
/// tetrahedron and sides y of the truncation triangles; the angles of those triangles are the dihedral
/// angles. This route serves as a witness for the one through the Gram matrix (tetrahedron.hpp), and gives
/// the sides of the triangles. Source: Yin, section 4.3.1, laws (4.1), (4.2), (4.3), figures 4.8, 4.9.

#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include <array>

namespace tetrarch::hyperbolic {

/// (4.1): the side of a hyperbolic triangle opposite `angle`; the other two angles are a and b.
template <class Scalar>
Scalar triangle_side(const Scalar& angle, const Scalar& a, const Scalar& b);
/// (4.2): the angle opposite `side`; the other two sides are a and b.
template <class Scalar>
Scalar triangle_angle(const Scalar& side, const Scalar& a, const Scalar& b);
/// (4.3): in a right-angled hexagon with alternate sides (opposite, a, b), the side opposite to `opposite`.
/// The law is its own inverse: the roles of x and y may be exchanged.
template <class Scalar>
Scalar hexagon_side(const Scalar& opposite, const Scalar& a, const Scalar& b);

/// side[i][l]: the side of the truncation triangle at vertex i that lies in face l (the diagonal is 0).
template <class Scalar>
using TriangleSides = numeric::Matrix4<Scalar>;

/// By (4.3) from positive edge lengths.
template <class Scalar>
TriangleSides<Scalar> triangle_sides_from_lengths(const SixNumbers<Scalar>& lengths);
/// By (4.1) from dihedral angles whose sum at every vertex is less than pi.
template <class Scalar>
TriangleSides<Scalar> triangle_sides_from_angles(const SixNumbers<Scalar>& angles);

/// By (4.3), then (4.2) at the first end of each edge. Where no tetrahedron exists the cosine leaves [-1, 1]
/// and the result is not a number.
template <class Scalar>
SixNumbers<Scalar> angles_by_cosine_laws(const SixNumbers<Scalar>& lengths);
/// By (4.1), then the inverse of (4.3) in one of the two faces at each edge.
template <class Scalar>
SixNumbers<Scalar> lengths_by_cosine_laws(const SixNumbers<Scalar>& angles);

} // namespace tetrarch::hyperbolic
