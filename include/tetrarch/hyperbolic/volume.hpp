// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The volume of a tetrahedron, with its error.
///
/// Ushijima's formula ("A volume formula for generalised hyperbolic tetrahedra", 2006) is a difference of
/// sixteen dilogarithms. A hyperbolic tetrahedron has a Gram matrix of angles with negative determinant; then
/// every argument has modulus one, and the imaginary part of the dilogarithm there is Clausen's function of
/// the argument's angle: the volume is a signed sum of sixteen real numbers. Angles near pi are kept by their
/// rests, and what cancels near a flat tetrahedron is left out of the sums from the start (src:
/// angle_data.hpp, clausen_sum.cpp): from exact angles the result errs by less than 1e-14, and by less than
/// 1e-10 of itself, down to 1e-10 from flat. The bounds are sums of first-order rounding, the library's
/// functions taken to err by two units in the last place, and of second-order terms. They hold whichever way
/// is rounded, and mostly exceed what happens by far.

#include "tetrarch/hyperbolic/tetrahedron.hpp"

namespace tetrarch::hyperbolic {

/// Clausen's function Cl_2(x) = sum over n >= 1 of sin(n x) / n^2, for any real x, to the full precision of
/// the scalar: odd, of period 2 pi, largest at pi/3 (1.0149...).
template <class Scalar>
Scalar clausen(const Scalar& x);

/// A number with a bound of its error: the truth lies within [value - error, value + error].
template <class Scalar>
struct Estimate {
  Scalar value;
  Scalar error;
};

/// The volume of the (partially truncated) tetrahedron with these lengths, taken as exact, for every mixture
/// of vertex types; nothing where there is none. A tetrahedron too flat for the scalar's digits of its
/// determinant is computed in 60 digits.
template <class Scalar>
std::optional<Estimate<Scalar>> volume(const SixNumbers<Scalar>& lengths, const VertexTypes& types);

/// The volume from dihedral angles (order 01,02,03,12,13,23) alone, taken as exact. Angles of no hyperbolic
/// tetrahedron (determinant >= 0, for instance the angles 0 and pi of a flat one) give 0. Errs by about
/// 1e-14; near pi the angles' own digits are what limits it.
template <class Scalar>
Scalar volume(const SixNumbers<Scalar>& angles);

} // namespace tetrarch::hyperbolic
