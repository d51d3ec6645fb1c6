// SPDX-License-Identifier: GPL-2.0-or-later

/// H1, H1 modulo the boundary, and the fundamental group of growing triangulations.
///
/// The argument of each benchmark is the number of cubes along a side, six tetrahedra a cube: 6 (1,296
/// tetrahedra), 12 (10,368), 26 (105,456), 55 (998,250). The triangulations: a cubical 3-torus (as built, and
/// in a random labelling, which costs cache misses), a cubical ball, and a random closed orientable gluing of
/// as many tetrahedra, which has one vertex of enormous genus, a handful of edges and H1 of rank about n. The
/// skeleton is computed beforehand.

#include "support/random.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/algebra/homology.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace tetrarch;

enum Kind { torus, renamed_torus, ball, random_closed };

Triangulation make(int kind, int side) {
  support::Random random(1);
  const int tets = 6 * side * side * side;
  if (kind == ball) return support::cubical_ball(side, side, side);
  if (kind == random_closed) return support::random_gluing({tets, 0, true, true}, random);
  Triangulation tri = support::cubical_torus(side, side, side);
  return kind == torus ? tri : relabelled(tri, support::random_relabelling(tets, random));
}

/// Runs `job(tri, skeleton)` on the triangulation that the arguments name.
template <class Job>
void measure(benchmark::State& state, Job job) {
  static const char* const names[] = {"torus", "torus, renamed", "ball", "random"};
  const Triangulation tri = make(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Skeleton skeleton(tri);
  for (auto _ : state) benchmark::DoNotOptimize(job(tri, skeleton));
  state.SetLabel(std::string(names[state.range(0)]) + ", " + std::to_string(tri.size()) + " tetrahedra");
  state.counters["per_tet"] = benchmark::Counter(tri.size(), benchmark::Counter::kIsIterationInvariantRate |
                                                                 benchmark::Counter::kInvert);
}

void h1(benchmark::State& state) {
  measure(state, [](const auto& tri, const auto& skeleton) { return algebra::homology(tri, skeleton, 1); });
}
void h1_relative(benchmark::State& state) {
  measure(state,
          [](const auto& tri, const auto& skeleton) { return algebra::relative_homology(tri, skeleton, 1); });
}
void presentation(benchmark::State& state) {
  measure(state,
          [](const auto& tri, const auto& skeleton) { return algebra::dual_presentation(tri, skeleton); });
}
void simplified_group(benchmark::State& state) {
  measure(state, [](const auto& tri, const auto& skeleton) {
    return algebra::simplified(algebra::dual_presentation(tri, skeleton).presentation);
  });
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgsProduct({{torus, renamed_torus, ball, random_closed}, {6, 12, 26, 55}})
      ->Unit(benchmark::kMillisecond);
}
BENCHMARK(h1)->Apply(sizes);
BENCHMARK(h1_relative)->Apply(sizes);
BENCHMARK(presentation)->Apply(sizes);
BENCHMARK(simplified_group)->Apply(sizes);

} // namespace

BENCHMARK_MAIN();
