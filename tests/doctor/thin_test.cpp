// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles too thin to compute on: planted in good surfaces, named and taken out again.
#include "support/random.hpp"
#include "support/surface_soups.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/quality.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/surface/boundary_loops.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::surface;
using namespace tetrarch::support::soups;

namespace {

using Point = std::array<double, 3>;

Point between(const Point& p, const Point& q, double s) {
  return {p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])};
}

/// A grid in space with a hole: 14 * 14 - 9 squares.
format::Soup sheet() {
  constexpr int n = 14;
  Points points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) points.push_back({1.0 * i, 1.0 * j, 0.1 * ((3 * i + 5 * j) % 4)});
  Triangles triangles;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (4 <= i && i < 7 && 4 <= j && j < 7) continue;
      const int v = i * (n + 1) + j;
      triangles.push_back({v, v + n + 1, v + n + 2});
      triangles.push_back({v, v + n + 2, v + 1});
    }
  return surface_soup(points, triangles);
}

/// A new vertex on side `corner` of triangle t, this far along: both triangles there are split.
void split_side(format::Soup& soup, int t, int corner, double along) {
  const int u = soup.triangles[t][corner];
  const int v = soup.triangles[t][(corner + 1) % 3];
  const int w = static_cast<int>(soup.points.size());
  soup.points.push_back(between(soup.points[u], soup.points[v], along));
  for (std::size_t k = 0, end = soup.triangles.size(); k < end; ++k) {
    Triangle first = soup.triangles[k];
    const bool has_both = std::find(first.begin(), first.end(), u) != first.end() &&
                          std::find(first.begin(), first.end(), v) != first.end();
    if (!has_both) continue;
    Triangle second = first;
    std::replace(first.begin(), first.end(), v, w);
    std::replace(second.begin(), second.end(), u, w);
    soup.triangles[k] = first;
    soup.triangles.push_back(second);
  }
}

/// A new vertex in triangle t, so near to its first side that a cap lies on that side.
void plant_cap(format::Soup& soup, int t, double height) {
  const Triangle c = soup.triangles[t];
  const int w = static_cast<int>(soup.points.size());
  const Point middle = between(soup.points[c[0]], soup.points[c[1]], 0.4);
  soup.points.push_back(between(middle, soup.points[c[2]], height));
  soup.triangles[t] = {c[0], c[1], w};
  soup.triangles.push_back({c[1], c[2], w});
  soup.triangles.push_back({c[2], c[0], w});
}

bool can_be_solved_on(const format::Soup& soup) {
  try {
    half_cotangents(build_surface(soup));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

int worst_kind(const Report& report) {
  return static_cast<int>(report.count(Kind::thin) + report.count(Kind::flat));
}

} // namespace

TEST_CASE("needles and caps are taken out, whatever their number, and nothing else changes", "[doctor]") {
  const format::Soup good = repair(sheet()).soup; // without the points in the hole
  const TriangleMesh before = build_surface(good);
  for (unsigned seed = 1; seed <= 100; ++seed) {
    support::Random random(seed);
    format::Soup soup = good;
    for (int k = 0; k < 12; ++k) {
      const int t = random.below(static_cast<int>(soup.triangles.size()));
      constexpr std::array<double, 3> sizes{0, 1e-15, 1e-12};
      const double size = sizes[random.below(3)];
      if (random.below(2) == 0)
        split_side(soup, t, random.below(3), size);
      else
        plant_cap(soup, t, size);
    }
    INFO("seed " << seed);
    REQUIRE(worst_kind(validate_surface(soup)) > 0);
    REQUIRE_FALSE(can_be_solved_on(soup));
    const format::Soup mended = repair(soup).soup;
    CHECK(worst_kind(validate_surface(mended)) == 0);
    CHECK(validate_surface(mended).count(Severity::fatal) == 0);
    REQUIRE(can_be_solved_on(mended));
    const TriangleMesh after = build_surface(mended);
    CHECK(type_of(after.surface) == type_of(before.surface));
    CHECK(boundary_loops(after).size() == 2);
    CHECK(extent(mended).area == Approx(extent(good).area).epsilon(1e-9));
    CHECK(repair(mended).done.empty());
  }
}

TEST_CASE("needles at a vertex of many triangles are taken out", "[doctor]") {
  // A fan, closed and open. Each even vertex of the rim lies 1e-13 before the next.
  constexpr int rim = 100000;
  for (const bool closed : {true, false}) {
    Points points{{0, 0, 0}};
    std::vector<Triangle> triangles;
    constexpr double step = 2 * std::numbers::pi / rim;
    for (int k = 0; k < rim; ++k) {
      const double angle = k % 2 == 0 ? (k + 1) * step - 1e-13 : k * step;
      points.push_back({std::cos(angle), std::sin(angle), 0});
      if (k + 1 < rim || closed) triangles.push_back({0, 1 + k, 1 + (k + 1) % rim});
    }
    const format::Soup soup = surface_soup(points, triangles);
    const Repaired mended = repair(soup);
    CHECK(mended.soup.triangles.size() == triangles.size() - rim / 2);
    CHECK(validate_surface(mended.soup).count(Severity::fatal) == 0);
    CHECK(worst_kind(validate_surface(mended.soup)) == 0);
    CHECK(extent(mended.soup).area == Approx(extent(soup).area).epsilon(1e-12));
  }
}

TEST_CASE("two vertices of many triangles become one", "[doctor]") {
  // A fan about two hubs 1e-13 apart, half the rim each, with a needle to either side.
  constexpr int rim = 100000;
  Points points{{0, 0, 0}, {0, 1e-13, 0}};
  std::vector<Triangle> triangles{{0, 2, 1}, {1, 2 + rim / 2, 0}};
  for (int k = 0; k < rim; ++k) {
    const double angle = 2 * std::numbers::pi * k / rim;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    triangles.push_back({k < rim / 2 ? 1 : 0, 2 + k, 2 + (k + 1) % rim});
  }
  const Repaired mended = repair(surface_soup(points, triangles));
  CHECK(mended.soup.triangles.size() == rim);
  CHECK(mended.soup.points.size() == rim + 1);
  CHECK(validate_surface(mended.soup).count(Severity::fatal) == 0);
  CHECK(extent(mended.soup).area == Approx(std::numbers::pi).epsilon(1e-8));
}

TEST_CASE("thin triangles are named, by hand", "[doctor]") {
  const auto kinds = [](double x, double y) {
    const Report report = validate_surface(surface_soup({{0, 0, 0}, {1, 0, 0}, {x, y, 0}}, {{0, 1, 2}}));
    return std::pair(report.count(Kind::thin), report.count(Kind::flat));
  };
  CHECK(kinds(1, 1e-9) == std::pair<std::int64_t, std::int64_t>(0, 0));    // an angle of 1e-9
  CHECK(kinds(1, 1e-11) == std::pair<std::int64_t, std::int64_t>(1, 0));   // needle
  CHECK(kinds(0.5, 1e-11) == std::pair<std::int64_t, std::int64_t>(1, 0)); // cap
  CHECK(kinds(0.5, 0) == std::pair<std::int64_t, std::int64_t>(0, 1));
  CHECK(kinds(1e-9, 1e-9) == std::pair<std::int64_t, std::int64_t>(0, 0));
  // The same whatever the size.
  for (const double scale : {1e-170, 1e-100, 1e100, 1e150}) {
    const auto report = [scale](double y) {
      return validate_surface(surface_soup({{0, 0, 0}, {scale, 0, 0}, {0, y * scale, 0}}, {{0, 1, 2}}));
    };
    CHECK(report(1e-9).count(Kind::thin) == 0);
    CHECK(report(1e-11).count(Kind::thin) == 1);
  }
}

TEST_CASE("a thin triangle stays where its removal would change the surface", "[doctor]") {
  // A tetrahedron's boundary with one edge of 1e-12: to collapse it would leave two triangles back to back.
  const Points points{{0, 0, 0}, {1e-12, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Repaired kept = repair(surface_soup(points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  CHECK(kept.done.empty());
  CHECK(kept.soup.triangles.size() == 4);
  // A band of one needle between two boundary curves that nearly meet: an edge across it is kept.
  const Repaired band = repair(surface_soup({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}}, {{0, 1, 2}}));
  CHECK(band.done.empty());
  CHECK(band.soup.triangles.size() == 1);
}
