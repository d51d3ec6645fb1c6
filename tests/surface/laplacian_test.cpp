// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/laplacian.hpp"

#include "support/planar_domains.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::doctor;
using namespace tetrarch::support;

TriangleMesh triangles(std::vector<std::array<double, 3>> points, std::vector<Surface::Triangle> corners) {
  format::Soup soup;
  soup.points = std::move(points);
  soup.triangles = std::move(corners);
  return build_surface(std::move(soup));
}

/// A flat ring with inner vertices at no regular places.
TriangleMesh flat_ring() {
  CylinderGrid grid;
  grid.rings = 5;
  grid.sectors = 12;
  return slit_ring(grid, [](std::complex<double> z) { return z; }).mesh;
}

std::vector<char> boundary_vertices(const TriangleMesh& mesh) {
  std::vector<char> held(mesh.points.size(), 0);
  for (const auto& curve : boundary_curves(mesh.surface))
    for (const SideEnd e : curve) held[mesh.surface.vertex(e)] = 1;
  return held;
}

/// 3x - 2y + 1.
std::vector<double> linear_function(const TriangleMesh& mesh) {
  std::vector<double> f;
  for (const auto& p : mesh.points) f.push_back(3 * p[0] - 2 * p[1] + 1);
  return f;
}

TEST_CASE("Half the cotangents of triangles known from school") {
  // Half a square: 90, 45, 45 degrees; the cotangents are 0, 1, 1.
  const auto square = half_cotangents(triangles({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}));
  CHECK(square[0] == Approx(0).margin(1e-15));
  CHECK(square[1] == Approx(0.5).epsilon(1e-15));
  CHECK(square[2] == Approx(0.5).epsilon(1e-15));
  // 120, 30, 30 degrees: -1/sqrt(3), sqrt(3), sqrt(3).
  const auto obtuse =
      half_cotangents(triangles({{0, 0, 5}, {1, 0, 5}, {-0.5, std::sqrt(0.75), 5}}, {{0, 1, 2}}));
  CHECK(obtuse[0] == Approx(-0.5 / std::sqrt(3.0)).epsilon(1e-14));
  CHECK(obtuse[1] == Approx(0.5 * std::sqrt(3.0)).epsilon(1e-14));
  CHECK(obtuse[2] == Approx(0.5 * std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE(
    "On a flat mesh linear functions are harmonic, and their energy is the area times the squared slope") {
  const TriangleMesh ring = flat_ring();
  const auto weight = half_cotangents(ring);
  const auto f = linear_function(ring);
  const auto flux = fluxes(ring.surface, weight, f);
  const auto on_boundary = boundary_vertices(ring);
  for (std::size_t v = 0; v < flux.size(); ++v)
    if (!on_boundary[v]) CHECK(std::abs(flux[v]) < 1e-13);
  // A 12-gon of circumradius r has area 3 r^2 (twelve triangles of r^2 sin(30) / 2); the slope squared is 13.
  const double area = 3 * (1 - std::exp(-2.0));
  CHECK(std::inner_product(f.begin(), f.end(), flux.begin(), 0.0) == Approx(13 * area).epsilon(1e-13));
  CHECK(std::accumulate(flux.begin(), flux.end(), 0.0) == Approx(0).margin(1e-12));
}

TEST_CASE("Held on the boundary, a linear function is found again; several functions are one factorisation") {
  const TriangleMesh ring = flat_ring();
  const auto f = linear_function(ring);
  const auto held = boundary_vertices(ring);
  LaplaceSolver::Columns data(2, std::vector<double>(f.size(), 0.0));
  for (std::size_t v = 0; v < f.size(); ++v)
    if (held[v]) {
      data[0][v] = f[v];
      data[1][v] = 7;
    }
  const auto found = LaplaceSolver(ring.surface, half_cotangents(ring), held).solve(data);
  for (std::size_t v = 0; v < f.size(); ++v) {
    CHECK(found[0][v] == Approx(f[v]).margin(1e-13));
    CHECK(found[1][v] == Approx(7).epsilon(1e-13));
  }
}

TEST_CASE("A function has the fluxes that it was loaded with, and the values that it was held at") {
  const TriangleMesh ring = flat_ring();
  const auto weight = half_cotangents(ring);
  std::vector<char> held(ring.points.size(), 0);
  held[3] = 1;
  std::vector<double> data(held.size());
  for (std::size_t v = 0; v < data.size(); ++v) data[v] = std::cos(5.0 * static_cast<double>(v));
  const auto f = LaplaceSolver(ring.surface, weight, held).solve({data}).front();
  const auto flux = fluxes(ring.surface, weight, f);
  for (std::size_t v = 0; v < data.size(); ++v)
    CHECK((held[v] ? f[v] : flux[v]) == Approx(data[v]).margin(1e-12));
}

TEST_CASE("Other vertices held with the same analysis give what a new solver gives") {
  const TriangleMesh ring = flat_ring();
  const auto weight = half_cotangents(ring);
  std::vector<char> one(ring.points.size(), 0);
  one[3] = 1;
  const auto all = boundary_vertices(ring);
  std::vector<double> data(one.size());
  for (std::size_t v = 0; v < data.size(); ++v) data[v] = std::cos(5.0 * static_cast<double>(v));
  LaplaceSolver solver(ring.surface, weight, one);
  const auto before = solver.solve({data});
  solver.hold(all);
  CHECK(solver.solve({data}) == LaplaceSolver(ring.surface, weight, all).solve({data}));
  solver.hold(one);
  CHECK(solver.solve({data}) == before);
  CHECK_THROWS_AS(solver.hold({1}), PreconditionError);
}

TEST_CASE(
    "Many right-hand sides, and large meshes, for which factors are made by blocks, keep their fluxes") {
  CylinderGrid grid;
  grid.rings = 60;
  grid.sectors = 200;
  const TriangleMesh ring = slit_ring(grid, [](std::complex<double> z) { return z; }).mesh;
  const auto weight = half_cotangents(ring);
  const auto held = boundary_vertices(ring);
  LaplaceSolver::Columns data(11, std::vector<double>(held.size()));
  for (std::size_t k = 0; k < data.size(); ++k)
    for (std::size_t v = 0; v < held.size(); ++v) data[k][v] = std::cos(static_cast<double>((k + 1) * v));
  const LaplaceSolver solver(ring.surface, weight, held);
  const auto found = solver.solve(data);
  for (std::size_t k = 0; k < data.size(); ++k) {
    const auto flux = fluxes(ring.surface, weight, found[k]);
    double worst = 0;
    for (std::size_t v = 0; v < held.size(); ++v)
      worst = std::max(worst, std::abs((held[v] ? found[k][v] : flux[v]) - data[k][v]));
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("Two edges between the same two vertices add up, and an edge from a vertex to itself is none") {
  // A cone over a digon: triangles 0 and 1 share two edges at the apex; its base has two edges, both between
  // the same two vertices. All angles are taken as 60 degrees.
  Table<Side, Side> mate(6);
  mate[Side(0, 0)] = Side(1, 1);
  mate[Side(1, 1)] = Side(0, 0);
  mate[Side(0, 1)] = Side(1, 0);
  mate[Side(1, 0)] = Side(0, 1);
  const Surface cone(mate);
  REQUIRE(cone.vertex_count() == 3);
  const std::vector<double> weight(6, 0.5 / std::sqrt(3.0));
  const int apex = cone.apex(Side(0, 2));
  std::vector<char> held(3, 0);
  held[cone.from(Side(0, 2))] = 1;
  std::vector<double> data(3, 0.25);
  const auto f = LaplaceSolver(cone, weight, held).solve({data}).front();
  const auto flux = fluxes(cone, weight, f);
  for (int v = 0; v < 3; ++v) CHECK((held[v] ? f[v] : flux[v]) == Approx(0.25).epsilon(1e-14));
  CHECK(held[apex] == 0);
}

TEST_CASE("Weights without a positive definite Laplacian are refused") {
  const TriangleMesh one = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(LaplaceSolver(one.surface, {-1, -1, -1}, {1, 0, 0}), InputError);
  CHECK_THROWS_AS(LaplaceSolver(one.surface, {0, 0, 0}, {1, 0, 0}), InputError);
}

TEST_CASE("Where all vertices are held there is nothing to solve") {
  const TriangleMesh one = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const LaplaceSolver::Columns data{{4, 5, 6}};
  CHECK(LaplaceSolver(one.surface, half_cotangents(one), {1, 1, 1}).solve(data) == data);
}

TEST_CASE("Triangles without area, functions held nowhere and lists of wrong length are refused") {
  const TriangleMesh flat = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK_THROWS_AS(half_cotangents(flat), InputError);
  CHECK_THROWS_WITH(half_cotangents(flat), Catch::Contains("triangle 1 (counted from 0)"));
  const TriangleMesh one = triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto weight = half_cotangents(one);
  CHECK_THROWS_AS(LaplaceSolver(one.surface, weight, {0, 0, 0}), PreconditionError);
  CHECK_THROWS_AS(LaplaceSolver(one.surface, weight, {1, 0}), PreconditionError);
  CHECK_THROWS_AS(LaplaceSolver(one.surface, weight, {1, 0, 0}).solve({{1, 2}}), PreconditionError);
}

} // namespace
