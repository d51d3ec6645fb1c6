// SPDX-License-Identifier: GPL-2.0-or-later
#include "job.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <pthread.h>
#include <string>
#include <thread>
#include <vector>

namespace tetrarch::python {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds between_looks{50};
constexpr milliseconds grace{800}; ///< that stopped work has to end

/// Work, and what its two threads tell each other.
class Job {
public:
  explicit Job(std::function<void(const Progress&)> work) : work_(std::move(work)) {}

  /// On the worker.
  void run() {
    std::exception_ptr error;
    try {
      work_(Progress([this](std::string_view stage, double fraction) { note(stage, fraction); },
                     stop_.get_token()));
    } catch (...) {
      error = std::current_exception();
    }
    work_ = nullptr; // what it owns goes here, not with the last of the two threads
    const std::lock_guard lock(mutex_);
    error_ = std::move(error);
    is_done_ = true;
    ended_.notify_all();
  }

  bool wait(milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return is_done_; });
  }
  void stop() { stop_.request_stop(); }
  /// Throws what the work has thrown.
  void finish() const {
    if (error_) std::rethrow_exception(error_);
  }
  /// The last that was told, if anything was told since it was asked for.
  std::optional<std::pair<std::string, double>> news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, std::nullopt);
  }

private:
  /// Work may tell thousands of times a second, on many threads: who comes in between is passed over.
  void note(std::string_view stage, double fraction) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) news_.emplace(std::string(stage), fraction);
  }

  std::function<void(const Progress&)> work_;
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::exception_ptr error_;
  std::optional<std::pair<std::string, double>> news_;
  bool is_done_ = false;
};

/// Threads that wait for jobs. As many as ever were needed at once.
class Workers {
public:
  void run(const std::shared_ptr<Job>& job) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(job);
    if (idle_ < waiting_.size()) std::thread([this] { work(); }).detach();
    came_.notify_one();
  }

private:
  [[noreturn]] void work() {
    while (true) {
      std::shared_ptr<Job> job;
      {
        std::unique_lock lock(mutex_);
        ++idle_;
        came_.wait(lock, [this] { return !waiting_.empty(); });
        --idle_;
        job = std::move(waiting_.back());
        waiting_.pop_back();
      }
      job->run();
    }
  }

  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<std::shared_ptr<Job>> waiting_;
  std::size_t idle_ = 0;
};

/// Never destroyed: its threads outlive every function. A child of fork() has the memory and not the threads.
Workers* the_workers = new Workers;

Workers& workers() {
  static const bool watches_forks = pthread_atfork(nullptr, nullptr, [] { the_workers = new Workers; }) == 0;
  (void)watches_forks;
  return *the_workers;
}

void tell(Job& job, const py::object& report) {
  if (report.is_none()) return;
  const auto news = job.news();
  if (!news) return;
  const auto& [stage, fraction] = *news;
  report(stage, fraction >= 0 ? py::object(py::float_(fraction)) : py::object(py::none()));
}

bool waited(Job& job, milliseconds time) {
  const py::gil_scoped_release released;
  return job.wait(time);
}

} // namespace

void run_work(std::function<void(const Progress&)> work, const py::object& report) {
  const auto job = std::make_shared<Job>(std::move(work));
  workers().run(job);
  while (!waited(*job, between_looks)) {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      tell(*job, report);
    } catch (...) {
      job->stop();
      waited(*job, grace);
      throw;
    }
  }
  job->finish();
}

} // namespace tetrarch::python
