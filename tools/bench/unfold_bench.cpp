// SPDX-License-Identifier: GPL-2.0-or-later
/// Foldings of a box of n^3 cubes, six tetrahedra each, its boundary fixed: n = 10 to 55 are 6,000 to 998,250
/// tetrahedra. `Energy` is one value with its gradient; `Unfold` goes from points that are up to an edge's
/// length off, where about a third of the tetrahedra is turned over, to none. Counter `bytes`: what the
/// process holds at most.

#include "support/random.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <array>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <sys/resource.h>
#include <vector>

namespace {

using namespace tetrarch;
using namespace tetrarch::unfold;
using numeric::operator-;

struct Folded {
  Problem problem;
  std::vector<Point> points;
};

Folded folded_box(int n) {
  Folded box;
  support::Random random(7);
  std::vector<Point> flat;
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        const bool is_outside = x == 0 || y == 0 || z == 0 || x == n || y == n || z == n;
        box.problem.freedom.push_back({is_outside ? Freedom::Kind::fixed : Freedom::Kind::free, {}});
        flat.push_back({1.0 * x, 1.0 * y, 1.0 * z});
        box.points.push_back(flat.back());
        for (double& c : box.points.back())
          if (!is_outside) c += 2 * random.uniform() - 1;
      }
  constexpr std::array<std::array<int, 4>, 6> six{
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  const auto at = [n](int x, int y, int z) { return x + (n + 1) * (y + (n + 1) * z); };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (const auto& tet : six) {
          std::array<int, 4> v{};
          for (std::size_t k = 0; k < 4; ++k)
            v[k] = at(x + (tet[k] & 1), y + (tet[k] >> 1 & 1), z + (tet[k] >> 2));
          const Point o = flat[v[0]];
          box.problem.elements.push_back(element(v, {flat[v[1]] - o, flat[v[2]] - o, flat[v[3]] - o}));
        }
  return box;
}

void note(benchmark::State& state, const Folded& box) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["tetrahedra"] = static_cast<double>(box.problem.elements.size());
  state.counters["bytes"] = 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void Energy(benchmark::State& state) {
  const Folded box = folded_box(static_cast<int>(state.range(0)));
  std::vector<Vector> gradient;
  for (auto _ : state) benchmark::DoNotOptimize(energy(box.problem.elements, box.points, 0.5, 1, &gradient));
  note(state, box);
}
BENCHMARK(Energy)->Arg(10)->Arg(25)->Arg(55)->Unit(benchmark::kMillisecond);

void Unfold(benchmark::State& state) {
  const Folded box = folded_box(static_cast<int>(state.range(0)));
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
