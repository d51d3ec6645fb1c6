// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Work shared among threads, such that their number makes no difference to what comes out.
///
/// `parallel_for`: many small jobs, each of which writes to a place of its own.
/// `gather_in_order`: pieces whose results are delivered one after the other, in the order of the pieces.

#include "tetrarch/numeric/scalar.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace tetrarch::numeric {

struct Threads {
  int count = 1; ///< this one among them
  int batch = 1; ///< jobs that a thread takes at a time
};

/// Starts a thread that runs `work`; false where the system gives no more.
template <class Work>
bool started(std::vector<std::jthread>& threads, const Work& work) {
  try {
    threads.emplace_back(work);
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

/// Runs `job(k)` for all k < count. This thread is one of them, and calls `report(part)` between its batches
/// with the part, from 0 to 1, that has been taken. What is thrown first, by a job or by `report`, is thrown
/// once all have stopped.
template <class Job, class Report>
void parallel_for(int count, Threads threads, const Job& job, const Report& report) {
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&](bool reports) {
    try {
      for (int from = next.fetch_add(threads.batch); from < count; from = next.fetch_add(threads.batch)) {
        if (reports) report(static_cast<double>(from) / count);
        for (int k = from; k < std::min(count, from + threads.batch); ++k) job(k);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    helpers.reserve(static_cast<std::size_t>(std::max(0, threads.count - 1)));
    for (int k = 1; k < threads.count; ++k)
      if (!started(helpers, [&] {
            work(false);
            free_thread_cache();
          }))
        break;
    work(true);
  }
  if (failure) std::rethrow_exception(failure);
}

template <class Job>
void parallel_for(int count, Threads threads, const Job& job) {
  parallel_for(count, threads, job, [](double) {});
}

/// Workers take one piece after the other; the results leave in the order of the pieces.
template <class Result>
class InOrder {
public:
  explicit InOrder(std::size_t pieces) : pieces_(pieces) {}

  template <class MakeWorker, class Deliver, class Report>
  void run(int threads, const MakeWorker& make_worker, const Deliver& deliver, const Report& report) {
    std::vector<std::jthread> workers;
    workers.reserve(static_cast<std::size_t>(threads));
    const Closing closing{*this};
    for (int k = 0; k < threads; ++k)
      if (!started(workers, [&] { work(make_worker); })) break;
    if (workers.empty() && pieces_ > 0)
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    for (std::size_t piece = 0; piece < pieces_; ++piece) {
      report(static_cast<double>(piece) / static_cast<double>(pieces_));
      deliver(wait_for(piece));
    }
  }

private:
  /// Sends the workers home, however `run` is left; it is destroyed before they are joined.
  struct Closing {
    InOrder& shop;
    explicit Closing(InOrder& s) : shop(s) {}
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;
    ~Closing() {
      const std::lock_guard lock(shop.mutex_);
      shop.closed_ = true;
      shop.changed_.notify_all();
    }
  };

  template <class MakeWorker>
  void work(const MakeWorker& make_worker) {
    try {
      auto worker = make_worker();
      for (std::size_t piece = 0; take(piece);) {
        Result result = worker(piece);
        const std::lock_guard lock(mutex_);
        finished_.emplace(piece, std::move(result));
        changed_.notify_all();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      changed_.notify_all();
    }
    free_thread_cache();
  }

  /// The next piece, unless the workers are too far ahead of the deliveries: then waits. False: go home.
  bool take(std::size_t& piece) {
    constexpr std::size_t max_lead = 256; // bounds the memory where a receiver is slow
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || failure_ || taken_ < delivered_ + max_lead; });
    if (closed_ || failure_ || taken_ == pieces_) return false;
    piece = taken_++;
    return true;
  }

  Result wait_for(std::size_t piece) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || finished_.contains(piece); });
    if (failure_) std::rethrow_exception(failure_);
    Result result = std::move(finished_.extract(piece).mapped());
    delivered_ = piece + 1;
    changed_.notify_all();
    return result;
  }

  std::size_t pieces_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t taken_ = 0;
  std::size_t delivered_ = 0;
  std::map<std::size_t, Result> finished_;
  std::exception_ptr failure_;
  bool closed_ = false;
};

/// `make_worker()` is called once in each thread and gives a function from a piece's number to its Result;
/// `deliver(Result&&)` is called in this thread, for piece 0, 1, 2, ...; `report(part)` before each. What is
/// thrown anywhere ends all threads and is thrown here. At most 256 results wait at a time.
template <class Result, class MakeWorker, class Deliver, class Report>
void gather_in_order(std::size_t pieces, int threads, const MakeWorker& make_worker, const Deliver& deliver,
                     const Report& report) {
  InOrder<Result>(pieces).run(threads, make_worker, deliver, report);
}

} // namespace tetrarch::numeric
