// SPDX-License-Identifier: GPL-2.0-or-later
/// Foldings of a box of n^3 cubes, six tetrahedra each, its boundary fixed: n = 10 to 55 are 6,000 to 998,250
/// tetrahedra. `Energy` is one value with its gradient; `Unfold` goes from points that are up to an edge's
/// length off, where about a third of the tetrahedra is turned over, to none. Counter `bytes`: what the
/// process holds at most.

#include "support/boxes.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <vector>

namespace {

using namespace tetrarch;
using namespace tetrarch::unfold;
using support::Box;

Box folded_box(int n) {
  Box box(n);
  box.shake(1, 7);
  return box;
}

void note(benchmark::State& state, const Box& box) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["tetrahedra"] = static_cast<double>(box.problem.elements.size());
  state.counters["bytes"] = 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void Energy(benchmark::State& state) {
  const Box box = folded_box(static_cast<int>(state.range(0)));
  std::vector<Vector> gradient;
  for (auto _ : state) benchmark::DoNotOptimize(energy(box.problem.elements, box.points, 0.5, 1, &gradient));
  note(state, box);
}
BENCHMARK(Energy)->Arg(10)->Arg(25)->Arg(55)->Unit(benchmark::kMillisecond);

void Unfold(benchmark::State& state) {
  const Box box = folded_box(static_cast<int>(state.range(0)));
  Unfolded done;
  for (auto _ : state) done = unfold::unfold(box.problem, box.points);
  state.counters["before"] = done.folded_before;
  state.counters["after"] = done.folded_after;
  state.counters["iterations"] = done.iterations;
  note(state, box);
}
BENCHMARK(Unfold)->Arg(10)->Arg(25)->Arg(55)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
