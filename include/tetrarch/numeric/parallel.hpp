// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Many small jobs shared among threads. Each writes to a place of its own, so that the number of threads
/// makes no difference.

#include "tetrarch/core/progress.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tetrarch::product {

/// Runs `job(k)` for all k < count, in batches; this thread is one of them, and the one that reports. What a
/// job throws first is thrown once all have stopped.
template <class Job>
void for_each(int count, int threads, int batch, const Progress& progress, const char* stage,
              const Job& job) {
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&](bool reports) {
    try {
      for (int from = next.fetch_add(batch); from < count; from = next.fetch_add(batch)) {
        if (reports) progress.step(stage, static_cast<double>(from) / count);
        for (int k = from; k < std::min(count, from + batch); ++k) job(k);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    helpers.reserve(static_cast<std::size_t>(std::max(0, threads - 1)));
    for (int k = 1; k < threads; ++k) helpers.emplace_back([&] { work(false); });
    work(true);
  }
  if (failure) std::rethrow_exception(failure);
}

} // namespace tetrarch::product
