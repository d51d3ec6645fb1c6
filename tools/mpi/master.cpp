// SPDX-License-Identifier: GPL-2.0-or-later
#include "master.hpp"

#include "messages.hpp"
#include "worker.hpp"

#include "tetrarch/catalogue/units.hpp"

#include <algorithm>
#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace tetrarch::mpi {
namespace {

using catalogue::ClassificationUnits;
using catalogue::UnitRecords;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The units of one job: which wait, which are out, which are done. Any thread.
class Queue {
public:
  Queue(const ClassificationUnits& units, const UnitRecords& records)
      : records_(records), is_done_(static_cast<std::size_t>(units.size()), false),
        given_(static_cast<std::size_t>(units.size())) {
    for (int k = units.size() - 1; k >= 0; --k)
      if (units.is_kept(k, records))
        is_done_[k] = true;
      else
        waiting_.push_back(k);
    left_ = static_cast<int>(waiting_.size());
  }

  /// A unit to do, -1 for none: one that waits, else one that is out for far longer than any took.
  int next() {
    const std::lock_guard lock(mutex_);
    int unit = -1;
    if (!waiting_.empty()) {
      unit = waiting_.back();
      waiting_.pop_back();
    } else if (const int k = overdue(); k >= 0)
      unit = k;
    if (unit >= 0) given_[unit] = Clock::now();
    return unit;
  }

  /// The first answer counts.
  void keep(int unit, const std::vector<std::pair<std::string, std::string>>& made) {
    const std::lock_guard lock(mutex_);
    if (is_done_.at(unit)) return;
    for (const auto& [key, text] : made) records_.keep(key, text);
    is_done_[unit] = true;
    --left_;
    longest_ = std::max(longest_, seconds_since(given_[unit]));
  }

  int left() const {
    const std::lock_guard lock(mutex_);
    return left_;
  }
  double done() const { return 1 - static_cast<double>(left()) / static_cast<double>(is_done_.size()); }

private:
  int overdue() const {
    constexpr double at_least = 5; // seconds
    constexpr double times_the_longest = 4;
    const double late = std::max(at_least, times_the_longest * longest_);
    for (std::size_t k = 0; k < is_done_.size(); ++k)
      if (!is_done_[k] && seconds_since(given_[k]) > late) return static_cast<int>(k);
    return -1;
  }

  const UnitRecords& records_;
  mutable std::mutex mutex_;
  std::vector<bool> is_done_;
  std::vector<Clock::time_point> given_;
  std::vector<int> waiting_; ///< the next one last
  int left_ = 0;
  double longest_ = 0;
};

/// Rank 0's own work, in a thread beside the one that speaks. It ends by itself, or when it is stopped.
class OwnWork {
public:
  OwnWork(const ClassificationUnits& units, Queue& queue)
      : thread_([this, &units, &queue](const std::stop_token& stop) { run(units, queue, stop); }) {}

  /// Throws what was thrown there.
  void check() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  void run(const ClassificationUnits& units, Queue& queue, const std::stop_token& stop) {
    const Progress progress({}, stop);
    try {
      while (queue.left() > 0) {
        progress.step({});
        if (const int unit = queue.next(); unit >= 0)
          queue.keep(unit, units.make(unit, progress));
        else
          doze();
      }
    } catch (const Stopped&) { // by the other thread, which knows why
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }

  std::mutex mutex_;
  std::exception_ptr failure_;
  std::jthread thread_; ///< the last member: it uses the others
};

} // namespace

std::optional<std::pair<int, Report>> Master::next_report() {
  const auto message = world_.iprobe(boost::mpi::any_source, asking);
  if (!message) {
    doze();
    return std::nullopt;
  }
  std::pair<int, Report> came{message->source(), {}};
  world_.recv(came.first, asking, came.second);
  return came;
}

void Master::share_out(catalogue::TableKey table, bool angles, const UnitRecords& records,
                       const Progress& progress) {
  const ClassificationUnits units(table, angles, progress);
  Queue queue(units, records);
  OwnWork own(units, queue);
  ++job_;
  while (queue.left() > 0) {
    progress.step("solving and canonizing", queue.done());
    own.check();
    const auto came = next_report();
    if (!came) continue;
    const auto& [rank, report] = *came;
    if (report.unit >= 0 && report.job == job_) queue.keep(report.unit, report.records);
    const int unit = queue.next();
    world_.send(
        rank, ordering,
        Order{unit >= 0 ? Order::make : Order::wait, job_, table.tetrahedra, table.orientable, angles, unit});
  }
}

int Master::dismiss(double grace) {
  std::set<int> here;
  const auto start = Clock::now();
  while (static_cast<int>(here.size()) < world_.size() - 1 && seconds_since(start) < grace) {
    if (const auto came = next_report()) here.insert(came->first);
  }
  const int lost = world_.size() - 1 - static_cast<int>(here.size());
  for (const int rank : here)
    world_.send(rank, ordering, Order{lost > 0 ? Order::leave_at_once : Order::leave, 0, 0, true, false, -1});
  return lost;
}

} // namespace tetrarch::mpi
