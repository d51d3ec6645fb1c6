// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/critical.hpp"

#include "product/solids.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/field.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::product;

using support::divided;
using support::Divided;

TEST_CASE("Products have no critical places, even where whole layers have one height", "[critical]") {
  for (const double unrest : {0.0, 0.15})
    for (const auto& from :
         {support::box({1, 1, 1}, {4, 4, 4}, unrest),
          support::plate(3, 6, 4, support::Hole::round, 0.5, unrest), support::radial_pipe(0.5, 6, unrest),
          support::shell(2, 0.6, 6, unrest), support::bent(2, 6, 4, unrest)}) {
      const Divided c = divided(from);
      CHECK(critical_places(c.solid, c.partition, harmonic_field(c.solid, c.partition).w).none());
    }
}

TEST_CASE("A vertex raised above its neighbours is a maximum, with a saddle near it", "[critical]") {
  const Divided c = divided(support::box({4, 4, 4}, {4, 4, 4}, 0));
  std::vector<double> w;
  for (const Point& p : c.solid.mesh.points) w.push_back(p[2]);
  const auto middle = std::find(c.solid.mesh.points.begin(), c.solid.mesh.points.end(), Point{2, 2, 2});
  REQUIRE(middle != c.solid.mesh.points.end());
  const int peak = static_cast<int>(middle - c.solid.mesh.points.begin());
  w[peak] = 3.5;
  const CriticalPlaces places = critical_places(c.solid, c.partition, w);
  CHECK(places.flat.empty());
  // By Morse's count the maximum (index 3) and a saddle (index 2) cancel; the saddle is near.
  int maxima = 0;
  int saddles = 0;
  for (const CriticalVertex& v : places.vertices) {
    CHECK_FALSE(v.on_wall);
    CHECK(numeric::distance(c.solid.point(v.vertex), {2, 2, 2}) < 2);
    if (v.vertex == peak) {
      CHECK(v.lower == 1);
      CHECK(v.upper == 0);
      ++maxima;
    } else {
      CHECK(v.upper == 2);
      saddles += v.upper - 1;
    }
  }
  CHECK(maxima == 1);
  CHECK(saddles == 1);
}

TEST_CASE("A flow around a hole has critical places where it parts and where it meets again", "[critical]") {
  // A plate with one hole, floor x = 0, ceiling x = 1: the Euler number of the solid is 0, that of the floor
  // 1, so it is no product of the two.
  const support::Extrusion from = support::plate(1, 8, 3, support::Hole::round, 0.5, 0);
  Divided c{solid_of(from.mesh), {}};
  for (int t = 0; t < c.solid.boundary.triangle_count(); ++t) {
    const auto all_at = [&](double x) {
      return c.solid.point(c.solid.corner(t, 0))[0] == x && c.solid.point(c.solid.corner(t, 1))[0] == x &&
             c.solid.point(c.solid.corner(t, 2))[0] == x;
    };
    c.partition.patch.push_back(all_at(0) ? floor_patch : all_at(1) ? ceiling_patch : first_wall);
  }
  c.partition.walls = 1;
  const CriticalPlaces places = critical_places(c.solid, c.partition, harmonic_field(c.solid, c.partition).w);
  CHECK(places.vertices.size() >= 2);
  bool parts = false;
  bool meets = false;
  for (const CriticalVertex& v : places.vertices) {
    const Point& p = c.solid.point(v.vertex);
    CHECK(v.on_wall);
    CHECK(std::abs(p[1] - 0.5) < 0.1);
    CHECK(std::hypot(p[0] - 0.5, p[1] - 0.5) == Approx(0.25));
    parts = parts || p[0] < 0.5;
    meets = meets || p[0] > 0.5;
  }
  CHECK(parts);
  CHECK(meets);
}

TEST_CASE("A wall may have a saddle where the solid has none", "[critical]") {
  // A vertex in the middle of a wall, lowered below its neighbours there but not below the one inside: on the
  // wall it is a minimum.
  const support::Extrusion from = support::box({4, 4, 4}, {4, 4, 4}, 0);
  const Divided c = divided(from);
  std::vector<double> w;
  for (const Point& p : c.solid.mesh.points)
    w.push_back(p[0] > 0.5 && p[0] < 3.5 && p[2] > 1.5 && p[2] < 2.5 ? 1.1 : p[2]);
  int pit = -1;
  for (std::size_t v = 0; v < w.size(); ++v)
    if (c.solid.mesh.points[v] == Point{0, 2, 2}) w[pit = static_cast<int>(v)] = 0.95;
  REQUIRE(pit >= 0);
  bool told = false;
  for (const CriticalVertex& v : critical_places(c.solid, c.partition, w).vertices)
    told = told || v.vertex == pit;
  CHECK(told);
}

TEST_CASE("Where all vertices are on one base the field is flat", "[critical]") {
  // One layer, and its middle pressed down: by hand, tetrahedra with three vertices below and one above are
  // flat if that one is 0, too.
  const Divided c = divided(support::box({1, 1, 1}, {2, 2, 1}, 0));
  std::vector<double> w;
  for (const Point& p : c.solid.mesh.points) w.push_back(p[2]);
  CHECK(critical_places(c.solid, c.partition, w).none());
  std::fill(w.begin() + 9, w.end() - 1, 0.0); // all above but one corner
  const CriticalPlaces places = critical_places(c.solid, c.partition, w);
  int without_it = 0;
  for (const auto& v : c.solid.mesh.tetrahedra) without_it += std::find(v.begin(), v.end(), 17) == v.end();
  CHECK(static_cast<int>(places.flat.size()) == without_it);
}
