// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/product/tunnels.hpp"

#include "product/solids.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::product;

TEST_CASE("The tunnel of a pipe is found, and the function between its banks", "[tunnels]") {
  // Low and wide, so that loops through the hole, which bound in the solid, are longer than loops around it;
  // and high and thin-walled, where they are shorter.
  for (const auto& from : {support::pipe(0.2, 1, 6), support::pipe(0.8, 0.2, 6)}) {
    const Solid whole = solid(from.mesh);
    const auto found = tunnel(whole, FirstHomology(whole));
    REQUIRE(found);
    REQUIRE(std::is_sorted(found->levels.begin(), found->levels.end()));
    std::vector<int> base;
    double least = 1;
    double greatest = 0;
    for (const auto& v : found->values) {
      for (const double x : v) {
        least = std::min(least, x);
        greatest = std::max(greatest, x);
      }
      const double mean = (v[0] + v[1] + v[2]) / 3;
      base.push_back(mean > found->levels[2] && mean < found->levels[3]   ? 0
                     : mean > found->levels[0] && mean < found->levels[1] ? 1
                                                                          : -1);
    }
    CHECK(least == 0);
    CHECK(greatest == 1);
    // Both bases have two fifths of the area but for a band, so about as many triangles.
    const auto floor = std::count(base.begin(), base.end(), 0);
    const auto ceiling = std::count(base.begin(), base.end(), 1);
    CHECK(floor > static_cast<long>(base.size()) / 5);
    CHECK(ceiling > static_cast<long>(base.size()) / 5);
  }
}

TEST_CASE("Of two handles no loop generates the homology alone", "[tunnels]") {
  const Solid whole = solid(support::plate(2, 4, 2).mesh);
  CHECK_FALSE(tunnel(whole, FirstHomology(whole)));
}
