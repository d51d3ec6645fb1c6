// SPDX-License-Identifier: GPL-2.0-or-later
/// Hexahedra for a pipe that is turned against the axes, so that grids do not fit it: 36 n^3 tetrahedra, n =
/// 11 (about 48,000) and 24 (about 498,000). Counters: hexahedra made, the share of the time of each stage
/// (they add up to 1) and `bytes`, what the process holds at most.

#include "product/solids.hpp"
#include "tetrarch/hex/fill.hpp"

#include <benchmark/benchmark.h>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <sys/resource.h>

namespace {

using namespace tetrarch;
using Clock = std::chrono::steady_clock;

const product::Solid& turned_pipe(int n) {
  static std::map<int, product::Solid> all;
  const auto found = all.find(n);
  if (found != all.end()) return found->second;
  solid::TetMesh mesh = support::radial_pipe(0.5, n).mesh;
  for (auto& p : mesh.points) {
    p = {0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]};
    p = {p[0], 0.8 * p[1] - 0.6 * p[2], 0.6 * p[1] + 0.8 * p[2]};
  }
  return all.emplace(n, product::solid_of(mesh)).first->second;
}

/// Time by the stage that reported last.
class Stages {
public:
  void enter(std::string_view stage) {
    const auto now = Clock::now();
    seconds_[current_] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    current_ = stage;
  }
  void write(benchmark::State& state) {
    enter("");
    double all = 0;
    for (const auto& [stage, seconds] : seconds_) all += seconds;
    for (const auto& [stage, seconds] : seconds_)
      state.counters[stage.empty() ? "other" : stage] = seconds / all;
  }

private:
  std::map<std::string, double> seconds_;
  std::string current_;
  Clock::time_point since_ = Clock::now();
};

void note_memory(benchmark::State& state) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["bytes"] = 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void Fill(benchmark::State& state) {
  const product::Solid& solid = turned_pipe(static_cast<int>(state.range(0)));
  hex::FillOptions options;
  options.cells = state.range(1);
  Stages stages;
  const Progress progress([&](std::string_view stage, double) { stages.enter(stage); }, {});
  std::optional<hex::Filling> found;
  for (auto _ : state) found = hex::fill(solid, options, progress);
  stages.write(state);
  state.counters["tetrahedra"] = solid.size();
  state.counters["hexahedra"] = found ? static_cast<double>(found->mesh.hexahedra.size()) : 0;
  state.counters["least"] = found ? found->quality.minimum : -1;
  note_memory(state);
}
BENCHMARK(Fill)
    ->ArgNames({"n", "cells"})
    ->Args({11, 4000})
    ->Args({11, 20000})
    ->Args({11, 50000})
    ->Args({11, 100000})
    ->Args({24, 4000})
    ->Args({24, 20000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
