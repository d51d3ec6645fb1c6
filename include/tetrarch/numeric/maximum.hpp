// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>

namespace tetrarch::numeric {

/// The greater one, and not a number if either is none: `maximum` of IEEE 754-2019. For errors, residuals and
/// whatever else is small when all is well: std::max and std::fmax drop what is no number, so that what failed
/// altogether would pass for exact.
template <class Scalar>
Scalar maximum(const Scalar& a, const Scalar& b) {
  using std::isnan;
  return a > b || isnan(a) ? a : b;
}

} // namespace tetrarch::numeric
