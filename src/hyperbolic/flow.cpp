// SPDX-License-Identifier: GPL-2.0-or-later
#include "solvers.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::hyperbolic {
namespace {

/// Explicit Euler is stable up to 2 / (largest eigenvalue of the Hessian). The step grows by `growth` while
/// the total squared curvature falls, and is halved where it would not, so it settles near that bound.
constexpr double first_step = 0.1;
constexpr double growth = 1.2;
/// Where steps below this still do not lower the curvature, rounding rules.
constexpr double smallest_step = 1e-12;

FlowStep entry(double time, double step_size, const State<double>& state) {
  return {time, step_size, state.squared_curvature(), state.residual()};
}

/// The size of the Newton step at the state, which tells a true limit from a length that creeps away.
double newton_step_size(const Problem& problem, State<double>& state) {
  state.evaluate(problem, true);
  NewtonSystem<double> system(problem);
  std::vector<double> step;
  system.solve(problem, state, step);
  return kernel::largest_magnitude(step);
}

/// One accepted step; false once steps are too small to matter. Leaves the next entry in `now`.
bool advance(const Problem& problem, State<double>& state, State<double>& trial, double& h, FlowStep& now) {
  for (; h > smallest_step; h /= 2) {
    for (std::size_t e = 0; e < trial.lengths.size(); ++e)
      trial.lengths[e] = state.lengths[e] + h * state.curvature[e];
    trial.evaluate(problem, false);
    const FlowStep next = entry(now.time + h, h, trial);
    if (!(next.squared_curvature < now.squared_curvature)) continue;
    std::swap(state, trial);
    now = next;
    h *= growth;
    return true;
  }
  return false;
}

} // namespace

Run<double> flow(const Problem& problem, std::vector<double> start, const Goals<double>& goals,
                 bool keep_history, const Progress& progress) {
  Run<double> run{State<double>(problem, std::move(start)), 0, 0, false, {}};
  State<double> trial = run.state;
  run.state.evaluate(problem, false);
  FlowStep now = entry(0, 0, run.state);
  if (keep_history) run.history.push_back(now);
  double h = first_step;
  const double goal = goals.tolerance / 10;
  try {
    while (now.max_curvature > goal && run.iterations < goals.max_iterations &&
           run.state.longest() <= goals.length_limit) {
      if (run.iterations % 64 == 0) progress.step("flow");
      if (!advance(problem, run.state, trial, h, now)) break;
      ++run.iterations;
      if (keep_history) run.history.push_back(now);
    }
  } catch (const Stopped&) {
    run.stopped = true;
  }
  run.last_step = newton_step_size(problem, run.state);
  return run;
}

} // namespace tetrarch::hyperbolic
