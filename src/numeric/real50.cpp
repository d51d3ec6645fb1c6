// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/real50.hpp"

#include <limits>

namespace tetrarch::numeric {

namespace {

// Boost 1.74 computes each of these at its first call and notes that it did before the value stands: a second
// thread in that moment reads 0, and Newton's method never ends. Its own initializer serves numbers with
// expression templates, not these. They are called here before `main`, when there is one thread.
[[maybe_unused]] const bool limits_stand = [] {
  using Limits = std::numeric_limits<Real50>;
  return Limits::min() < Limits::max() && Limits::epsilon() < Limits::round_error() &&
         Limits::infinity() > Limits::max() && isnan(Limits::quiet_NaN());
}();

} // namespace

template <>
Real50 pi<Real50>() {
  static const Real50 value = acos(Real50(-1));
  return value;
}

} // namespace tetrarch::numeric
