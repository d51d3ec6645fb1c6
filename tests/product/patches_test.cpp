// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/product/patches.hpp"

#include "product/solids.hpp"

#include "tetrarch/product/partition.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::product;

TEST_CASE("Crumbs, holes and jags go from bases, and touching ones are parted", "[patches]") {
  const support::Extrusion from = support::box({8, 8, 4}, {8, 8, 4}, 0);
  const Solid whole = solid_of(from.mesh);
  // A triangle in a corner of the box, two of whose sides are on ridges, is a jag.
  std::vector<int> good = support::bases(whole, from);
  clean_up(whole, good);
  // The first triangle that has all its vertices within half a box of the point, by each coordinate.
  const auto triangle_near = [&](const Point& at) {
    for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
      bool near = true;
      for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k) near = near && std::abs(whole.point(whole.corner(t, c))[k] - at[k]) < 0.6;
      if (near) return t;
    }
    FAIL("no such triangle");
    return -1;
  };
  std::vector<int> base = good;
  base[triangle_near({4.5, 4.5, 0})] = -1; // a hole in the floor
  base[triangle_near({4.5, 0, 1.5})] = 0;  // a crumb on a wall
  clean_up(whole, base);
  CHECK(base == good);
  // A ceiling as far down as the floor touches it along its rim.
  base = good;
  for (int& b : base)
    if (b < 0) b = 1;
  CHECK_THROWS(partition(whole, base));
  clean_up(whole, base);
  CHECK(partition(whole, base).walls == 1);
}
