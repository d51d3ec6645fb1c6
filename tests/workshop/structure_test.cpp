// SPDX-License-Identifier: GPL-2.0-or-later
// Structures and reasons against them: a search in vain is short where the group tells that it is in vain.
#include "tetrarch/workshop/structure.hpp"

#include "tetrarch/workshop/canonical.hpp"
#include "tetrarch/workshop/open.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

TEST_CASE("reasons that the group gives at once end the search", "[workshop]") {
  // Handlebody-knots that Ishii, Kishimoto, Moriuchi and Suzuki (2012) list and that are not hyperbolic:
  // Koda, Ozawa and Gordon's annuli. Their groups split.
  constexpr int soon = 60; // of 1,000 triangulations
  for (const std::string name : {"hk4_1", "hk5_1", "hk5_2", "hk6_1", "hk6_4", "hk6_10"}) {
    INFO(name);
    const Triangulation exterior = open_triangulation(name).triangulation;
    const Structure found = structure(exterior);
    CHECK(found.verdict() == Verdict::proved_no);
    CHECK(found.search.attempts < soon);
    REQUIRE(found.why);
    CHECK(reasons::what_is_wrong(*found.why).empty());
    const Cells none = cells(exterior);
    CHECK(none.verdict() == Verdict::proved_no);
    REQUIRE(none.why);
    CHECK(none.why->text == found.why->text);
  }
}

TEST_CASE("a reason is sought further where the search found nothing", "[workshop]") {
  // Few attempts: nobody is asked on the way.
  StructureOptions options;
  options.attempts = 3;
  const Structure found = structure(open_triangulation("hk4_1").triangulation, options);
  CHECK(found.search.attempts == 3);
  CHECK(found.why);
}
