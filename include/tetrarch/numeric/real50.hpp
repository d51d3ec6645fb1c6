// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// `Real50`: 60 decimal digits of working precision, for results that are good to 50.
///
/// The limbs live in the object itself, so that no arithmetic allocates, and expression templates are off:
/// the sums here are short, and what the formula says is what is computed.

#include "tetrarch/numeric/scalar.hpp"

#include <boost/multiprecision/mpfr.hpp>

namespace tetrarch::numeric {

using Real50 = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

template <>
Real50 pi<Real50>();

} // namespace tetrarch::numeric
