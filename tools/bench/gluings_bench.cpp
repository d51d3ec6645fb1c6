// SPDX-License-Identifier: GPL-2.0-or-later
// What the enumeration of gluings costs, with one thread: searching alone (count), with a triangulation built
// of each (visit), with names (signatures, sorted). The counter is gluings per second. compare_tricensus
// beside this file sets the last of them against Regina.
#include "tetrarch/enumeration/gluings.hpp"

#include <benchmark/benchmark.h>

using namespace tetrarch;
using namespace tetrarch::enumeration;

namespace {

GluingOptions orientable(benchmark::State& state) {
  GluingOptions options;
  options.tetrahedra = static_cast<int>(state.range(0));
  options.orientability = GluingOptions::Orientability::orientable;
  return options;
}

template <class Count>
void run(benchmark::State& state, const GluingOptions& options, Count count) {
  std::int64_t gluings = 0;
  for (auto _ : state) gluings += count(options);
  state.counters["gluings"] = static_cast<double>(gluings) / static_cast<double>(state.iterations());
  state.SetItemsProcessed(gluings);
}

std::int64_t counted(const GluingOptions& options) {
  return count_gluings(options);
}

std::int64_t named(const GluingOptions& options) {
  return static_cast<std::int64_t>(gluing_signatures(options).size());
}

std::int64_t visited(const GluingOptions& options) {
  std::int64_t count = 0;
  enumerate_gluings(options, [&](const Triangulation& tri) { count += tri.size() > 0; });
  return count;
}

void count_orientable(benchmark::State& state) {
  run(state, orientable(state), counted);
}

void visit_orientable(benchmark::State& state) {
  run(state, orientable(state), visited);
}

void signatures_orientable(benchmark::State& state) {
  run(state, orientable(state), named);
}

void count_all(benchmark::State& state) {
  GluingOptions options = orientable(state);
  options.orientability = GluingOptions::Orientability::any;
  run(state, options, counted);
}

/// Closed manifolds: few among many, so this is what pruning is worth.
void count_finite(benchmark::State& state) {
  GluingOptions options = orientable(state);
  options.links = LinkSet{{0}, {}};
  run(state, options, counted);
}

/// Candidates for cusped manifolds.
void count_torus_links(benchmark::State& state) {
  GluingOptions options = orientable(state);
  options.links = LinkSet{{1}, {}};
  options.min_valence = 3;
  run(state, options, counted);
}

} // namespace

BENCHMARK(count_orientable)->DenseRange(2, 5)->Unit(benchmark::kMillisecond);
BENCHMARK(visit_orientable)->DenseRange(2, 5)->Unit(benchmark::kMillisecond);
BENCHMARK(signatures_orientable)->DenseRange(2, 5)->Unit(benchmark::kMillisecond);
BENCHMARK(count_all)->DenseRange(2, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(count_finite)->DenseRange(3, 6)->Unit(benchmark::kMillisecond);
BENCHMARK(count_torus_links)->DenseRange(3, 6)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
