// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The one list of scalars for which templates are instantiated: `TETRARCH_FOR_EACH_SCALAR(M)` says M(double)
/// and M(numeric::Real50). A third scalar is one more word here.

#include "tetrarch/numeric/real50.hpp"

#define TETRARCH_FOR_EACH_SCALAR(M) M(double) M(::tetrarch::numeric::Real50)
