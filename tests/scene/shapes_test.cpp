// SPDX-License-Identifier: GPL-2.0-or-later
#include "scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/scene/files.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::scene::test;

namespace {

/// The part of a swept surface that belongs to polyline k, by itself.
Surface one_tube(const Surface& all, const Tubes& tubes, int sides, std::size_t k) {
  const int points_before = tubes.starts[k] * sides + 2 * static_cast<int>(k);
  const int count = (tubes.starts[k + 1] - tubes.starts[k]) * sides;
  Surface out;
  out.points.assign(all.points.begin() + points_before, all.points.begin() + points_before + count + 2);
  const auto first = all.triangles.begin() + std::ptrdiff_t{2} * sides * tubes.starts[k];
  for (auto t = first; t != first + std::ptrdiff_t{2} * count; ++t)
    out.triangles.push_back({(*t)[0] - points_before, (*t)[1] - points_before, (*t)[2] - points_before});
  return out;
}

Tubes random_tubes(SplitMix64& random, int polylines) {
  Tubes tubes;
  const auto number = [&] { return random.below(1000001) / 1e6 - 0.5; };
  for (int k = 0; k < polylines; ++k) {
    const int size = 2 + k % 9;
    for (int i = 0; i < size; ++i) {
      tubes.points.push_back({number(), number(), number()});
      // Some stand still, some turn straight back.
      const std::size_t last = tubes.points.size() - 1;
      if (i > 0 && k % 3 == 1) tubes.points[last] = tubes.points[last - 1];
      if (i > 1 && k % 3 == 2) tubes.points[last] = tubes.points[last - 2];
      tubes.radii.push_back(0.01 + 0.01 * i);
    }
    tubes.starts.push_back(static_cast<int>(tubes.points.size()));
    tubes.colors.push_back({static_cast<std::uint8_t>(k), 0, 0, 255});
  }
  tubes.data = {{"polyline", {}}};
  for (int k = 0; k < polylines; ++k) tubes.data[0].values.push_back(k);
  return tubes;
}

} // namespace

TEST_CASE("every swept polyline is a sphere whose rings lie at the radius", "[scene]") {
  SplitMix64 random(7);
  const Tubes tubes = random_tubes(random, 30);
  for (const int sides : {3, 8}) {
    const Surface all = swept(tubes, sides);
    REQUIRE(all.points.size() == tubes.points.size() * sides + 2 * 30);
    REQUIRE(all.normals.size() == all.points.size());
    std::size_t at = 0;
    std::size_t triangle = 0;
    for (std::size_t k = 0; k + 1 < tubes.starts.size(); ++k) {
      const Surface tube = one_tube(all, tubes, sides, k);
      CHECK(is_closed(tube));
      CHECK(euler_characteristic(tube) == 2);
      for (std::size_t t = 0; t < tube.triangles.size(); ++t, ++triangle) {
        CHECK(all.data[0].values[triangle] == static_cast<int>(k));
        CHECK(all.colors[triangle] == tubes.colors[k]);
      }
      for (int i = tubes.starts[k]; i < tubes.starts[k + 1]; ++i)
        for (int j = 0; j < sides; ++j, ++at) {
          const Point offset = minus(all.points[at], tubes.points[i]);
          CHECK(std::abs(norm(offset) - tubes.radii[i]) < 1e-12);
          CHECK(std::abs(inner(offset, all.normals[at]) - tubes.radii[i]) < 1e-12);
        }
      at += 2;
    }
    CHECK(triangle == all.triangles.size());
  }
}

TEST_CASE("a straight tube is a prism", "[scene]") {
  Tubes tubes;
  tubes.points = {{1, 2, 3}, {1.5, 3, 2}, {2, 4, 1}};
  tubes.radii = {0.25, 0.25, 0.25};
  tubes.starts = {0, 3};
  tubes.colors = {{9, 9, 9, 9}};
  const Point axis = minus(tubes.points[2], tubes.points[0]);
  for (const int sides : {3, 4, 8, 50}) {
    const Surface prism = swept(tubes, sides);
    // The area of a regular polygon times the length.
    const double base = sides * 0.0625 / 2 * std::sin(2 * std::numbers::pi / sides);
    CHECK(std::abs(enclosed_volume(prism) - base * norm(axis)) < 1e-12);
    for (int i = 0; i < 3 * sides; ++i) {
      const Point offset = minus(prism.points[i], tubes.points[i / sides]);
      CHECK(std::abs(inner(offset, axis)) < 1e-12);
    }
    CHECK(prism.colors == tubes.colors);
  }
}

TEST_CASE("transport along a curve in a plane does not twist", "[scene]") {
  // A spiral in the plane of two orthonormal vectors, oblique to the axes; the third is `above`.
  const Point right{2.0 / 3, -2.0 / 3, 1.0 / 3};
  const Point up{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const Point above{2.0 / 3, 1.0 / 3, -2.0 / 3};
  Tubes tubes;
  for (int i = 0; i < 500; ++i) {
    const double x = std::cos(0.05 * i);
    const double y = std::sin(0.05 * i) * (1 + 0.001 * i);
    tubes.points.push_back({x * right[0] + y * up[0], x * right[1] + y * up[1], x * right[2] + y * up[2]});
    tubes.radii.push_back(0.1);
  }
  tubes.starts.push_back(500);
  const Surface tube = swept(tubes, 5);
  // The height above the plane is kept, along each of the five lines.
  for (std::size_t i = 5; i < 2500; ++i)
    CHECK(std::abs(inner(minus(tube.normals[i], tube.normals[i % 5]), above)) < 1e-12);
  CHECK(enclosed_volume(tube) > 0);
}

TEST_CASE("the outer faces of cubes are the surface of a cube", "[scene]") {
  for (const bool cut : {false, true})
    for (const int n : {1, 2, 3}) {
      const Cells cells = cut ? cut_cubes(n) : cubes(n);
      const Surface s = outer_faces(cells);
      // By hand: 6 sides of n^2 squares of two triangles each; all points but the inner ones.
      CHECK(s.triangles.size() == 12 * n * n);
      CHECK(s.points.size() == (n + 1) * (n + 1) * (n + 1) - (n - 1) * (n - 1) * (n - 1));
      CHECK(is_closed(s));
      CHECK(euler_characteristic(s) == 2);
      CHECK(std::abs(enclosed_volume(s) - n * n * n) < 1e-12);
      REQUIRE(s.textures.size() == s.points.size());
      for (std::size_t p = 0; p < s.points.size(); ++p)
        CHECK(s.textures[p] == std::array<double, 2>{s.points[p][0] / 8, s.points[p][1] / 8});
      // The datum is the cube that the triangle lies on.
      for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        const int cube = s.data[0].values[t];
        const Point low{double(cube % n), double(cube / n % n), double(cube / n / n)};
        for (const int p : s.triangles[t])
          for (std::size_t i = 0; i < 3; ++i) {
            CHECK(s.points[p][i] >= low[i]);
            CHECK(s.points[p][i] <= low[i] + 1);
          }
      }
    }
}

TEST_CASE("a quadrilateral and two triangles on it are different faces", "[scene]") {
  Cells cells = cubes(1);
  cells.data.clear();
  cells.textures.clear();
  cells.points.push_back({0.5, 0.5, 2});
  cells.tetrahedra = {{4, 5, 7, 8}, {4, 7, 6, 8}}; // a roof; points 4 to 7 are 001, 101, 011, 111
  const Surface s = outer_faces(cells);
  // By hand: two tetrahedra have 8 faces, two of which they share; the cube has 6 of two triangles.
  CHECK(s.triangles.size() == 8 - 2 + 12);
  CHECK(s.points.size() == 9);
}

TEST_CASE("elements without anything have no surface", "[scene]") {
  CHECK(swept(Tubes{}).triangles.empty());
  CHECK(outer_faces(Cells{}).triangles.empty());
}

TEST_CASE("tubes with fewer than three sides are refused", "[scene]") {
  CHECK_THROWS_AS(swept(tubes(), 2), PreconditionError);
}
