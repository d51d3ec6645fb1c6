// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The homotopy from small cone angles, where everything is hyperideal, to those that are wanted.

#include "signed_system.hpp"
#include "tetrarch/core/progress.hpp"

namespace tetrarch::hyperbolic {

struct SignedPath {
  bool arrived = false;
  SignedState state;
  double reached = 0; ///< the last divisor of angles at which the equations were solved; 1 on arrival
  int steps = 0;      ///< of Newton's method
};

/// `divided[e]`: whether the angle at edge class e is divided by the parameter, which comes down from `first`
/// to
/// 1. At most `most_steps` steps.
SignedPath follow_path(const Problem& problem, const SignedSystem& system, const std::vector<bool>& divided,
                       double first, int most_steps, const Progress& progress);

} // namespace tetrarch::hyperbolic
