// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The one list of scalars for which templates are instantiated: `TETRARCH_FOR_EACH_SCALAR(M)` says M(double)
/// and M(numeric::Real50). A third scalar is one more word here. `TETRARCH_FOR_EACH_FORMULA(M)` adds balls,
/// for formulas that proofs are made of: they take every comparison to be certain (ball.hpp).

#include "tetrarch/numeric/ball.hpp"
#include "tetrarch/numeric/real50.hpp"

#define TETRARCH_FOR_EACH_SCALAR(M) M(double) M(::tetrarch::numeric::Real50)
#define TETRARCH_FOR_EACH_FORMULA(M) TETRARCH_FOR_EACH_SCALAR(M) M(::tetrarch::numeric::Ball)
