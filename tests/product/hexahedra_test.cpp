// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hexahedra.hpp"

#include "product/floors.hpp"
#include "product/solids.hpp"
#include "support/random.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/polycube.hpp"
#include "tetrarch/product/smooth.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace tetrarch;
using namespace tetrarch::product;
using support::Random;

namespace {

constexpr std::array<Point, 8> unit_cube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// n x n x n cubes.
HexMesh cubes(int n) {
  Polycube polycube;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) polycube.cubes.push_back({x, y, z});
  return hexahedra(polycube);
}

std::vector<char> outside(const HexMesh& mesh, int n) {
  std::vector<char> fixed;
  for (const Point& p : mesh.points)
    fixed.push_back(
        static_cast<char>(std::any_of(p.begin(), p.end(), [n](double x) { return x == 0 || x == n; })));
  return fixed;
}

void shake(HexMesh& mesh, const std::vector<char>& fixed, double by, int seed = 3) {
  Random random(seed);
  for (std::size_t v = 0; v < fixed.size(); ++v)
    for (double& x : mesh.points[v])
      if (fixed[v] == 0) x += by * (2 * random.uniform() - 1);
}

struct Made {
  SolidHexahedra hexahedra;
  FloorGrid grid;
  double worst_miss = 0;
};

/// On this floor.
Made made_on(const FloorMap& floor, const Solid& solid, const Partition& parts, int across,
             const HexOptions& options) {
  const FiberField field(solid, parts, harmonic_field(solid, parts).w);
  Made result;
  result.grid = floor_grid(floor.height, floor.rectangles, {across});
  const std::vector<FloorPoint> start = nodes_on_floor(solid, floor, result.grid);
  for (const FloorPoint& p : start) result.worst_miss = std::max(result.worst_miss, p.miss);
  result.hexahedra = hexahedra(field, result.grid, start, options);
  return result;
}

Made made(const support::Extrusion& from, int across, const HexOptions& options) {
  const Solid solid = product::solid_of(from.mesh);
  const Partition parts = partition(solid, support::bases(solid, from));
  FloorOptions rectangle;
  rectangle.domain = FloorDomain::rectangle;
  const FloorMap floor = floor_map(solid, parts, rectangle);
  REQUIRE(floor.found);
  return made_on(floor, solid, parts, across, options);
}

/// From a plate with square holes, whose plan is the rectangle.
Made made_from_plan(const support::Extrusion& plate, int across, const HexOptions& options) {
  const Solid solid = product::solid_of(plate.mesh);
  const Partition parts = partition(solid, support::bases(solid, plate));
  return made_on(support::floor_from_plan(solid, parts, plate), solid, parts, across, options);
}

/// Six times the volume of a tetrahedron.
double determinant(const Point& o, const Point& p, const Point& q, const Point& r) {
  std::array<Point, 3> e{p, q, r};
  for (Point& x : e)
    for (std::size_t a = 0; a < 3; ++a) x[a] -= o[a];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
         e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/// By six tetrahedra around the diagonal: exact for what has plane faces.
double volume_by_tetrahedra(const HexMesh& mesh) {
  constexpr std::array<std::array<int, 2>, 6> around{{{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}};
  double six = 0;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    const std::array<Point, 8> p = mesh.corners(h);
    for (const auto& [i, j] : around) six += determinant(p[0], p[i], p[j], p[6]);
  }
  return six / 6;
}

} // namespace

TEST_CASE("The scaled Jacobian of hexahedra made by hand", "[hexahedra]") {
  CHECK(scaled_jacobian(unit_cube) == Approx(1));
  std::array<Point, 8> p = unit_cube;
  for (Point& x : p) x = {2 * x[0], 3 * x[1], 0.5 * x[2] + 7};
  CHECK(scaled_jacobian(p) == Approx(1));
  // Sheared by 45 degrees: edges (1,0,0), (0,1,0), (1,0,1), so 1 / sqrt(2) at each corner.
  p = unit_cube;
  for (Point& x : p) x[0] += x[2];
  CHECK(scaled_jacobian(p) == Approx(std::sqrt(0.5)));
  // Bottom and top exchanged.
  p = unit_cube;
  for (Point& x : p) x[2] = -x[2];
  CHECK(scaled_jacobian(p) == Approx(-1));
  // Corner 6 moved to (t, t, t): det = 3 t - 2, edges of length sqrt(2 (1-t)^2 + t^2), worked out by hand.
  for (const double t : {0.9, 2.0 / 3, 0.5}) {
    p = unit_cube;
    p[6] = {t, t, t};
    CHECK(scaled_jacobian(p) ==
          Approx((3 * t - 2) / std::pow(2 * (1 - t) * (1 - t) + t * t, 1.5)).margin(1e-12));
  }
  // An edge without length.
  p = unit_cube;
  p[6] = p[5];
  CHECK(scaled_jacobian(p) == 0);
  // Turned by half a turn between bottom and top, corners are good by right angles of 1/sqrt(3) less; the
  // vectors in the middle are 0: only the middle tells.
  p = unit_cube;
  for (std::size_t c = 4; c < 8; ++c) p[c] = {1 - p[c][0], 1 - p[c][1], 1};
  CHECK(scaled_jacobian(p) == Approx(0).margin(1e-12));
}

TEST_CASE("Quality lists every bad hexahedron and counts all", "[hexahedra]") {
  HexMesh mesh = cubes(3);
  const HexQuality good = quality(mesh);
  CHECK(good.minimum == Approx(1));
  CHECK(good.histogram.back() == 27);
  CHECK(good.bad.empty());
  // A corner of the block pushed beyond the middle of its cube: t = 0.5 above.
  for (Point& p : mesh.points)
    if (p == Point{3, 3, 3}) p = {2.5, 2.5, 2.5};
  const HexQuality one = quality(mesh);
  REQUIRE(one.bad.size() == 1);
  CHECK(one.bad[0].scaled_jacobian == Approx(-0.5 / std::pow(0.75, 1.5)));
  CHECK(one.minimum == one.bad[0].scaled_jacobian);
  CHECK(one.bad[0].center[0] == Approx(2.5 - 0.5 / 8));
  CHECK(one.histogram[2] == 1); // -0.77 is in [-0.8, -0.7)
  CHECK(std::accumulate(one.histogram.begin(), one.histogram.end(), 0) == 27);
  CHECK(one.mean == Approx((26 + one.minimum) / 27));
}

TEST_CASE("The ten worst hexahedra are named, the worst first", "[hexahedra]") {
  HexMesh mesh = cubes(3);
  // All cubes are equal, up to nothing: the first by number.
  std::vector<BadHexahedron> worst = quality(mesh).worst;
  REQUIRE(worst.size() == worst_named);
  for (int k = 0; k < static_cast<int>(worst.size()); ++k) CHECK(worst[k].hexahedron == k);
  shake(mesh, std::vector<char>(mesh.points.size(), 0), 0.4);
  const HexQuality shaken = quality(mesh);
  std::vector<double> sorted = shaken.scaled_jacobian;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < worst_named; ++k) {
    CHECK(shaken.worst[k].scaled_jacobian == sorted[k]);
    CHECK(shaken.scaled_jacobian[shaken.worst[k].hexahedron] == sorted[k]);
  }
  CHECK(quality(cubes(2)).worst.size() == 8);
  CHECK(quality(HexMesh{}).worst.empty());
}

TEST_CASE("The volume of a trilinear cell is the integral of its Jacobian", "[hexahedra]") {
  CHECK(volume(unit_cube) == 1);
  CHECK(volume(cubes(3)) == 27);
  std::array<Point, 8> mirrored = unit_cube;
  for (Point& x : mirrored) x[2] = -x[2];
  CHECK(volume(mirrored) == -1);
  // The determinant has degree 2 in each variable, so two points of Gauss along each axis integrate it
  // exactly.
  Random random(5);
  const std::array<double, 2> at{0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)};
  for (int round = 0; round < 20; ++round) {
    std::array<Point, 8> p = unit_cube;
    for (Point& x : p)
      for (double& c : x) c += 1.5 * (random.uniform() - 0.5);
    double integral = 0;
    for (int g = 0; g < 8; ++g) {
      const Point t{at[g & 1], at[g >> 1 & 1], at[g >> 2]};
      std::array<Point, 4> e{}; // 0, and the derivatives along the axes
      for (std::size_t c = 0; c < 8; ++c)
        for (std::size_t a = 0; a < 3; ++a) {
          double weight = unit_cube[c][a] > 0 ? 1 : -1;
          for (std::size_t b = 0; b < 3; ++b)
            if (b != a) weight *= unit_cube[c][b] > 0 ? t[b] : 1 - t[b];
          for (std::size_t k = 0; k < 3; ++k) e[a + 1][k] += weight * p[c][k];
        }
      integral += determinant(e[0], e[1], e[2], e[3]) / 8;
    }
    CHECK(volume(p) == Approx(integral).margin(1e-12));
  }
}

TEST_CASE("On a box hexahedra are cuboids", "[hexahedra]") {
  const Made box = made(support::box({2, 1, 0.5}, {8, 4, 3}), 6, {4, 1});
  // 6 x 3 cells times 4 layers.
  CHECK(box.hexahedra.mesh.hexahedra.size() == 72);
  CHECK(box.hexahedra.mesh.points.size() == 7 * 4 * 5);
  CHECK(box.hexahedra.stuck.empty());
  CHECK(box.hexahedra.left_out == 0);
  const HexQuality q = quality(box.hexahedra.mesh);
  CHECK(q.minimum > 1 - 1e-6);
  CHECK(volume_by_tetrahedra(box.hexahedra.mesh) == Approx(1).epsilon(1e-8));
  // 5 x 2 nodes inside on 3 levels inside.
  CHECK(std::count(box.hexahedra.on_boundary.begin(), box.hexahedra.on_boundary.end(), 0) == 5 * 2 * 3);
}

TEST_CASE("On plates with rectangular holes all hexahedra are good", "[hexahedra]") {
  for (int holes = 1; holes <= 3; ++holes) {
    const Made plate = made_from_plan(support::plate(holes, 8, 3, support::Hole::square), 8 * holes, {3, 1});
    // 8 x 8 cells for each square, less 4 x 4 of its hole, and 3 layers.
    CHECK(plate.hexahedra.mesh.hexahedra.size() == static_cast<std::size_t>(48 * holes * 3));
    const HexQuality q = quality(plate.hexahedra.mesh);
    CHECK(q.minimum > 1 - 1e-5);
    CHECK(volume_by_tetrahedra(plate.hexahedra.mesh) == Approx(0.5 * 0.75 * holes).epsilon(1e-6));
    CHECK(plate.worst_miss < 1e-6);
  }
}

TEST_CASE("A plate with round holes, and a bent one, are filled, whatever the number of threads",
          "[hexahedra]") {
  for (const support::Extrusion& from : {support::plate(2, 8, 3), support::bent(1, 8, 4)}) {
    const Made one = made(from, 16, {4, 1});
    const Made two = made(from, 16, {4, 2});
    CHECK(one.hexahedra.stuck.empty());
    CHECK(one.hexahedra.mesh.hexahedra.size() == 4 * one.grid.cells.size());
    CHECK(one.hexahedra.mesh.points == two.hexahedra.mesh.points);
    CHECK(one.hexahedra.mesh.hexahedra == two.hexahedra.mesh.hexahedra);
    double six = 0;
    for (const auto& v : from.mesh.tetrahedra) {
      const auto& p = from.mesh.points;
      six += determinant(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    }
    CHECK(volume_by_tetrahedra(one.hexahedra.mesh) == Approx(six / 6).epsilon(0.02));
  }
}

TEST_CASE("A fibre that is stuck leaves out what is beside it, and is named", "[hexahedra]") {
  const auto from = support::box({2, 1, 1}, {8, 4, 4}, 0);
  const Solid solid = product::solid_of(from.mesh);
  const Partition parts = partition(solid, support::bases(solid, from));
  FloorOptions rectangle;
  rectangle.domain = FloorDomain::rectangle;
  const FloorMap floor = floor_map(solid, parts, rectangle);
  const FloorGrid grid = floor_grid(floor.height, floor.rectangles, {8});
  const std::vector<FloorPoint> start = nodes_on_floor(solid, floor, grid);
  // A summit in the middle of the box, at half its height; fibres are those of the gradient alone.
  std::vector<double> w;
  int summit = -1;
  for (std::size_t v = 0; v < from.at.size(); ++v) {
    w.push_back(from.at[v][2]);
    if (from.at[v] == std::array{1.0, 0.5, 0.5}) summit = static_cast<int>(v);
  }
  REQUIRE(summit >= 0);
  w[summit] = 0.9;
  const FiberField field(solid, parts, w, Direction::gradient);
  const SolidHexahedra result = hexahedra(field, grid, start, {4, 1});
  REQUIRE(!result.stuck.empty());
  for (const StuckNode& stuck : result.stuck) {
    CHECK(stuck.at == from.mesh.points[summit]);
    CHECK(stuck.level == 4); // 0.9 lies above the level 3/4 and below 1
  }
  CHECK(result.left_out > 0);
  CHECK(result.mesh.hexahedra.size() + result.left_out == 4 * grid.cells.size());
  for (const Hexahedron& h : result.mesh.hexahedra)
    for (const int v : h) REQUIRE((v >= 0 && v < static_cast<int>(result.mesh.points.size())));
}

TEST_CASE("Smoothing never lowers the minimum and leaves fixed points alone", "[hexahedra]") {
  const int n = 5;
  HexMesh mesh = cubes(n);
  const std::vector<char> fixed = outside(mesh, n);
  shake(mesh, fixed, 0.6);
  const HexMesh before = mesh;
  double minimum = quality(mesh).minimum;
  REQUIRE(minimum < 0);
  SmoothOptions one_sweep;
  one_sweep.most_sweeps = 1;
  for (int sweep = 0; sweep < 10; ++sweep) {
    const Smoothed step = smooth(mesh, fixed, one_sweep);
    CHECK(step.minimum_before == minimum);
    CHECK(step.minimum_after >= minimum);
    minimum = step.minimum_after;
  }
  CHECK(minimum > 0); // untangled
  for (std::size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v] != 0) CHECK(mesh.points[v] == before.points[v]);
  CHECK(mesh.hexahedra == before.hexahedra);

  HexMesh again = before;
  SmoothOptions ten;
  ten.most_sweeps = 10;
  const Smoothed all = smooth(again, fixed, ten);
  CHECK(all.minimum_after == quality(again).minimum);
  CHECK(all.bad_before > 0);
  CHECK(all.bad_after == 0);
}

TEST_CASE("However tangled, no sweep makes the worst hexahedron worse", "[hexahedra]") {
  for (int seed = 0; seed < 8; ++seed) {
    HexMesh mesh = cubes(3);
    const std::vector<char> fixed = outside(mesh, 3);
    shake(mesh, fixed, 0.3 + 0.3 * seed, seed);
    SmoothOptions one_sweep;
    one_sweep.most_sweeps = 1;
    for (int sweep = 0; sweep < 4; ++sweep) {
      const Smoothed step = smooth(mesh, fixed, one_sweep);
      CHECK(step.minimum_after >= step.minimum_before);
    }
  }
}

TEST_CASE("Smoothing keeps the best mesh that it met", "[hexahedra]") {
  // Sweeps that raise the least scaled Jacobian may well invert more hexahedra.
  int tangled = 0;
  for (int seed = 0; seed < 24; ++seed) {
    HexMesh mesh = cubes(3);
    const std::vector<char> fixed = outside(mesh, 3);
    shake(mesh, fixed, 0.9 + 0.1 * (seed % 8), seed);
    const HexQuality before = quality(mesh);
    const Smoothed done = smooth(mesh, fixed);
    const HexQuality after = quality(mesh);
    CHECK(done.bad_after == static_cast<int>(after.bad.size()));
    CHECK(done.minimum_after == after.minimum);
    CHECK(after.bad.size() <= before.bad.size());
    CHECK_FALSE(is_better(before, after));
    tangled += after.bad.empty() ? 0 : 1;
  }
  CHECK(tangled > 0); // else this would test little
}

TEST_CASE("Smoothing leaves cubes alone, and moves nothing where all is fixed", "[hexahedra]") {
  HexMesh mesh = cubes(4);
  const Smoothed good = smooth(mesh, outside(mesh, 4));
  CHECK(good.moved == 0);
  CHECK(good.sweeps == 1);
  const std::vector<char> all(mesh.points.size(), 1);
  shake(mesh, std::vector<char>(mesh.points.size(), 0), 0.4);
  const std::vector<Point> before = mesh.points;
  CHECK(smooth(mesh, all).moved == 0);
  CHECK(mesh.points == before);
  CHECK_THROWS_AS(smooth(mesh, {}), PreconditionError);
}
