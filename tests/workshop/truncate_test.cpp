// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/truncate.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/structure.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

const char* const knotted_y_file = TETRARCH_SOURCE_DIR "/tests/data/knotted_y_8k.mesh";

} // namespace

TEST_CASE("a mesh of the knotted Y becomes two truncated tetrahedra of the volume known", "[workshop]") {
  TruncateOptions options;
  options.name = "Y";
  options.keep_log = true;
  const Truncation found = truncate(open_triangulation(knotted_y_file).triangulation, options);
  CHECK(found.input_tetrahedra == 7709); // counted in the file
  CHECK(found.finite_vertices == 0);
  CHECK(found.remarks().empty());
  CHECK_FALSE(found.log.empty());
  REQUIRE(found.boundary.size() == 1);
  CHECK(found.boundary.front().type.genus() == 2);
  // Of a vertex with a link of genus 2: 1 - chi / 2 = 2 = V - E + F - T with F = 2 T.
  CHECK(found.info.vertices - found.info.edges + found.info.tetrahedra == 2);
  // Yin, section 4.2.3: two regular truncated tetrahedra of angle pi/6.
  CHECK(found.triangulation.size() == 2);
  CHECK(structure(found.triangulation).search.structure.volume ==
        Approx(6.451990270835).epsilon(0).margin(1e-10));

  const Tree tree = tree_of(found);
  CHECK(tree["name"].text() == "Y");
  CHECK(tree["tetrahedra"].integer() == 2);
  CHECK(tree["boundary_map"].front()["type"].text() == "genus 2");
  CHECK(tree["steps"].size() == found.steps.size());
  CHECK(tree["seconds"].number() > 0);
  CHECK(tree.size() <= notes_of<Truncation>().size());
  CHECK(rows_of(found, "cut").back().second == "cut");
  CHECK(rows_of(found, "").front().first == "steps");
}

TEST_CASE("a ball is a sphere with a vertex, or it keeps its boundary", "[workshop]") {
  const Triangulation ball(1);
  const Truncation filled = truncate(ball);
  CHECK(filled.finite_vertices == 1);
  CHECK(filled.remarks().size() == 1);
  CHECK(tree_of(filled)["boundary_map"].front()["vertex"].is_null());
  TruncateOptions keeping;
  keeping.keep_spheres = true;
  keeping.audit = true;
  const Truncation kept = truncate(ball, keeping);
  CHECK(kept.finite_vertices == 0);
  CHECK(tree_of(kept)["boundary_map"].front()["vertex"].size() == 2);
}
