// SPDX-License-Identifier: GPL-2.0-or-later

/// Placing fundamental domains and finding pieces of the universal cover of the knotted Y.

#include "tetrarch/core/signature.hpp"
#include "tetrarch/embed/cover.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace tetrarch;

struct KnottedY {
  Triangulation tri = from_signature("cPcbbbihq");
  Skeleton skeleton{tri};
  hyperbolic::Hyperbolization<double> structure = hyperbolic::hyperbolize(tri, skeleton);
  embed::Domain<double> domain = embed::fundamental_domain(tri, skeleton, structure);
};

/// 3 seconds for 100,000 are wanted. A copy costs six products of matrices, six look-ups and 150 bytes.
void copies_of_the_knotted_y(benchmark::State& state) {
  const KnottedY y;
  for (auto _ : state) {
    const embed::Piece piece = embed::universal_cover(y.domain, {state.range(0), 0, 0});
    benchmark::DoNotOptimize(piece.copies.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(copies_of_the_knotted_y)
    ->RangeMultiplier(10)
    ->Range(1000, 10'000'000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

void domain_in_doubles(benchmark::State& state) {
  const KnottedY y;
  for (auto _ : state)
    benchmark::DoNotOptimize(embed::fundamental_domain(y.tri, y.skeleton, y.structure.lengths).faces.data());
}
BENCHMARK(domain_in_doubles)->Unit(benchmark::kMicrosecond);

void domain_in_50_digits(benchmark::State& state) {
  const KnottedY y;
  for (auto _ : state)
    benchmark::DoNotOptimize(embed::fundamental_domain(y.tri, y.skeleton, y.structure).faces.data());
}
BENCHMARK(domain_in_50_digits)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
