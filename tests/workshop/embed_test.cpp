// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/embed.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

TEST_CASE("the knotted Y lies in space, with its group and its copies", "[workshop]") {
  PlacementOptions options;
  options.name = "Y";
  Placement at = placement(from_signature("cPcbbbihq"), options);
  REQUIRE(at.verdict() == Verdict::yes);
  CHECK(at.why_not().empty());
  CHECK(at.boundary_count() == 1); // of genus 2
  EmbedOptions how;
  how.bounds = {20, 0, 0};
  const Embedding found = embedding(std::move(at), how);
  CHECK(found.remarks().empty());
  // Two tetrahedra are joined along one face and open at the other six, which three pairings join, each with
  // its inverse: as many generators as there are faces less tetrahedra plus 1, 4 - 2 + 1.
  CHECK(found.at.domain.group.presentation.generators == 3);
  CHECK(found.at.domain.faces.size() % 2 == 0);
  CHECK(found.piece.copies.size() == 20);
  // What is measured in place knows nothing of how it was placed.
  const embed::Residuals& r = found.residuals;
  CHECK(std::max({r.seam, r.relator, r.relator_sl2c, r.edge_rotation, r.boundary_plane, r.gauss_bonnet}) <
        1e-9);

  const Tree tree = tree_of(found);
  CHECK(tree["signature"].text() == "cPcbbbihq");
  // Yin, section 4.2.3: two regular truncated tetrahedra of angle pi/6.
  CHECK(tree["volume"].number() == Approx(6.451990270835).epsilon(0).margin(1e-10));
  CHECK(tree["copies"]["count"].integer() == 20);
  CHECK(tree["domain"]["tetrahedra"].size() == 2);
  CHECK(tree["domain"]["generators"].size() == 3);
  CHECK(tree.size() == notes_of<Embedding>().size());
  CHECK(rows_of(found).front().second == "Y");
}

TEST_CASE("a cusp is unrolled, and there is no other", "[workshop]") {
  const Placement at = placement(from_signature("cPcbbbiht"));
  CHECK(at.boundary_count() == 1);
  EmbedOptions how;
  how.boundary = 0;
  how.bounds = {0, 1, 0};
  const Embedding found = embedding(at, how);
  REQUIRE(found.lift);
  CHECK(found.lift->type == hyperbolic::VertexType::ideal);
  CHECK(found.lift->triangles.size() == 8); // four corners of each of two tetrahedra
  CHECK(found.piece.complete);
  how.boundary = 1;
  CHECK_THROWS_AS(embedding(at, how), PreconditionError);
}

TEST_CASE("what carries no structure is not placed", "[workshop]") {
  const Placement none = placement(from_signature("bkaagb")); // its links are projective planes
  CHECK(none.verdict() == Verdict::undecided);
  CHECK_FALSE(none.why_not().empty());
  CHECK_THROWS_AS(embedding(none), PreconditionError);
}
