// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The two ways to a structure, and how their last state is judged.

#include "newton_system.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

namespace tetrarch::hyperbolic {

/// No step changes a length by more than this: beyond, exponentials of the lengths make the quadratic model
/// meaningless.
constexpr double longest_step = 2;

/// When to stop, in the scalar's own terms.
template <class Scalar>
struct Goals {
  Scalar tolerance;
  Scalar step_tolerance;
  Scalar length_limit;
  int max_iterations;
};

template <class Scalar>
struct Run {
  State<Scalar> state;
  Scalar last_step; ///< of the Newton step at the state
  int iterations = 0;
  bool stopped = false;
  FlowHistory history;
};

template <class Scalar>
Run<Scalar> newton(const Problem& problem, std::vector<Scalar> start, const Goals<Scalar>& goals,
                   const Progress& progress);
Run<double> flow(const Problem& problem, std::vector<double> start, const Goals<double>& goals,
                 bool keep_history, const Progress& progress);

} // namespace tetrarch::hyperbolic
