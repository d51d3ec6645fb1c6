// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a ball stores. Files that call Arb include this; no public header does.

#include "tetrarch/numeric/ball.hpp"

// Arb became a part of FLINT with FLINT 3 and moved its headers.
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

namespace tetrarch::numeric {

static_assert(sizeof(Ball) == sizeof(arb_struct) && alignof(Ball) >= alignof(arb_struct));

/// The one place that knows what is stored.
struct BallAccess {
  static arb_ptr of(Ball& x) { return static_cast<arb_ptr>(static_cast<void*>(x.storage_.data())); }
  static arb_srcptr of(const Ball& x) {
    return static_cast<arb_srcptr>(static_cast<const void*>(x.storage_.data()));
  }
};

inline arb_ptr raw(Ball& x) {
  return BallAccess::of(x);
}
inline arb_srcptr raw(const Ball& x) {
  return BallAccess::of(x);
}

} // namespace tetrarch::numeric
