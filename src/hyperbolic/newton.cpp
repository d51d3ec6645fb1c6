// SPDX-License-Identifier: GPL-2.0-or-later
#include "solvers.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

/// Minus the derivative of F along `step`.
template <class Scalar>
Scalar descent(const State<Scalar>& state, const std::vector<Scalar>& step) {
  Scalar sum = 0;
  for (std::size_t e = 0; e < step.size(); ++e) sum += state.curvature[e] * step[e];
  return sum;
}

/// Puts into `trial` a point from `now` along `step` where F, convex, still falls, or rises at no more than a
/// quarter of the slope it fell with at `now`. The slope stays meaningful down to rounding, where differences
/// of F have long drowned. False if there is none, or the step is no descent.
template <class Scalar>
bool line_search(const Problem& problem, const State<Scalar>& now, const std::vector<Scalar>& step,
                 State<Scalar>& trial) {
  const Scalar slope = descent(now, step);
  if (!(slope > 0)) return false;
  const Scalar size = kernel::largest_magnitude(step);
  Scalar t = size > longest_step ? Scalar(longest_step / size) : Scalar(1);
  for (int attempt = 0; attempt < 40; ++attempt) {
    for (std::size_t e = 0; e < step.size(); ++e) trial.lengths[e] = now.lengths[e] + t * step[e];
    trial.evaluate(problem, true);
    const Scalar here = descent(trial, step);
    if (here >= -slope / 4) return true;
    // Overshot: the zero of the secant through the two slopes, kept well inside.
    t *= std::clamp(Scalar(slope / (slope - here)), Scalar(0.1), Scalar(0.9));
  }
  return false;
}

/// Small enough, and not to be had smaller: either it is rounding, or the last step did not halve it.
template <class Scalar>
bool converged(const Run<Scalar>& run, const Scalar& residual, const Scalar& previous,
               const Goals<Scalar>& goals) {
  if (residual > goals.tolerance || run.last_step > goals.step_tolerance) return false;
  return residual <= 64 * std::numeric_limits<Scalar>::epsilon() || residual > previous / 2;
}

} // namespace

template <class Scalar>
Run<Scalar> newton(const Problem& problem, std::vector<Scalar> start, const Goals<Scalar>& goals,
                   const Progress& progress) {
  NewtonSystem<Scalar> system(problem);
  Run<Scalar> run{State<Scalar>(problem, std::move(start)), Scalar(0), 0, false, {}};
  State<Scalar> trial = run.state;
  std::vector<Scalar> step(run.state.lengths.size());
  run.state.evaluate(problem, true);
  Scalar previous = std::numeric_limits<Scalar>::max();
  try {
    for (;; ++run.iterations) {
      progress.step("newton");
      const Scalar residual = run.state.residual();
      system.solve(problem, run.state, step);
      run.last_step = kernel::largest_magnitude(step);
      if (converged(run, residual, previous, goals) || run.state.longest() > goals.length_limit ||
          run.iterations >= goals.max_iterations || !line_search(problem, run.state, step, trial))
        break;
      previous = residual;
      std::swap(run.state, trial);
    }
  } catch (const Stopped&) {
    run.stopped = true;
  }
  return run;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Run<Scalar> newton(const Problem&, std::vector<Scalar>, const Goals<Scalar>&, const Progress&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
