// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/real50.hpp"

namespace tetrarch::numeric {

template <>
Real50 pi<Real50>() {
  static const Real50 value = acos(Real50(-1));
  return value;
}

void free_thread_cache() {
  mpfr_free_cache();
}

} // namespace tetrarch::numeric
