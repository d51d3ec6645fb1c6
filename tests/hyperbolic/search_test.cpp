// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/search.hpp"

#include "support/links.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using namespace tetrarch::support;

TEST_CASE("exteriors of knots and links get their volumes from their meshes", "[hyperbolic]") {
  // The volumes of the hyperbolic ones are those of SnapPy's census (m004, m015, m129) and twice the regular
  // ideal octahedron's; torus knots and links have none, and nothing may be found.
  for (const NamedLink& link : links()) {
    SearchOptions options;
    options.attempts = 200;
    const Search found = find_structure(triangulation_of(exterior(link.grid)), options);
    INFO(link.name << ": " << describe(found));
    if (link.volume > 0) {
      REQUIRE(found.structure.outcome == Outcome::geometric);
      CHECK(found.structure.volume == Approx(link.volume).epsilon(0).margin(5e-11));
      CHECK(found.structure.residual < 1e-12);
      CHECK(found.changed);
    } else {
      CHECK(found.structure.outcome != Outcome::geometric);
      CHECK(found.structure.volume == 0);
    }
  }
}

TEST_CASE("a triangulation that is not geometric is changed until one is", "[hyperbolic]") {
  for (const char* name : {"knotted Y", "figure-eight complement m004", "Whitehead link complement m129"}) {
    const Triangulation tri = zoo(name).triangulation();
    const double volume = find_structure(tri).structure.volume;
    REQUIRE(volume > 1);
    int spoilt = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      moves::Complex complex(tri);
      SplitMix64 random(seed);
      moves::shake(complex, 30, random);
      const Triangulation shaken = complex.triangulation();
      const Skeleton skeleton(shaken);
      spoilt += hyperbolize(shaken, skeleton).outcome == Outcome::geometric ? 0 : 1;
      SearchOptions options;
      options.seed = seed;
      const Search found = find_structure(shaken, options);
      INFO(name << " " << signature(shaken));
      REQUIRE(found.structure.outcome == Outcome::geometric);
      CHECK(found.structure.volume == Approx(volume).epsilon(0).margin(1e-11));
      // The structure is on the triangulation that comes with it.
      CHECK(hyperbolize(found.triangulation, Skeleton(found.triangulation)).outcome == Outcome::geometric);
    }
    CHECK(spoilt > 5);
  }
}

TEST_CASE("a search that finds nothing says what it saw", "[hyperbolic]") {
  SearchOptions options;
  options.attempts = 50;
  const Search found = find_structure(zoo("trefoil complement").triangulation(), options);
  CHECK(found.structure.outcome != Outcome::geometric);
  CHECK(found.attempts == 50);
  int seen = 0;
  for (const int n : found.seen) seen += n;
  CHECK(seen == 50);
  CHECK(describe(found).starts_with("no structure found on 50 triangulations: "));
  // A closed manifold has nothing to truncate; a change of the triangulation does not help.
  const Search closed = find_structure(zoo("Poincare sphere").triangulation(), options);
  CHECK(closed.structure.outcome == Outcome::finite_vertices);
  CHECK(closed.attempts == 1);
  CHECK_THROWS_AS(find_structure(Triangulation(0)), PreconditionError);
  CHECK_THROWS_AS(find_structure(Triangulation(2)), PreconditionError);
}

TEST_CASE("a search is the same for the same seed", "[hyperbolic]") {
  const Triangulation tri = triangulation_of(exterior(named_link("5_2").grid));
  const Search a = find_structure(tri);
  const Search b = find_structure(tri);
  CHECK(a.triangulation == b.triangulation);
  CHECK(a.attempts == b.attempts);
  CHECK(a.structure.volume == b.structure.volume);
}
