// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Long calls: without the interpreter's lock, stopped by Ctrl-C, and telling how far they are.
///
///     caller   start work --+-- look at signals, tell progress, every 50 ms --+-- result or exception
///     worker                +-- work(progress) .............................. done
///
/// The work runs on a thread of its own, so that the caller can look at signals, which Python's main thread
/// alone may do, however rarely the work looks at its stop token. What the caller's Python functions (signal
/// handlers, the progress callback) throw stops the work and comes out of the call. Workers wait for more
/// work; a child after fork() has none and makes its own.

#include "tetrarch/core/progress.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <pybind11/pybind11.h>
#include <utility>

namespace tetrarch::python {

namespace py = pybind11;

/// Runs `work` and waits for it. `report` is None or called with (stage, fraction done or None) on the
/// calling thread. The work must own all that it uses: where it does not stop within a second after it was
/// asked to, it is left alone. Called with the lock held; the work itself does not have it.
void run_work(std::function<void(const Progress&)> work, const py::object& report);

/// The same of a function with a result.
template <class Function>
auto interruptible(const py::object& report, Function function) {
  using Result = decltype(function(std::declval<const Progress&>()));
  const auto result = std::make_shared<std::optional<Result>>();
  run_work([result, function = std::move(function)](
               const Progress& progress) { result->emplace(function(progress)); },
           report);
  return std::move(**result);
}

/// Up to so many tetrahedra what is linear in their number takes below a millisecond.
inline constexpr std::size_t most_at_once = 1000;

/// A call of at most a few milliseconds: on this thread, without the lock.
template <class Function>
auto unlocked(Function function) {
  const py::gil_scoped_release released;
  return function();
}

/// A call whose time grows with `size`: at once, or, if it may take long, so that Ctrl-C ends the wait for
/// it. The function must own all that it uses.
template <class Function>
auto by_size(std::size_t size, Function function) {
  if (size <= most_at_once) return unlocked(std::move(function));
  return interruptible(py::none(), [function = std::move(function)](const Progress&) { return function(); });
}

} // namespace tetrarch::python
