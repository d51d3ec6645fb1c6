// SPDX-License-Identifier: GPL-2.0-or-later
/// Direct products of pipes, floor and ceiling their cylinders: 36 n^3 tetrahedra for n = 10, 20 and 30, the
/// last about a million. `Field` against `BareSolver`: conjugate gradients with an incomplete Cholesky factor
/// on the matrix that is ready, by Eigen alone. Fibres a second: items of `Fibers`, by threads; they go from
/// each vertex to the floor. Counter `bytes`: what the process holds at most.

#include "product/solids.hpp"
#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/product.hpp"
#include "tetrarch/solid/edge_weights.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <benchmark/benchmark.h>
#include <map>
#include <memory>
#include <sys/resource.h>

namespace {

using namespace tetrarch;
using namespace tetrarch::product;

struct Made {
  Solid solid;
  Partition partition;
  std::vector<double> w;
};

const Made& made(int n) {
  static std::map<int, Made> all;
  const auto found = all.find(n);
  if (found != all.end()) return found->second;
  const support::Extrusion from = support::radial_pipe(0.5, n);
  Made m{solid_of(from.mesh), {}, {}};
  m.partition = partition(m.solid, support::bases(m.solid, from));
  m.w = harmonic_field(m.solid, m.partition).w;
  return all.emplace(n, std::move(m)).first->second;
}

void note_size(benchmark::State& state, const Made& m) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["tetrahedra"] = m.solid.size();
  state.counters["bytes"] = 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void SolidOfMesh(benchmark::State& state) {
  const Made& m = made(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(solid_of(m.solid.mesh));
  note_size(state, m);
}

void Field(benchmark::State& state) {
  const Made& m = made(static_cast<int>(state.range(0)));
  FieldOptions options;
  options.solver = FieldOptions::Solver::iterative;
  int iterations = 0;
  for (auto _ : state) iterations = harmonic_field(m.solid, m.partition, options).iterations;
  state.counters["iterations"] = iterations;
  note_size(state, m);
}

void BareSolver(benchmark::State& state) {
  const Made& m = made(static_cast<int>(state.range(0)));
  const std::vector<int> base = bases_of_vertices(m.solid, m.partition);
  std::vector<int> unknown(base.size(), -1);
  int size = 0;
  for (std::size_t v = 0; v < base.size(); ++v)
    if (base[v] < 0) unknown[v] = size++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (const solid::WeightedEdge& e : solid::edge_weights(m.solid.mesh)) {
    const int a = unknown[e.from];
    const int b = unknown[e.to];
    if (a >= 0) entries.emplace_back(a, a, e.weight);
    if (b >= 0) entries.emplace_back(b, b, e.weight);
    if (a >= 0 && b >= 0) entries.emplace_back(b, a, -e.weight);
    if (a >= 0 && base[e.to] == ceiling_patch) right[a] += e.weight;
    if (b >= 0 && base[e.from] == ceiling_patch) right[b] += e.weight;
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::IncompleteCholesky<double>>
      solver;
  solver.setTolerance(FieldOptions().tolerance);
  for (auto _ : state) {
    solver.compute(matrix);
    const Eigen::VectorXd x = solver.solve(right);
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["iterations"] = static_cast<double>(solver.iterations());
}

void Critical(benchmark::State& state) {
  const Made& m = made(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(critical_places(m.solid, m.partition, m.w));
}

void Fibers(benchmark::State& state) {
  const Made& m = made(static_cast<int>(state.range(0)));
  const FloorMap floor = floor_map(m.solid, m.partition);
  const FiberField field(m.solid, m.partition, m.w);
  for (auto _ : state) benchmark::DoNotOptimize(coordinates(field, floor, static_cast<int>(state.range(1))));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(m.w.size()));
  note_size(state, m);
}

BENCHMARK(SolidOfMesh)->Arg(10)->Arg(20)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Field)->Arg(10)->Arg(20)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BareSolver)->Arg(10)->Arg(20)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Critical)->Arg(10)->Arg(20)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Fibers)
    ->ArgsProduct({{10, 20, 30}, {1, 2}})
    ->ArgNames({"n", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
