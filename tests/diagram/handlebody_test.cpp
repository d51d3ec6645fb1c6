// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/homology.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/wirtinger.hpp"
#include "tetrarch/diagram/write.hpp"
#include "tetrarch/identify/identify.hpp"

#include <catch2/catch.hpp>
#include <fstream>

using namespace tetrarch;
using namespace tetrarch::diagram;
using namespace tetrarch::support;

namespace {

struct Entry {
  std::string name;
  Diagram diagram;
  bool hyperbolic = false;
};

std::vector<Entry> handlebody_knots() {
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/data/handlebody_knots.txt");
  REQUIRE(file);
  std::vector<Entry> out;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t first = line.find('|');
    const std::size_t last = line.rfind('|');
    out.push_back({line.substr(0, first), read_diagram(line.substr(first + 1, last - first - 1), "test"),
                   line.substr(last + 1) != "-"});
  }
  REQUIRE(out.size() == 21);
  return out;
}

std::string name_of_exterior(const Diagram& d) {
  const identify::Identification found = identify::identify(exterior(d));
  REQUIRE_FALSE(found.isometry_signature.empty());
  return found.isometry_signature;
}

bool at_trivalent(const Diagram& d, int dart) {
  const Node& node = d.node(d.node_of(dart));
  return !node.crossing && node.darts.size() == 3;
}

/// An edge slides over others where it can: the vertex is passed along it to the edge's other end, and the
/// two other edges are twisted first if `twist` says so.
Diagram slid_somewhere(Diagram d, SplitMix64& random) {
  for (int tries = 0; tries < 200; ++tries) {
    const int dart = random.below(d.dart_count());
    if (!at_trivalent(d, dart)) continue;
    Diagram out = d;
    for (int passed = 0; passed < 3 && out.at_crossing(out.opposite(dart)); ++passed)
      out = with_vertex_passed(out, dart);
    if (!is_ih(out, dart)) continue;
    if (const int twist = random.below(3); twist > 0) out = with_twist(out, out.turned(dart, 1), twist == 1);
    return is_ih(out, dart) ? with_ih(out, dart) : d;
  }
  return d;
}

} // namespace

TEST_CASE("a vertex passes a crossing", "[handlebody]") {
  // Isotopy: the graph stays, and so do its group's homology and, where it has one, the structure outside.
  int passed = 0;
  for (const Entry& knot : handlebody_knots()) {
    INFO(knot.name);
    const std::string expected = knot.hyperbolic ? name_of_exterior(knot.diagram) : "";
    for (int d = 0; d < knot.diagram.dart_count(); ++d) {
      if (!at_trivalent(knot.diagram, d) || !knot.diagram.at_crossing(knot.diagram.opposite(d))) continue;
      const Diagram other = with_vertex_passed(knot.diagram, d);
      ++passed;
      CHECK(crossing_count(other) == crossing_count(knot.diagram) + 1);
      CHECK(edges(other).count == 3);
      CHECK(components(other).count == 1);
      CHECK(first_homology(exterior(other)) == "Z^2");
      if (knot.hyperbolic) CHECK(name_of_exterior(other) == expected);
      CHECK(crossing_count(simplified(other)) <= crossing_count(knot.diagram));
    }
  }
  CHECK(passed > 80);
}

TEST_CASE("IH moves keep the exterior of a handlebody-knot", "[handlebody]") {
  SplitMix64 random(4);
  int changed = 0;
  for (const Entry& knot : handlebody_knots()) {
    INFO(knot.name);
    Diagram d = knot.diagram;
    const std::string expected = knot.hyperbolic ? name_of_exterior(d) : "";
    for (int k = 0; k < 8; ++k) {
      const bool was_theta = components(d).count == 1 && edges(d).count == 3;
      Diagram next = simplified(slid_somewhere(d, random));
      if (crossing_count(next) > 14) continue;
      changed += planar_diagram_code(next) != planar_diagram_code(d) ? 1 : 0;
      d = std::move(next);
      CHECK(was_theta);
      CHECK(first_homology(exterior(d)) == "Z^2");
      if (knot.hyperbolic) CHECK(name_of_exterior(d) == expected);
    }
  }
  CHECK(changed > 100);
}

TEST_CASE("an IH move four times, or twice the other way, is none", "[handlebody]") {
  // The plane theta curve: the move makes a handcuff graph of it, and the next one the theta curve again.
  const Diagram theta = read_diagram("V[1, 2, 3] V[3, 2, 1]", "test");
  const auto loops = [](const Diagram& d) {
    int count = 0;
    for (int x = 0; x < d.dart_count(); ++x) count += d.node_of(x) == d.node_of(d.opposite(x)) ? 1 : 0;
    return count / 2;
  };
  for (int dart = 0; dart < theta.dart_count(); ++dart) {
    const Diagram handcuff = with_ih(theta, dart);
    CHECK(loops(handcuff) == 2);
    CHECK_FALSE(is_ih(handcuff, handcuff.turned(dart, 1)));
    const Diagram back = with_ih(handcuff, dart);
    CHECK(loops(back) == 0);
    CHECK(regions(handcuff).count == 3);
  }
  for (const Entry& knot : handlebody_knots())
    for (int d = 0; d < knot.diagram.dart_count(); ++d) {
      if (!is_ih(knot.diagram, d)) continue;
      CHECK(with_ih(with_ih(with_ih(with_ih(knot.diagram, d), d), d), d) == knot.diagram);
    }
  CHECK_THROWS_AS(with_ih(read_diagram("braid 1 1 1", "test"), 0), PreconditionError);
  CHECK_THROWS_AS(with_vertex_passed(theta, 0), PreconditionError);
  CHECK_THROWS_AS(with_ih(theta, 6), PreconditionError);
}

TEST_CASE("knots with an unknotting tunnel are trivial handlebody-knots", "[handlebody]") {
  // An arc across a bigon of a rational knot's diagram is an unknotting tunnel: the outside is a handlebody,
  // which has one embedding in the 3-sphere (Waldhausen 1968). The graph itself is knotted, so isotopy alone
  // does not help.
  for (const char* code :
       {"X[1, 4, 2, 5] X[3, 6, 8, 7] X[5, 2, 6, 3] V[7, 9, 1] V[4, 9, 8]",
        "X[4, 2, 5, 1] X[8, 6, 11, 12] X[6, 3, 7, 4] X[2, 7, 3, 8] V[1, 13, 11] V[12, 13, 5]"}) {
    const Diagram graph = read_diagram(code, "test");
    REQUIRE(crossing_count(simplified(graph)) > 0);
    CHECK(crossing_count(simplified_handlebody(graph)) == 0);
    const auto group = algebra::simplified(wirtinger(graph).group);
    CHECK(group.generators == 2);
    CHECK(group.relators.empty());
  }
}

TEST_CASE("handlebody-knots that were slid around are simplified again", "[handlebody]") {
  SplitMix64 random(9);
  int back = 0;
  int tried = 0;
  for (const Entry& knot : handlebody_knots()) {
    INFO(knot.name);
    const int table = crossing_count(knot.diagram);
    Diagram d = knot.diagram;
    for (int k = 0; k < 3; ++k) d = slid_somewhere(d, random);
    const Diagram small = simplified_handlebody(d);
    CHECK(first_homology(exterior(small)) == "Z^2");
    if (knot.hyperbolic) CHECK(name_of_exterior(small) == name_of_exterior(knot.diagram));
    CHECK(crossing_count(small) >= table); // the table has the fewest crossings
    ++tried;
    back += crossing_count(small) == table ? 1 : 0;
  }
  INFO(back << " of " << tried);
  CHECK(back >= 18);
}
