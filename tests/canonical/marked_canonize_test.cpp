// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/marked_canonize.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/marked_isomorphism.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/diagram/marked.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/moves/marked.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;
using namespace tetrarch::canonical;
using moves::MarkedTriangulation;

namespace {

/// The graph of a code in the 3-sphere, with these orders of its edges.
MarkedTriangulation graph(const std::string& code, const std::vector<double>& orders) {
  diagram::MarkedDiagram marked = diagram::all_drilled(diagram::read_diagram(code, "test"));
  const diagram::Classes edge = diagram::edges(marked.diagram);
  REQUIRE(edge.count == static_cast<int>(orders.size()));
  for (int d = 0; d < marked.diagram.dart_count(); ++d) marked.fates[d] = orders[edge.of[d]];
  return diagram::marked_exterior(marked);
}

MarkedCanonical colored_cells_of(const MarkedTriangulation& marked) {
  MarkedCanonical found = canonize_marked(marked.tri, marked.marks);
  INFO(found.why_not);
  REQUIRE(found.why_not.empty());
  CHECK_FALSE(found.canonical.proof.certified);
  return found;
}

std::string cells_text(const MarkedTriangulation& marked) {
  return colored_cells_of(marked).canonical.isometry_signature;
}

const char* const plane_k4 = "V[1, 3, 2] V[4, 5, 1] V[2, 6, 4] V[3, 5, 6]";
/// hk5_3, whose symmetries permute the edges of this theta curve as they like.
const char* const theta5 =
    "V[1, 4, 9] V[3, 8, 13] X[10, 6, 11, 7] X[5, 2, 6, 3] X[1, 11, 2, 12] X[12, 5, 13, 4] X[7, 9, 8, 10]";
/// A trefoil with an arc (the edge that is last) across a bigon.
const char* const trefoil_with_arc = "X[1, 4, 2, 5] X[3, 6, 8, 7] X[5, 2, 6, 3] V[7, 9, 1] V[4, 9, 8]";

} // namespace

TEST_CASE("colored cells of the tetrahedron's graph are counted", "[marked-cells]") {
  // Two regular ideal octahedra truncated: two tetrahedra, all of whose 48 symmetries are isometries. Edges
  // of two orders are colored as graphs on four vertices are: 11 of them (OEIS A000088), 48 / symmetries
  // times each.
  std::set<std::string> seen;
  for (int k = 0; k < 64; ++k) {
    std::vector<double> orders;
    for (int e = 0; e < 6; ++e) orders.push_back((k >> e) % 2 == 0 ? 3 : 4);
    const MarkedCanonical found = colored_cells_of(graph(plane_k4, orders));
    CHECK(found.canonical.cells == std::vector<std::string>(2, "tetrahedron"));
    CHECK(found.volume == Approx(7.327724753418).margin(1e-10).epsilon(0));
    CHECK(48 % isometry_group(found.canonical).size() == 0);
    seen.insert(found.canonical.isometry_signature);
  }
  CHECK(seen.size() == 11);
}

TEST_CASE("colored cells know the symmetries of a theta curve", "[marked-cells]") {
  // `isometric --pair` finds that the group of (S^3, hk5_3) is D3; it permutes the edges.
  CHECK(isometry_group(colored_cells_of(graph(theta5, {0, 0, 0})).canonical).size() == 6);
  CHECK(isometry_group(colored_cells_of(graph(theta5, {3, 3, 2})).canonical).size() == 2);
  CHECK(isometry_group(colored_cells_of(graph(theta5, {2, 3, 4})).canonical).size() == 1);
  CHECK(cells_text(graph(theta5, {2, 3, 4})) == cells_text(graph(theta5, {4, 2, 3})));
  CHECK(cells_text(graph(theta5, {2, 3, 4})) == cells_text(graph(theta5, {3, 2, 4})));
  CHECK(cells_text(graph(theta5, {2, 3, 4})) != cells_text(graph(theta5, {2, 3, 5})));
  // The arc across the trefoil is not like the two halves, which are like one another. Witness of the
  // difference: covers of two sheets of the orbifolds' groups (tests/tools/diagrams_test.py).
  const std::string arc = cells_text(graph(trefoil_with_arc, {2, 2, 3}));
  CHECK(cells_text(graph(trefoil_with_arc, {3, 2, 2})) == cells_text(graph(trefoil_with_arc, {2, 3, 2})));
  CHECK(cells_text(graph(trefoil_with_arc, {3, 2, 2})) != arc);
}

TEST_CASE("moves that keep marks keep the colored cells", "[marked-cells]") {
  SplitMix64 random(11);
  int changed = 0;
  for (const char* code : {theta5, trefoil_with_arc}) {
    const MarkedTriangulation start = graph(code, {2, 3, 5});
    const std::string expected = cells_text(start);
    for (int k = 0; k < 15; ++k) {
      const Skeleton skeleton(start.tri);
      moves::MarkedComplex complex(start.tri, skeleton, edge_orders(skeleton, start.marks));
      moves::shake(complex, 1 + k, random);
      const MarkedTriangulation other = complex.compact();
      changed +=
          marked_signature({other.tri, other.marks}) != marked_signature({start.tri, start.marks}) ? 1 : 0;
      CHECK(cells_text(other) == expected);
    }
  }
  CHECK(changed > 20);
}

TEST_CASE("why there are no colored cells", "[bad][marked-cells]") {
  // A knot with a cone angle: its null edge would join cusps.
  const MarkedTriangulation knot = graph("braid 1 -2 1 -2", {5});
  CHECK(canonize_marked(knot.tri, knot.marks).why_not.find("joins two cusps") != std::string::npos);
  CHECK_THROWS_AS(canonize_marked(knot.tri, {}), PreconditionError);
  CHECK_THROWS_AS(canonize_marked(knot.tri, {{{0, 0}, 0.5}}), PreconditionError);
  // A theta curve in the plane has an annulus, so that nothing is found; nothing is claimed either.
  const MarkedTriangulation plane = graph("V[1, 2, 3] V[3, 2, 1]", {3, 3, 3});
  CHECK_FALSE(canonize_marked(plane.tri, plane.marks).why_not.empty());
}
