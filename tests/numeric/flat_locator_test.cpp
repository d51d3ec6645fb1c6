// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/flat_locator.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

using Complex = std::complex<double>;

/// Many small triangles and a few large ones, half of them turned over; they overlap.
std::vector<FlatTriangle> random_triangles(support::Random& random, int count) {
  const auto between = [&](double size) { return size * (random.below(2001) / 1000.0 - 1); };
  std::vector<FlatTriangle> triangles;
  for (int k = 0; k < count; ++k) {
    const double size = k % 20 == 0 ? 1 : 0.1;
    const Complex at(between(1), between(1));
    triangles.push_back(
        {at, at + Complex(between(size), between(size)), at + Complex(between(size), between(size))});
  }
  return triangles;
}

/// The second route: the distance of a point from a triangle, by its sides' lines and its corners; negative
/// inside.
double distance_from(const FlatTriangle& p, Complex z) {
  double depth = 1e300;
  double outside = 1e300;
  for (std::size_t c = 0; c < 3; ++c) {
    const Complex side = (p[(c + 1) % 3] - p[c]) / std::abs(p[(c + 1) % 3] - p[c]);
    const Complex seen = (z - p[c]) / side;
    depth = std::min(depth, seen.imag());
    outside = std::min(outside, std::abs(z - p[c]));
    if (seen.real() > 0 && seen.real() < std::abs(p[(c + 1) % 3] - p[c]))
      outside = std::min(outside, std::abs(seen.imag()));
  }
  return depth > 0 ? -depth : outside;
}

Complex at(const FlatTriangle& p, const std::array<double, 3>& weight) {
  return weight[0] * p[0] + weight[1] * p[1] + weight[2] * p[2];
}

} // namespace

TEST_CASE("places are those of a search through all triangles", "[locator]") {
  support::Random random(8);
  int within = 0;
  for (const int count : {1, 3, 40, 400}) {
    const std::vector<FlatTriangle> triangles = random_triangles(random, count);
    const FlatLocator locator(triangles);
    for (int k = 0; k < 400; ++k) {
      const Complex z(random.below(3001) / 1000.0 - 1.5, random.below(3001) / 1000.0 - 1.5);
      double least = 1e300;
      double most_weight = -1e300;
      for (const FlatTriangle& p : triangles) {
        if (!(twice_area(p) > 0)) continue;
        least = std::min(least, distance_from(p, z));
        const double weight =
            std::min({cross(p[1] - z, p[2] - z), cross(p[2] - z, p[0] - z), cross(p[0] - z, p[1] - z)});
        most_weight = std::max(most_weight, weight / twice_area(p));
      }
      const FlatPlace deepest = locator.deepest(z);
      const FlatPlace nearest = locator.nearest(z);
      const FlatPlace inside = locator.inside(z);
      if (least > 1e299) { // the only triangle is turned over
        REQUIRE((locator.empty() && deepest.triangle < 0 && nearest.triangle < 0 && inside.triangle < 0));
        continue;
      }
      REQUIRE(std::abs(distance_from(triangles[deepest.triangle], z) - least) < 1e-12);
      REQUIRE(std::abs(deepest.outside - std::max(least, 0.0)) < 1e-12);
      REQUIRE(std::abs(nearest.outside - std::max(least, 0.0)) < 1e-9);
      REQUIRE((inside.triangle >= 0) == (most_weight > -1e-10));
      for (const FlatPlace& place : {deepest, nearest}) {
        const Complex there = at(triangles[place.triangle], place.weight);
        REQUIRE(std::abs(std::abs(there - z) - place.outside) < 1e-9);
        for (const double weight : place.weight) REQUIRE(weight >= 0);
      }
      if (inside.triangle < 0) continue;
      ++within;
      REQUIRE(nearest.triangle == inside.triangle);
      REQUIRE(*std::min_element(inside.weight.begin(), inside.weight.end()) ==
              Approx(most_weight).margin(1e-9));
    }
  }
  CHECK(within > 100);
}

TEST_CASE("points of a side stay there, in the triangle of least number", "[locator]") {
  // The unit square by its diagonal from 0; a third triangle on top of the first.
  const FlatLocator locator(
      {{0.0, 1.0, Complex(1, 1)}, {0.0, Complex(1, 1), Complex(0, 1)}, {0.0, 1.0, Complex(1, 1)}});
  CHECK(locator.area() == 1.5);
  for (const FlatPlace& place : {locator.inside({0.5, 0.5}), locator.nearest({0.5, 0.5})}) {
    CHECK(place.triangle == 0);
    CHECK(place.weight == std::array{0.5, 0.0, 0.5});
  }
  // Above 1e-10 outside it is no point of the side any more.
  CHECK(locator.inside({0.5, -1e-11}).weight[2] == 0);
  CHECK(locator.inside({0.5, -1e-9}).triangle == -1);
  const FlatPlace below = locator.nearest({0.25, -2});
  CHECK(below.triangle == 0);
  CHECK(below.weight == std::array{0.75, 0.25, 0.0});
  CHECK(below.outside == 2);
}

TEST_CASE("no place is not a place", "[locator]") {
  const FlatLocator none{{}};
  CHECK(none.empty());
  CHECK(none.nearest({0, 0}).triangle == -1);
  CHECK(none.deepest({0, 0}).triangle == -1);
  const FlatLocator one({{0.0, 1.0, Complex(0, 1)}});
  CHECK(one.nearest({std::nan(""), 0}).triangle == -1);
}
