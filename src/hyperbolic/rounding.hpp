// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What bounds of rounding errors are counted in.

#include <limits>

namespace tetrarch::hyperbolic {

/// Half a unit in the last place of 1: the greatest relative error of one operation.
template <class Scalar>
Scalar unit() {
  return std::numeric_limits<Scalar>::epsilon() / 2;
}

} // namespace tetrarch::hyperbolic
