// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/real50.hpp"

namespace tetrarch::numeric {

template <>
Real50 pi<Real50>() {
  static const Real50 value = acos(Real50(-1));
  return value;
}

} // namespace tetrarch::numeric
