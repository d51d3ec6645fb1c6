// SPDX-License-Identifier: GPL-2.0-or-later
// What the core costs: skeletons of 10^3 to 10^6 tetrahedra, signatures of 10^2 to 10^4, walking.
//
// Four families, because no single one is typical. Random gluings have short edges' classes nowhere and
// hardly any locality: a skeleton pays for cache misses, a signature is decided after a few letters. Cubical
// balls and tori are as local as meshes are; a torus is as symmetric as can be, which is where signatures
// could become quadratic. A torus with one tetrahedron cut open has no symmetry but looks alike from afar:
// the worst that we know.
#include "support/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <benchmark/benchmark.h>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

/// Cubes along each side so that there are about `tets` tetrahedra, at least 1.
int side(std::int64_t tets) {
  return std::max(1, static_cast<int>(std::lround(std::cbrt(static_cast<double>(tets) / 6))));
}

Triangulation ball(std::int64_t tets) {
  const int k = side(tets);
  return cubical_ball(k, k, k);
}

Triangulation torus(std::int64_t tets) {
  const int k = side(tets);
  return cubical_torus(k, k, k);
}

/// A torus with one gluing undone.
Triangulation marked_torus(std::int64_t tets) {
  Triangulation tri = torus(tets);
  tri.unglue({0, 0});
  return tri;
}

/// A torus with one gluing turned by a third: closed, and the odd spot shows itself only when it is reached.
Triangulation twisted_torus(std::int64_t tets) {
  Triangulation tri = torus(tets);
  const Gluing g = tri.gluing({0, 0});
  tri.unglue({0, 0});
  tri.glue({0, 0}, g.tet, g.perm * Perm4(0, 2, 3, 1));
  return tri;
}

Triangulation random_closed(std::int64_t tets) {
  Random random(1);
  RandomGluing wanted;
  wanted.tets = static_cast<int>(tets);
  return random_gluing(wanted, random);
}

/// Tetrahedra in a ring, each glued to the next by two faces, like a layered loop or the bundle of a
/// punctured torus over the circle; the maps follow a word without symmetry. All labellings agree in the
/// first two streams of a signature (which tetrahedra are neighbours) and differ in the third only.
Triangulation ring(std::int64_t tets) {
  Random random(3);
  Triangulation tri(static_cast<int>(tets));
  for (int t = 0; t < tri.size(); ++t) {
    const int next = (t + 1) % tri.size();
    tri.glue({t, 2}, next, random.below(2) == 0 ? Perm4(1, 2, 0, 3) : Perm4(2, 1, 0, 3));
    tri.glue({t, 3}, next, random.below(2) == 0 ? Perm4(0, 2, 3, 1) : Perm4(2, 0, 3, 1));
  }
  return tri;
}

using Family = Triangulation (*)(std::int64_t);

void skeleton(benchmark::State& state, Family family) {
  const Triangulation tri = family(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Skeleton(tri));
  state.SetItemsProcessed(state.iterations() * tri.size());
  state.counters["tetrahedra"] = tri.size();
}

void name(benchmark::State& state, Family family) {
  Random random(2);
  Triangulation tri = family(state.range(0));
  tri = relabelled(tri, random_relabelling(tri.size(), random)); // so that no lucky labelling comes first
  for (auto _ : state) benchmark::DoNotOptimize(signature(tri));
  state.SetItemsProcessed(state.iterations() * tri.size());
  state.counters["tetrahedra"] = tri.size();
}

/// All t-edges around every edge, by steps.
void walking(benchmark::State& state, Family family) {
  const Triangulation tri = family(state.range(0));
  for (auto _ : state) {
    long steps = 0;
    for (int t = 0; t < tri.size(); ++t)
      for (const auto& [a, b] : edge_vertex) {
        const Walk start{t, edge_frame(a, b)};
        Walk w = start;
        do ++steps;
        while (w.step_left(tri) && w != start && steps % 16 != 0);
      }
    benchmark::DoNotOptimize(steps);
    state.counters["steps/s"] =
        benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsIterationInvariantRate);
  }
}

void decoding(benchmark::State& state) {
  const std::string text = signature(random_closed(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(from_signature(text));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

} // namespace

BENCHMARK_CAPTURE(skeleton, ball, ball)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skeleton, torus, torus)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skeleton, random, random_closed)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, random, random_closed)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, ball, ball)->RangeMultiplier(10)->Range(100, 10000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, torus, torus)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(3072)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, marked_torus, marked_torus)
    ->Arg(1000)
    ->Arg(3072)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, twisted_torus, twisted_torus)
    ->Arg(1000)
    ->Arg(3072)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(name, ring, ring)->Arg(300)->Arg(1000)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walking, torus, torus)->Arg(1000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(decoding)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
