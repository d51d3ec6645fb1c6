// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What Luo's flow dl/dt = K did, step by step.

#include <iosfwd>
#include <vector>

namespace tetrarch::hyperbolic {

/// The state after a step; entry 0 is the start.
struct FlowStep {
  double time = 0;              ///< the sum of the step sizes so far
  double step_size = 0;         ///< of the step that led here
  double squared_curvature = 0; ///< sum of K_e^2. Law: strictly decreasing
  double max_curvature = 0;     ///< max |K_e|
};
using FlowHistory = std::vector<FlowStep>;

/// A header line "step,time,step_size,squared_curvature,max_curvature", then one line an entry. Numbers are
/// the shortest that read back the same, with a point whatever the locale.
void write_history_csv(std::ostream& out, const FlowHistory& history);

} // namespace tetrarch::hyperbolic
