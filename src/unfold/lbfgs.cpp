// SPDX-License-Identifier: GPL-2.0-or-later
#include "lbfgs.hpp"

#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>

namespace tetrarch::unfold {
namespace {

constexpr std::size_t memory = 10; // pairs kept
constexpr double decrease = 1e-4;  // of the value along the slope, that a step must reach
constexpr double flatter = 0.9;    // part of the slope that may be left after a step
constexpr int most_trials = 40;

double inner_product(const Values& a, const Values& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// What a step and the change of the gradient along it tell of the Hessian.
struct Pair {
  Values step;
  Values change;
  double curvature = 0; ///< their product, positive
  double scale = 1;     ///< the product of the change and of the change preconditioned
};

/// Minus the inverse of the approximate Hessian times the gradient.
Values direction(const std::deque<Pair>& pairs, const Values& gradient, const Precondition& precondition) {
  Values d = gradient;
  std::vector<double> part(pairs.size());
  const auto add = [&](const Values& v, double factor) {
    for (std::size_t i = 0; i < d.size(); ++i) d[i] += factor * v[i];
  };
  for (std::size_t k = pairs.size(); k-- > 0;) {
    part[k] = inner_product(pairs[k].step, d) / pairs[k].curvature;
    add(pairs[k].change, -part[k]);
  }
  precondition(d);
  double scale = 1;
  if (!pairs.empty()) scale = pairs.back().curvature / pairs.back().scale;
  for (double& x : d) x *= -scale;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    add(pairs[k].step, -part[k] - inner_product(pairs[k].change, d) / pairs[k].curvature);
  return d;
}

struct State {
  Values x;
  Values gradient;
  double value = 0;
};

} // namespace

Descent minimize(const std::function<double(const Values& x, Values& gradient)>& f, Values& x,
                 int most_iterations, double least_gain, const std::function<void()>& watch,
                 const Precondition& precondition) {
  State now{x, Values(x.size()), 0};
  now.value = f(now.x, now.gradient);
  Descent result;
  std::deque<Pair> pairs;
  for (; result.iterations < most_iterations; ++result.iterations) {
    watch();
    Values d = direction(pairs, now.gradient, precondition);
    double slope = inner_product(d, now.gradient);
    if (!(slope < 0)) { // rounding spoiled the pairs
      pairs.clear();
      d = direction(pairs, now.gradient, precondition);
      slope = inner_product(d, now.gradient);
      if (!(slope < 0)) break;
    }
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    double t = 1;
    State next = now;
    State best = now;
    for (int trial = 0; trial < most_trials; ++trial) {
      for (std::size_t i = 0; i < x.size(); ++i) next.x[i] = now.x[i] + t * d[i];
      next.value = f(next.x, next.gradient);
      const bool is_down = std::isfinite(next.value) && next.value <= now.value + decrease * t * slope;
      if (is_down && next.value < best.value) best = next;
      if (!is_down)
        high = t;
      else if (inner_product(next.gradient, d) < flatter * slope)
        low = t;
      else
        break;
      t = std::isfinite(high) ? (low + high) / 2 : 2 * t;
    }
    if (!(best.value < now.value)) break;
    Pair pair{Values(x.size()), Values(x.size()), 0};
    for (std::size_t i = 0; i < x.size(); ++i) {
      pair.step[i] = best.x[i] - now.x[i];
      pair.change[i] = best.gradient[i] - now.gradient[i];
    }
    pair.curvature = inner_product(pair.step, pair.change);
    Values preconditioned = pair.change;
    precondition(preconditioned);
    pair.scale = inner_product(pair.change, preconditioned);
    const double gain = now.value - best.value;
    now = std::move(best);
    if (pair.curvature > 0) pairs.push_back(std::move(pair));
    if (pairs.size() > memory) pairs.pop_front();
    if (gain < least_gain * std::abs(now.value)) break;
  }
  x = std::move(now.x);
  result.value = now.value;
  return result;
}

} // namespace tetrarch::unfold
