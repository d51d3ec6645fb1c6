// SPDX-License-Identifier: GPL-2.0-or-later
#include "certified.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using numeric::Ball;
using numeric::Real50;
using support::Certified;

TEST_CASE("all manifolds of two and three tetrahedra are certified at 53 bits", "[verified]") {
  int count = 0;
  for (const int tets : {2, 3})
    for (const catalogue::Manifold& m : catalogue::stored_table(tets)) {
      CAPTURE(m.name);
      const Certified c(m.signature);
      REQUIRE(c.result.proof);
      CHECK(c.result.proof->bits == 53);
      CHECK(c.result.proof->fixed.size() == static_cast<std::size_t>(m.cusps));
      // The stored 30 digits lie in the interval, which is no wider than a few roundings.
      const auto [low, high] = verified::volume_interval(*c.result.proof);
      CHECK(Real50(low) <= Real50(m.volume));
      CHECK(Real50(m.volume) <= Real50(high));
      CHECK(Real50(high) - Real50(low) < 1e-12);
      ++count;
    }
  CHECK(count == 8 + 151); // Frigerio, Martelli, Petronio 2004
}
