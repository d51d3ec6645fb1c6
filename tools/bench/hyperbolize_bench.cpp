// SPDX-License-Identifier: GPL-2.0-or-later

/// Structures per second, and what one tetrahedron costs.
///
/// The list is tests/oracle/false_convergence_3.txt: 170 gluings of three tetrahedra, 167 of which have a
/// structure. "items" are gluings; the skeleton is computed beforehand unless the name says otherwise.

#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/cosine_laws.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/hyperbolic/volume.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <benchmark/benchmark.h>
#include <fstream>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;

namespace {

struct Gluing3 {
  Triangulation tri;
  Skeleton skeleton;
  Hyperbolization<double> structure;
};

/// Those with a structure.
const std::vector<Gluing3>& gluings() {
  static const std::vector<Gluing3> list = [] {
    std::vector<Gluing3> found;
    std::ifstream in(std::string(TETRARCH_SOURCE_DIR) + "/tests/oracle/false_convergence_3.txt");
    for (std::string line; std::getline(in, line);) {
      Triangulation tri = from_signature(line);
      Skeleton skeleton(tri);
      auto structure = hyperbolize(tri, skeleton);
      if (structure.outcome == Outcome::geometric)
        found.push_back({std::move(tri), std::move(skeleton), std::move(structure)});
    }
    return found;
  }();
  return list;
}

template <class Work>
void over_all_gluings(benchmark::State& state, Work work) {
  const auto& list = gluings();
  for (auto _ : state)
    for (const Gluing3& g : list) work(g);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * list.size()));
}

void newton(benchmark::State& state) {
  over_all_gluings(state, [](const Gluing3& g) { benchmark::DoNotOptimize(hyperbolize(g.tri, g.skeleton)); });
}
BENCHMARK(newton)->Unit(benchmark::kMillisecond);

void skeleton_and_newton(benchmark::State& state) {
  over_all_gluings(state,
                   [](const Gluing3& g) { benchmark::DoNotOptimize(hyperbolize(g.tri, Skeleton(g.tri))); });
}
BENCHMARK(skeleton_and_newton)->Unit(benchmark::kMillisecond);

void luo_flow(benchmark::State& state) {
  HyperbolizeOptions options;
  options.method = Method::flow;
  over_all_gluings(
      state, [&](const Gluing3& g) { benchmark::DoNotOptimize(hyperbolize(g.tri, g.skeleton, options)); });
}
BENCHMARK(luo_flow)->Unit(benchmark::kMillisecond);

void refine_to_60_digits(benchmark::State& state) {
  over_all_gluings(state, [](const Gluing3& g) {
    benchmark::DoNotOptimize(refine<numeric::Real50>(g.skeleton, g.structure));
  });
}
BENCHMARK(refine_to_60_digits)->Unit(benchmark::kMillisecond);

template <class Scalar>
SixNumbers<Scalar> some_lengths() {
  return {Scalar(1), Scalar(1.1), Scalar(1.2), Scalar(0.9), Scalar(0.8), Scalar(1.05)};
}

template <class Scalar>
void angles_from_lengths(benchmark::State& state) {
  SixNumbers<Scalar> lengths = some_lengths<Scalar>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(lengths);
    benchmark::DoNotOptimize(extended_dihedral_angles(lengths, all_hyperideal));
  }
}
BENCHMARK(angles_from_lengths<double>);
BENCHMARK(angles_from_lengths<numeric::Real50>);

template <class Scalar>
void angles_by_laws(benchmark::State& state) {
  SixNumbers<Scalar> lengths = some_lengths<Scalar>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(lengths);
    benchmark::DoNotOptimize(angles_by_cosine_laws(lengths));
  }
}
BENCHMARK(angles_by_laws<double>);

template <class Scalar>
void jacobian(benchmark::State& state) {
  SixNumbers<Scalar> lengths = some_lengths<Scalar>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(lengths);
    benchmark::DoNotOptimize(angle_jacobian(lengths, all_hyperideal));
  }
}
BENCHMARK(jacobian<double>);
BENCHMARK(jacobian<numeric::Real50>);

template <class Scalar>
void one_volume(benchmark::State& state) {
  SixNumbers<Scalar> angles = extended_dihedral_angles(some_lengths<Scalar>(), all_hyperideal);
  for (auto _ : state) {
    benchmark::DoNotOptimize(angles);
    benchmark::DoNotOptimize(volume(angles));
  }
}
BENCHMARK(one_volume<double>);
BENCHMARK(one_volume<numeric::Real50>);

} // namespace

BENCHMARK_MAIN();
