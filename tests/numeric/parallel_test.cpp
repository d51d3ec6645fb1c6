// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>
#include <string>

using namespace tetrarch::numeric;

namespace {

/// Earlier pieces take longer, so that later ones are ready before them.
std::string slowly(std::size_t piece) {
  std::this_thread::sleep_for(std::chrono::microseconds(piece % 7 == 0 ? 2000 : 0));
  return std::to_string(piece);
}

auto make_slow_worker() {
  return [](std::size_t piece) { return slowly(piece); };
}

} // namespace

TEST_CASE("every job is done once, whatever the threads and batches") {
  for (const int threads : {1, 2, 5})
    for (const int batch : {1, 3, 1000}) {
      std::vector<int> done(100, 0);
      std::vector<double> parts;
      parallel_for(
          100, {threads, batch}, [&](int k) { ++done[k]; }, [&](double part) { parts.push_back(part); });
      CHECK(done == std::vector<int>(100, 1));
      CHECK(std::is_sorted(parts.begin(), parts.end()));
      for (const double part : parts) CHECK((part >= 0 && part < 1));
    }
  parallel_for(0, {3}, [](int) { FAIL("there is no job"); });
}

TEST_CASE("what a job throws ends all, and is thrown") {
  for (const int threads : {1, 4}) {
    std::atomic<int> count = 0;
    const auto job = [&](int k) {
      ++count;
      if (k == 10) throw std::runtime_error("ten");
    };
    CHECK_THROWS_WITH(parallel_for(1'000'000'000, {threads}, job), "ten");
    CHECK(count < 1'000'000'000);
    const auto stop = [](double part) {
      if (part > 0) throw std::runtime_error("stop");
    };
    CHECK_THROWS_WITH(parallel_for(
                          1'000'000'000, {threads, 10}, [](int) {}, stop),
                      "stop");
  }
}

TEST_CASE("results are delivered in the order of their pieces") {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::string> got;
    // More pieces than may wait at a time.
    gather_in_order<std::string>(
        1000, threads, make_slow_worker, [&](std::string&& text) { got.push_back(std::move(text)); },
        [](double) {});
    REQUIRE(got.size() == 1000);
    for (std::size_t k = 0; k < got.size(); ++k) REQUIRE(got[k] == std::to_string(k));
  }
}

TEST_CASE("what is thrown in a worker, by its maker, by the receiver or by the report ends all") {
  const auto nothing = [](double) {};
  const auto ignore = [](std::string&&) {};
  const auto failing_worker = [] {
    return [](std::size_t piece) { return piece == 50 ? throw std::runtime_error("worker") : slowly(piece); };
  };
  CHECK_THROWS_WITH(gather_in_order<std::string>(1000, 3, failing_worker, ignore, nothing), "worker");
  const auto no_worker = []() -> std::string (*)(std::size_t) { throw std::runtime_error("maker"); };
  CHECK_THROWS_WITH(gather_in_order<std::string>(1000, 3, no_worker, ignore, nothing), "maker");
  const auto refuse = [](std::string&& text) {
    if (text == "20") throw std::runtime_error("receiver");
  };
  CHECK_THROWS_WITH(gather_in_order<std::string>(1000, 3, make_slow_worker, refuse, nothing), "receiver");
  const auto stop = [](double part) {
    if (part > 0.01) throw std::runtime_error("report");
  };
  CHECK_THROWS_WITH(gather_in_order<std::string>(1000, 3, make_slow_worker, ignore, stop), "report");
}

TEST_CASE("workers do not run far ahead of the receiver") {
  std::atomic<int> made = 0;
  int delivered = 0;
  int lead = 0;
  const auto worker = [&] { return [&](std::size_t) { return ++made; }; };
  gather_in_order<int>(
      2000, 3, worker,
      [&](int&&) {
        if (++delivered == 1) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        lead = std::max(lead, made.load() - delivered);
      },
      [](double) {});
  CHECK(lead > 0);
  CHECK(lead <= 256); // the promise of the header
}
