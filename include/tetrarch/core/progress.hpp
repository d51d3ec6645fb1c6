// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How a long job reports its progress, and how others ask it to stop.
///
/// A job receives a `Progress` by reference, calls `step` between units of work of at most a few
/// milliseconds, and lets `Stopped` pass through. A default-constructed `Progress` reports to nobody and
/// never stops.

#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

namespace tetrarch {

/// Thrown by `Progress::step` once a stop was requested. Nothing has been written when it is thrown.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("interrupted") {}
};

/// How a long job reports its progress and learns that it should stop.
class Progress {
public:
  /// Called with a short stage name and the fraction done, in [0, 1]; negative where it is unknown.
  using Report = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  Progress(Report report, std::stop_token stop) : report_(std::move(report)), stop_(std::move(stop)) {}

  /// Reports, then throws `Stopped` if a stop was requested. Safe to call from several threads if `report`
  /// is.
  void step(std::string_view stage, double fraction = -1) const {
    if (stop_.stop_requested()) throw Stopped();
    if (report_) report_(stage, fraction);
  }
  bool stop_requested() const { return stop_.stop_requested(); }
  /// The same stop, but silent: for inner jobs whose fraction means nothing to the outer one.
  Progress silent() const { return {Report(), stop_}; }

private:
  Report report_;
  std::stop_token stop_;
};

} // namespace tetrarch
