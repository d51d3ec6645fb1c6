// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The number types that the hyperbolic rooms compute with.
///
/// Every formula is a template over its scalar and is instantiated for `double` and for `Real50` (60 decimal
/// digits by MPFR, see real50.hpp, which is heavy and therefore included only by those who compute with it).
/// The definitions stand in src/hyperbolic; a third scalar needs one line of instantiation in each file
/// there.

#include <numbers>

namespace tetrarch::hyperbolic {

/// Half a turn, to the full precision of the scalar.
template <class Scalar>
Scalar pi();
template <>
inline double pi<double>() {
  return std::numbers::pi;
}

} // namespace tetrarch::hyperbolic
