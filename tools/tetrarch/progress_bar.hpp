// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A line on standard error that tells how far a long job is: only on a terminal, and only after two seconds.

#include "tetrarch/core/progress.hpp"

#include <memory>

namespace tetrarch::program {

class ProgressBar {
public:
  /// Silent unless `wanted` and standard error is a terminal.
  explicit ProgressBar(bool wanted);
  /// What a `Progress` calls; empty when silent. May be called from several threads.
  Progress::Report report() const;
  /// Removes the line.
  void clear() const;

private:
  struct State;
  std::shared_ptr<State> state_;
};

} // namespace tetrarch::program
