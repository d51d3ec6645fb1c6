// SPDX-License-Identifier: GPL-2.0-or-later
#include "../verified/certified.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/checker/check.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using support::Certified;

TEST_CASE("every certificate of the census is accepted", "[checker]") {
  for (const int tets : {2, 3})
    for (const catalogue::Manifold& m : catalogue::stored_table(tets)) {
      CAPTURE(m.name);
      const checker::Report report = checker::check(Certified(m.signature).text(), m.name);
      CHECK(report.why_not.empty());
      CHECK(report.accepted);
      CHECK(report.tetrahedra == tets);
      CHECK(report.cusps == m.cusps);
      CHECK(report.orientable);
    }
}
