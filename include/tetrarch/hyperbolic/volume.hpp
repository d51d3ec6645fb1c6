// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The volume of a tetrahedron from its dihedral angles.
///
/// Ushijima's formula ("A volume formula for generalised hyperbolic tetrahedra", 2006) is a difference of
/// sixteen dilogarithms. A hyperbolic tetrahedron has a Gram matrix of angles with negative determinant; then
/// every argument has modulus one, and the imaginary part of the dilogarithm there is Clausen's function of
/// the argument's angle: the volume is a signed sum of sixteen real numbers.

#include "tetrarch/hyperbolic/tetrahedron.hpp"

namespace tetrarch::hyperbolic {

/// Clausen's function Cl_2(x) = sum over n >= 1 of sin(n x) / n^2, for any real x, to the full precision of
/// the scalar: odd, of period 2 pi, largest at pi/3 (1.0149...).
template <class Scalar>
Scalar clausen(const Scalar& x);

/// The volume of the (partially truncated) tetrahedron with these dihedral angles (order 01,02,03,12,13,23),
/// for every mixture of vertex types. Angles of no hyperbolic tetrahedron (determinant >= 0, for instance the
/// angles 0 and pi of a flat one) give 0.
template <class Scalar>
Scalar volume(const SixNumbers<Scalar>& angles);

/// The two numbers z-, z+ of Ushijima's formula, as (real, imaginary); of modulus one. For the tests.
template <class Scalar>
std::array<std::array<Scalar, 2>, 2> ushijima_roots(const SixNumbers<Scalar>& angles);

} // namespace tetrarch::hyperbolic
