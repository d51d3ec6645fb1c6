// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/intrinsic_delaunay.hpp"

#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/laplacian.hpp"
#include "tetrarch/surface/refine.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

TriangleMesh mesh_of(const TriangleList& list) {
  return {list.points, list.surface()};
}

/// A square grid in the plane, with random flips and splits: full of obtuse angles.
TriangleMesh bad_square(Random& random) {
  constexpr int n = 6;
  TriangleList list;
  list.vertices = n * n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      list.points.push_back({i + 0.4 * random.uniform(), 3 * (j + 0.4 * random.uniform()), 0});
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j + 1 < n; ++j) {
      const int v = i * n + j;
      list.triangles.push_back({v, v + n, v + n + 1});
      list.triangles.push_back({v, v + n + 1, v + 1});
    }
  return mesh_of(retriangulated(list, random, 0, 40));
}

double energy(const Surface& surface, const std::vector<double>& weight, const std::vector<double>& f) {
  const std::vector<double> flux = fluxes(surface, weight, f);
  return std::inner_product(f.begin(), f.end(), flux.begin(), 0.0);
}

void check_no_negative_edge(const IntrinsicTriangulation& t) {
  CHECK(t.is_delaunay);
  const std::vector<double> weight = half_cotangents(t);
  for (int k = 0; k < t.surface.side_count(); ++k)
    if (const Side m = t.surface.mate(Side(k)); m.exists()) CHECK(weight[k] + weight[m.value] > -1e-9);
}

TEST_CASE("In the plane, lengths stay the distances between vertices, and flips lower the energy") {
  Random random(1);
  for (int round = 0; round < 10; ++round) {
    const TriangleMesh mesh = bad_square(random);
    const IntrinsicTriangulation t = intrinsic_delaunay(mesh);
    CHECK(t.flips > 0);
    check_no_negative_edge(t);
    for (int k = 0; k < t.surface.side_count(); ++k) {
      const auto& p = mesh.points[t.surface.from(Side(k))];
      const auto& q = mesh.points[t.surface.to(Side(k))];
      CHECK(t.length[k] == Approx(std::hypot(q[0] - p[0], q[1] - p[1])).epsilon(1e-12));
    }
    std::vector<double> f;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) f.push_back(random.uniform());
    CHECK(energy(t.surface, half_cotangents(t), f) < energy(mesh.surface, half_cotangents(mesh), f));
    // Linear functions are linear on any triangles: the energy is the area, half and half.
    for (std::size_t v = 0; v < f.size(); ++v) f[v] = mesh.points[v][0];
    CHECK(energy(t.surface, half_cotangents(t), f) ==
          Approx(energy(mesh.surface, half_cotangents(mesh), f)).epsilon(1e-12));
  }
}

TEST_CASE("In space too no edge is left with a negative weight, and mates have one length") {
  Random random(2);
  for (const TriangleList& list : {icosphere(1), torus_grid(6, 5), with_holes(torus_grid(8, 8), 3)}) {
    const TriangleMesh mesh = mesh_of(retriangulated(list, random, 0, 200));
    const IntrinsicTriangulation t = intrinsic_delaunay(mesh);
    check_no_negative_edge(t);
    CHECK(t.flips > 0);
    CHECK(type_of(t.surface).str() == type_of(mesh.surface).str());
    for (int k = 0; k < t.surface.side_count(); ++k)
      if (const Side m = t.surface.mate(Side(k)); m.exists()) CHECK(t.length[k] == t.length[m.value]);
  }
}

TEST_CASE("Closed forms are carried over: still closed, with the same periods") {
  Random random(3);
  const TriangleMesh mesh = bad_square(random);
  // Differences of an integer function: what is carried must be its differences still.
  std::vector<int> f;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) f.push_back(random.below(100));
  std::vector<std::vector<int>> forms(1);
  for (int k = 0; k < mesh.surface.side_count(); ++k)
    forms[0].push_back(f[mesh.surface.to(Side(k))] - f[mesh.surface.from(Side(k))]);
  const IntrinsicTriangulation t = intrinsic_delaunay(mesh, &forms);
  for (int k = 0; k < t.surface.side_count(); ++k)
    CHECK(forms[0][k] == f[t.surface.to(Side(k))] - f[t.surface.from(Side(k))]);
}

TEST_CASE("A triangle without area has no intrinsic triangulation") {
  const TriangleList flat{{{0, 1, 2}}, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, 3};
  CHECK_THROWS_AS(intrinsic_delaunay(mesh_of(flat)), InputError);
}

TEST_CASE("A refined mesh is the same surface with four triangles for each") {
  for (const TriangleList& list : {with_holes(torus_grid(8, 8), 3), cube_surface(), torus_grid(4, 5)}) {
    const TriangleMesh coarse = mesh_of(list);
    const TriangleMesh fine = refined(coarse);
    CHECK(fine.surface.triangle_count() == 4 * coarse.surface.triangle_count());
    CHECK(fine.surface.vertex_count() == coarse.surface.vertex_count() + coarse.surface.edge_count());
    CHECK(type_of(fine.surface).str() == type_of(coarse.surface).str());
    CHECK(orientation(fine.surface) ==
          std::vector<int>(static_cast<std::size_t>(fine.surface.triangle_count()), 1));
    // Small triangles are similar to the one that they are parts of, corner by corner.
    const std::vector<double> large = half_cotangents(coarse);
    const std::vector<double> small = half_cotangents(fine);
    for (int t = 0; t < coarse.surface.triangle_count(); ++t)
      for (int part = 0; part < 4; ++part)
        for (int c = 0; c < 3; ++c)
          CHECK(small[3 * (4 * t + part) + c] == Approx(large[3 * t + c]).epsilon(1e-12));
  }
}

} // namespace
