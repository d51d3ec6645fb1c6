// SPDX-License-Identifier: GPL-2.0-or-later

/// Simplification and conversion of growing meshes: cubes, the 3-torus, exteriors of knots and links.
///
/// The arguments are the kind and the size: cubes along a side (12, 26, 55, 80: 10,368 to 3,072,000
/// tetrahedra), or for the exteriors the spacing of the lattice in cubes (2, 4, 8, 13). `ns_per_tet` tells
/// how far from linear the growth is: reading all gluings once and writing them, which is the limit, takes
/// about 30. Skeleton and reading of files are not in the figures.

#include "support/links.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace tetrarch;

enum Kind { ball, torus, trefoil, figure_eight, borromean };

Triangulation make(int kind, int size) {
  if (kind == ball) return support::cubical_ball(size, size, size);
  if (kind == torus) return support::cubical_torus(size, size, size);
  const char* const name = kind == trefoil        ? "trefoil"
                           : kind == figure_eight ? "figure eight"
                                                  : "Borromean rings";
  return triangulation_of(exterior(support::named_link(name).grid, {size, 1}));
}

void set_counters(benchmark::State& state, int tets, int left) {
  static const char* const names[] = {"ball", "torus", "trefoil", "figure eight", "Borromean rings"};
  state.SetLabel(std::string(names[state.range(0)]) + ", " + std::to_string(tets) + " tetrahedra to " +
                 std::to_string(left));
  state.counters["per_tet"] =
      benchmark::Counter(tets, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void simplify(benchmark::State& state) {
  const Triangulation tri = make(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int left = 0;
  for (auto _ : state) left = moves::simplified(tri).size();
  set_counters(state, tri.size(), left);
}

void truncate(benchmark::State& state) {
  const Triangulation tri = make(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int left = 0;
  for (auto _ : state) left = moves::truncate(tri).tri.size();
  set_counters(state, tri.size(), left);
}

BENCHMARK(simplify)->ArgsProduct({{ball, torus}, {12, 26, 55, 80}})->Unit(benchmark::kMillisecond);
BENCHMARK(truncate)
    ->ArgsProduct({{trefoil, figure_eight, borromean}, {2, 4, 8, 13}})
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
