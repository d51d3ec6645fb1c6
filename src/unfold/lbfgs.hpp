// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The limited-memory method of Broyden, Fletcher, Goldfarb and Shanno. Source: Nocedal and Wright,
/// "Numerical Optimization", chapter 7; the line search brackets the weak conditions of Wolfe by halving and
/// doubling.

#include <functional>
#include <vector>

namespace tetrarch::unfold {

using Values = std::vector<double>;

/// Multiplies by a matrix near to the inverse of the Hessian, symmetric and positive definite.
using Precondition = std::function<void(Values&)>;

struct Descent {
  double value = 0;
  int iterations = 0;
};

/// Minimizes from x on, which becomes the best point found; `f` returns the value and fills the gradient.
/// Ends where the value falls by less than `least_gain` of itself in an iteration, where no step leads down,
/// or after so many iterations. `watch` is called once in each.
Descent minimize(const std::function<double(const Values& x, Values& gradient)>& f, Values& x,
                 int most_iterations, double least_gain, const std::function<void()>& watch,
                 const Precondition& precondition);

} // namespace tetrarch::unfold
