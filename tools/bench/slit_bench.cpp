// SPDX-License-Identifier: GPL-2.0-or-later

/// Slit maps: everything from a mesh in memory to its concentric domain, beside what cannot be saved.
///
/// That is the bare job: one Cholesky factorisation of the same Laplacian, with the loops held, by CHOLMOD
/// as it comes (Eigen where the library was built without CHOLMOD), and the solution for the n right-hand
/// sides of n + 1 loops. The matrix is made before the clock starts, and nothing of ours is in it.
///
/// ratio      our processor time over that of the bare job; at most 3 is wanted
/// ratio_amd  the same where CHOLMOD is told to order by AMD only, which it finds out by itself on small
///            meshes; on large ones it takes METIS, which costs more time than it saves for one use
/// ratio_wall as `ratio`, by the clock on the wall. The bare job has the threads that CHOLMOD and OpenBLAS
///            take; ours has one, for the same bytes on all machines.

#include "support/planar_domains.hpp"
#include "support/random.hpp"
#include "tetrarch/slit/slit_map.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>
#include <chrono>
#include <ctime>
#include <numeric>
#ifdef TETRARCH_HAS_CHOLMOD
#include <cholmod.h>
#else
#include <Eigen/SparseCholesky>
#endif

namespace {

using namespace tetrarch;
using Matrix = Eigen::SparseMatrix<double>;

/// The same domain with triangles and vertices named at random, as files of other programs may have them.
surface::TriangleMesh shuffled(const surface::TriangleMesh& mesh) {
  support::Random random(1);
  const auto permutation = [&](std::size_t size) {
    std::vector<int> names(size);
    std::iota(names.begin(), names.end(), 0);
    for (std::size_t k = size; k > 1; --k) std::swap(names[k - 1], names[random.below(static_cast<int>(k))]);
    return names;
  };
  const std::vector<int> name = permutation(mesh.points.size());
  format::Soup soup;
  soup.points.resize(mesh.points.size());
  for (std::size_t v = 0; v < name.size(); ++v) soup.points[name[v]] = mesh.points[v];
  for (const int t : permutation(mesh.surface.triangles().size())) {
    const auto& [a, b, c] = mesh.surface.corners(t);
    soup.triangles.push_back({name[a], name[b], name[c]});
  }
  return doctor::build_surface(std::move(soup));
}

/// A ring of modulus 2 with loops - 2 slits of a sixth of a turn, and about so many triangles.
surface::TriangleMesh domain(int triangles, int loops, bool shuffle) {
  support::CylinderGrid grid;
  grid.height = 2;
  // Squares: sectors / rings = 2 pi / height.
  grid.rings = static_cast<int>(std::sqrt(triangles / (2 * std::numbers::pi)));
  grid.sectors = static_cast<int>(triangles / (2.0 * grid.rings));
  for (int k = 1; k <= loops - 2; ++k)
    grid.cracks.push_back({grid.rings * k / (loops - 1), grid.sectors * k / loops, grid.sectors / 6});
  surface::TriangleMesh mesh = support::slit_ring(grid, [](std::complex<double> z) { return z; }).mesh;
  return shuffle ? shuffled(mesh) : mesh;
}

/// The Laplacian with the loops held, and for each loop but one the right-hand side of its potential.
struct System {
  Matrix lower;
  Eigen::MatrixXd right;
};

System system_of(const surface::TriangleMesh& mesh) {
  const surface::Surface& surface = mesh.surface;
  const auto loops = surface::boundary_loops(mesh);
  std::vector<int> loop(mesh.points.size(), -1);
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const surface::SideEnd e : loops[k].sides) loop[surface.vertex(e)] = static_cast<int>(k);
  std::vector<int> unknown(mesh.points.size(), -1);
  int count = 0;
  for (std::size_t v = 0; v < loop.size(); ++v)
    if (loop[v] < 0) unknown[v] = count++;
  System system{Matrix(count, count), Eigen::MatrixXd::Zero(count, static_cast<int>(loops.size()) - 1)};
  std::vector<Eigen::Triplet<double>> entries;
  const auto weight = surface::half_cotangents(mesh);
  for (int k = 0; k < surface.side_count(); ++k) {
    const int v = surface.from(surface::Side(k));
    const int u = surface.to(surface::Side(k));
    for (const auto& [here, there] : {std::pair(v, u), std::pair(u, v)}) {
      if (unknown[here] < 0) continue;
      entries.emplace_back(unknown[here], unknown[here], weight[k]);
      if (loop[there] > 0) system.right(unknown[here], loop[there] - 1) += weight[k];
    }
    if (unknown[v] >= 0 && unknown[u] >= 0)
      entries.emplace_back(std::max(unknown[v], unknown[u]), std::min(unknown[v], unknown[u]), -weight[k]);
  }
  system.lower.setFromTriplets(entries.begin(), entries.end());
  return system;
}

#ifdef TETRARCH_HAS_CHOLMOD
void bare(System& system, bool amd_only) {
  cholmod_common common;
  cholmod_start(&common);
  if (amd_only) {
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
  }
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(system.lower.rows());
  matrix.nzmax = static_cast<std::size_t>(system.lower.nonZeros());
  matrix.p = system.lower.outerIndexPtr();
  matrix.i = system.lower.innerIndexPtr();
  matrix.x = system.lower.valuePtr();
  matrix.stype = -1;
  matrix.xtype = CHOLMOD_REAL;
  matrix.sorted = matrix.packed = 1;
  cholmod_dense right{};
  right.nrow = right.d = matrix.nrow;
  right.ncol = static_cast<std::size_t>(system.right.cols());
  right.nzmax = right.nrow * right.ncol;
  right.x = system.right.data();
  right.xtype = CHOLMOD_REAL;
  cholmod_factor* factor = cholmod_analyze(&matrix, &common);
  cholmod_factorize(&matrix, factor, &common);
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, &right, &common);
  benchmark::DoNotOptimize(solution->x);
  cholmod_free_dense(&solution, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
}
#else
/// Eigen has AMD only.
void bare(System& system, bool) {
  const Eigen::SimplicialLDLT<Matrix> solver(system.lower);
  benchmark::DoNotOptimize(solver.solve(system.right).eval().data());
}
#endif

struct Seconds {
  double processor = 0;
  double wall = 0;
};

template <class Job>
void add_time(Seconds& sum, const Job& job) {
  const std::clock_t processor = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  job();
  sum.processor += static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  sum.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
}

void concentric_domain(benchmark::State& state) {
  const surface::TriangleMesh mesh =
      domain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), state.range(2) != 0);
  System system = system_of(mesh);
  Seconds ours;
  Seconds bare_default;
  Seconds bare_amd;
  for (auto _ : state) {
    Seconds before = ours;
    surface::TriangleMesh copy = mesh;
    add_time(ours, [&] {
      const slit::OneForms forms(std::move(copy));
      const slit::SlitMap map = slit::slit_map(forms, 0, 1);
      std::vector<std::complex<double>> place;
      for (int v = 0; v < forms.mesh().surface.vertex_count(); ++v) place.push_back(map.concentric(v));
      benchmark::DoNotOptimize(place.data());
    });
    add_time(bare_default, [&] { bare(system, false); });
    add_time(bare_amd, [&] { bare(system, true); });
    state.SetIterationTime(ours.wall - before.wall);
  }
  const auto iterations = static_cast<double>(state.iterations());
  state.counters["triangles"] = mesh.surface.triangle_count();
  state.counters["processor_ms"] = 1000 * ours.processor / iterations;
  state.counters["bare_ms"] = 1000 * bare_default.processor / iterations;
  state.counters["ratio"] = ours.processor / bare_default.processor;
  state.counters["ratio_amd"] = ours.processor / bare_amd.processor;
  state.counters["ratio_wall"] = ours.wall / bare_default.wall;
}
BENCHMARK(concentric_domain)
    ->ArgNames({"triangles", "loops", "shuffled"})
    ->ArgsProduct({{30'000, 300'000, 3'000'000}, {3, 5, 9}, {0, 1}})
    // The sizes of the dissertation's table 2.2.
    ->ArgsProduct({{4'000, 8'000, 16'000, 30'000}, {3}, {1}})
    ->ArgsProduct({{8'000}, {5, 7, 9}, {1}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
