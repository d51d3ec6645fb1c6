// SPDX-License-Identifier: GPL-2.0-or-later

/// Cutting patterns of random disks, and whole bundles: from a surface to a proved triangulation.

#include "bundle/bundles.hpp"
#include "tetrarch/bundle/direct.hpp"
#include "tetrarch/bundle/plan.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace tetrarch;
using namespace tetrarch::bundle;

/// About `triangles` triangles: a grid with splits and outgrowths, named at random.
Disk disk_of(int triangles) {
  support::Random random(1);
  const int side = static_cast<int>(std::sqrt(triangles / 4.0));
  return support::random_disk({side, side, triangles / 8, triangles / 4, true}, random);
}

/// A second for a million triangles is wanted. One pass over the triangles is the limit.
template <class Algorithm>
void pattern(benchmark::State& state, Algorithm algorithm) {
  const Disk disk = disk_of(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(algorithm(disk));
  state.SetItemsProcessed(state.iterations() * disk.triangle_count());
  state.SetComplexityN(disk.triangle_count());
}

BoundaryValues random_values(const Disk& disk) {
  support::Random random(2);
  return support::random_boundary(disk, random);
}

void algorithm_1(benchmark::State& state) {
  pattern(state, [](const Disk& disk) { return cut_restricted(disk, restricted_boundary(disk)); });
}
void algorithm_2(benchmark::State& state) {
  pattern(state, [](const Disk& disk) { return cut_general(disk, random_values(disk)); });
}
void algorithm_3(benchmark::State& state) {
  pattern(state, [](const Disk& disk) { return cut_free(disk); });
}
void by_the_dual_graph(benchmark::State& state) {
  pattern(state, [](const Disk& disk) { return cut_by_dual_graph(disk, random_values(disk)); });
}
BENCHMARK(algorithm_1)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(algorithm_2)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(algorithm_3)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(by_the_dual_graph)
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

/// 10,000 triangles with fibres of 64 edges, 1.9 million tetrahedra; 10 seconds are wanted. The first
/// argument is the genus, the second the triangles, the third N.
void unit_tangent_bundle(benchmark::State& state) {
  const int genus = static_cast<int>(state.range(0));
  const int triangles = static_cast<int>(state.range(1));
  // Each handle has its share of the triangles.
  const int side = static_cast<int>(std::sqrt(triangles / (2.0 * std::max(1, genus))));
  support::Random random(1);
  const support::TriangleList list =
      genus == 0 ? support::retriangulated(support::icosphere(5), random, 1000, (triangles - 8192) / 2)
                 : support::genus_surface(genus, side, side);
  const surface::MarkedSurface surface = list.marked();
  int tetrahedra = 0;
  for (auto _ : state) {
    const auto planned = plan(surface, {static_cast<int>(state.range(2)), {}, {}, {}});
    const CircleBundle bundle = assemble(std::get<Plan>(planned).recipe);
    const Proof proof = prove(bundle, Skeleton(bundle.total));
    if (!proof.failure.empty()) state.SkipWithError(proof.failure.c_str());
    tetrahedra = bundle.total.size();
  }
  state.counters["tetrahedra"] = tetrahedra;
  state.SetItemsProcessed(state.iterations() * tetrahedra);
}
BENCHMARK(unit_tangent_bundle)
    ->Args({0, 10'000, 64})
    ->Args({1, 10'000, 64})
    ->Args({2, 10'000, 64})
    ->Args({5, 10'000, 64})
    ->Args({2, 10'000, 8})
    ->Args({2, 100'000, 8})
    ->Args({2, 1'000'000, 1})
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
