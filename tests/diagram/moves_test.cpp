// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/moves.hpp"

#include "support/homology.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/wirtinger.hpp"
#include "tetrarch/diagram/write.hpp"
#include "tetrarch/identify/identify.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::diagram;
using namespace tetrarch::support;

namespace {

Diagram diagram_of(const std::string& code) {
  return read_diagram(code, "test");
}

/// A random move of random kind at a random dart; the diagram itself where it cannot be made there.
Diagram with_random_move(const Diagram& d, int most_crossings, SplitMix64& random) {
  const int dart = random.below(d.dart_count());
  const bool grow = crossing_count(d) < most_crossings;
  switch (random.below(7)) {
  case 0:
    return grow ? with_kinks(d, {{dart, random.below(2) == 0, random.below(2) == 0}}) : d;
  case 1: {
    if (!grow) return d;
    const int other = random.below(d.dart_count());
    const bool apart = parts(d).of[dart] != parts(d).of[other];
    const bool beside = regions(d).of[dart] == regions(d).of[other];
    if (dart == other || other == d.opposite(dart) || !(apart || beside)) return d;
    return with_poke(d, {dart, other, random.below(2) == 0});
  }
  case 2:
    return is_kink(d, dart) ? without_kink(d, dart) : d;
  case 3: {
    const bool at_vertex = !d.at_crossing(dart) && d.node(d.node_of(dart)).darts.size() > 2;
    return grow && at_vertex ? with_twist(d, dart, random.below(2) == 0) : d;
  }
  case 4:
    return is_twist(d, dart) ? without_twist(d, dart) : d;
  case 5:
    return is_poke(d, dart) ? without_poke(d, dart) : d;
  default:
    return is_triangle(d, dart) ? with_triangle_turned(d, dart) : d;
  }
}

std::string isometry_signature(const Triangulation& tri) {
  const identify::Identification found = identify::identify(tri);
  REQUIRE_FALSE(found.isometry_signature.empty());
  return found.isometry_signature;
}

std::string shape(const Diagram& d) {
  return std::to_string(vertex_count(d)) + " vertices, " + std::to_string(edges(d).count) + " edges, " +
         std::to_string(components(d).count) + " components";
}

} // namespace

TEST_CASE("moves and their inverses", "[diagram-moves]") {
  const Diagram trefoil = diagram_of("PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]");
  for (int d = 0; d < trefoil.dart_count(); ++d)
    for (const bool left : {true, false})
      for (const bool over : {true, false}) {
        const Diagram kinked = with_kinks(trefoil, {{d, left, over}});
        CHECK(crossing_count(kinked) == 4);
        CHECK(regions(kinked).count == 6);
        int kinks = 0;
        for (int e = 0; e < kinked.dart_count(); ++e) {
          if (!is_kink(kinked, e)) continue;
          ++kinks;
          CHECK(planar_diagram_code(without_kink(kinked, e)) == planar_diagram_code(trefoil));
        }
        CHECK(kinks == 1);
      }
  for (int d = 0; d < trefoil.dart_count(); ++d) {
    const int next = trefoil.next_on_left(d);
    const Diagram poked = with_poke(trefoil, {d, next, true});
    CHECK(crossing_count(poked) == 5);
    int pokes = 0;
    for (int e = 0; e < poked.dart_count(); ++e) pokes += is_poke(poked, e) ? 1 : 0;
    CHECK(pokes >= 2); // one bigon, seen from its two arcs
  }
  CHECK_THROWS_AS(with_poke(trefoil, {0, 0, true}), PreconditionError);
  CHECK_THROWS_AS(without_kink(trefoil, 0), PreconditionError);
  CHECK_THROWS_AS(with_kinks(trefoil, {{0}, {trefoil.opposite(0)}}), PreconditionError);
}

TEST_CASE("a twist at a vertex and its inverse", "[diagram-moves]") {
  const Diagram theta = diagram_of("V[1, 2, 3] V[3, 2, 1]");
  for (int d = 0; d < theta.dart_count(); ++d)
    for (const bool over : {true, false}) {
      const Diagram twisted = with_twist(theta, d, over);
      CHECK(crossing_count(twisted) == 1);
      int found = 0;
      for (int e = 0; e < twisted.dart_count(); ++e)
        if (is_twist(twisted, e)) {
          ++found;
          const Diagram back = without_twist(twisted, e);
          CHECK(crossing_count(back) == 0);
          CHECK(regions(back).count == 3);
        }
      CHECK(found >= 2);
    }
}

TEST_CASE("random moves keep the exterior", "[diagram-moves]") {
  SplitMix64 random(7);
  int changed = 0;
  for (const char* code :
       {"braid 1 -2 1 -2", "braid 1 -2 1 -2 -2", "braid 1 -2 1 -2 1 -2", "DT[4, 8, 10, 2, 6]",
        "PD[V[1, 4, 9], V[3, 8, 13], X[10, 6, 11, 7], X[5, 2, 6, 3], X[1, 11, 2, 12], X[12, 5, 13, 4], X[7, "
        "9, 8, 10]]",
        "PD[V[1, 4, 9], V[3, 10, 15], X[7, 11, 8, 12], X[12, 6, 13, 7], X[5, 2, 6, 3], X[1, 13, 2, 14], "
        "X[14, 5, 15, 4], X[10, 8, 11, 9]]"}) {
    const Diagram first = diagram_of(code);
    const std::string name = isometry_signature(exterior(first));
    for (int round = 0; round < 20; ++round) {
      Diagram d = first;
      for (int made = 0, tried = 0; made < 50 && tried < 5000; ++tried) {
        const Diagram next = with_random_move(d, 16, random);
        if (next == d) continue;
        d = next;
        ++made;
      }
      INFO(code << " became " << planar_diagram_code(d));
      changed += crossing_count(d) != crossing_count(first) ? 1 : 0;
      REQUIRE(shape(without_points(d)) == shape(without_points(first)));
      REQUIRE(isometry_signature(exterior(d)) == name);
      const Diagram small = simplified(d);
      CHECK(crossing_count(small) <= crossing_count(d));
      REQUIRE(isometry_signature(exterior(small)) == name);
    }
  }
  CHECK(changed > 100);
}

TEST_CASE("simplification undoes moves on an unknot and on parts", "[diagram-moves]") {
  SplitMix64 random(3);
  int best = 0;
  for (int round = 0; round < 50; ++round) {
    Diagram d = diagram_of(round % 2 == 0 ? "Loop[1]" : "Loop[1] Loop[2] V[3, 4, 5] V[5, 4, 3]");
    for (int k = 0; k < 300; ++k) d = with_random_move(d, 12, random);
    const Diagram small = simplified(d);
    INFO(planar_diagram_code(d) << " became " << planar_diagram_code(small));
    CHECK(components(small).count == components(d).count);
    best += crossing_count(small) == 0 ? 1 : 0;
    const auto group = simplified(wirtinger(small).group);
    CHECK(abelianized(group).str() == (round % 2 == 0 ? "Z" : "Z^4"));
  }
  CHECK(best > 45);
}

TEST_CASE("a diagram in several parts is joined", "[diagram-moves]") {
  const Diagram d = connected(diagram_of("Loop[1] Loop[2] V[3, 4, 5] V[5, 4, 3]"));
  CHECK(parts(d).count == 1);
  CHECK(crossing_count(d) == 4);
  CHECK(crossing_count(simplified(d)) == 0);
}
