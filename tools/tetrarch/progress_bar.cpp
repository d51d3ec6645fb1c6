// SPDX-License-Identifier: GPL-2.0-or-later
#include "progress_bar.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <string>
#include <unistd.h>

namespace tetrarch::program {

using Clock = std::chrono::steady_clock;

struct ProgressBar::State {
  std::mutex mutex;
  Clock::time_point next = Clock::now() + std::chrono::seconds(2);
  bool shown = false;
};

ProgressBar::ProgressBar(bool wanted) {
  if (wanted && isatty(STDERR_FILENO) == 1) state_ = std::make_shared<State>();
}

Progress::Report ProgressBar::report() const {
  if (!state_) return {};
  return [state = state_](std::string_view stage, double fraction) {
    const std::unique_lock lock(state->mutex, std::try_to_lock);
    if (!lock || Clock::now() < state->next) return;
    state->next = Clock::now() + std::chrono::milliseconds(200);
    state->shown = true;
    constexpr int width = 30;
    std::string line = "\r\033[K" + std::string(stage);
    if (fraction >= 0) {
      const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
      line += " [" + std::string(filled, '#') + std::string(width - filled, '.') + "] " +
              std::to_string(static_cast<int>(100 * fraction)) + "%";
    }
    std::cerr << line << std::flush;
  };
}

void ProgressBar::clear() const {
  if (state_ && state_->shown) std::cerr << "\r\033[K" << std::flush;
}

} // namespace tetrarch::program
