// SPDX-License-Identifier: GPL-2.0-or-later
#include "product/solids.hpp"
#include "support/errors.hpp"

#include "tetrarch/product/partition.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::support;

TEST_CASE("a plate with holes has as many walls as holes and one", "[product]") {
  for (int holes = 0; holes <= 5; ++holes) {
    const Extrusion from = plate(holes, 6, 2);
    const product::Solid solid = product::solid(from.mesh);
    const product::Partition p = product::partition(solid, bases(solid, from));
    CHECK(p.walls == holes + 1);
  }
}

TEST_CASE("a floor whose hole bounds in the solid is refused", "[product]") {
  const Extrusion from = pipe(0.4, 1, 3);
  const product::Solid solid = product::solid(from.mesh);
  std::vector<int> base(static_cast<std::size_t>(solid.boundary.triangle_count()), -1);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    std::array<double, 2> p{};
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 2; ++k) p[k] += solid.point(solid.corner(t, c))[k];
    if (std::abs(p[1]) < 0.9 * std::abs(p[0])) base[t] = p[0] > 0 ? 0 : 1;
  }
  CHECK(error_of([&] { (void)product::partition(solid, base); }) == "");
}
