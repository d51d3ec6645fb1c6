// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The number types that formulas are computed with.
///
/// A formula that is a template over its scalar is instantiated for `double` and for `Real50` (60 decimal
/// digits by MPFR, see real50.hpp, which is heavy and therefore included only by those who compute with it).
/// The list of scalars is instantiate.hpp.

#include <limits>
#include <numbers>

namespace tetrarch::numeric {

/// Half a turn, to the full precision of the scalar.
template <class Scalar>
Scalar pi();
template <>
inline double pi<double>() {
  return std::numbers::pi;
}

/// What bounds of rounding errors are counted in. Half a unit in the last place of 1: the greatest relative
/// error of one operation.
template <class Scalar>
Scalar unit() {
  return std::numeric_limits<Scalar>::epsilon() / 2;
}

/// Gives back what MPFR caches for the calling thread (digits of pi and the like). A thread that computed
/// with Real50 calls it last, or the cache is lost with the thread.
void free_thread_cache();

} // namespace tetrarch::numeric
