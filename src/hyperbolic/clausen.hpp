// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Clausen's function for sums of it: the argument is a whole number of half turns and a rest, so that rests
/// near 0 keep all their digits, and every value comes with a bound of its error.

namespace tetrarch::hyperbolic {

template <class Scalar>
struct ClausenTerm {
  Scalar value;    ///< near Cl(half_turns pi + x)
  Scalar error;    ///< of `value`, if x errs by no more than what was said
  Scalar slope;    ///< no less than |Cl'| within the error of x
  Scalar distance; ///< of the argument from the nearest whole turn, where Cl has its vertical tangents
};

/// `x_error` bounds the rounding of x. Series of the powers of the distance r from a whole turn (up to 2
/// pi/3) or of the distance from half a turn beyond it; the evaluation errs by less than 6 (r + |r log r|) or
/// 4 times the distance, in units of the last place's half; the library's logarithm may err by two of them.
template <class Scalar>
ClausenTerm<Scalar> clausen_term(int half_turns, const Scalar& x, const Scalar& x_error);

} // namespace tetrarch::hyperbolic
