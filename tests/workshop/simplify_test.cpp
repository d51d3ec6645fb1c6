// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/simplify.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/subdivide.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::workshop;

TEST_CASE("the figure eight in 48 tetrahedra becomes one of two again", "[workshop]") {
  const Triangulation figure_eight = from_signature("cPcbbbiht");
  const Triangulation fine = moves::barycentric(figure_eight).tri; // 24 of each
  SimplifyOptions options;
  options.keep_log = true;
  options.audit = true;
  const Simplification found = simplify(fine, options);
  CHECK(found.input_tetrahedra == 48);
  // No orientable cusped one has fewer.
  CHECK(found.triangulation.size() == 2);
  CHECK(found.info.homology == "Z");
  CHECK(found.info.signature == "cPcbbbiht");
  CHECK_FALSE(found.log.empty());
  CHECK(tree_of(found)["input_tetrahedra"].integer() == 48);
  CHECK(tree_of(found).size() <= notes_of<Simplification>().size());
}

TEST_CASE("a boundary stays as it is where that is asked for", "[workshop]") {
  const Triangulation ball = moves::barycentric(Triangulation(1)).tri; // 24 triangles on the boundary
  SimplifyOptions keeping;
  keeping.keep_boundary = true;
  const auto faces = [](const Simplification& found) {
    return 2 * found.info.faces - 4 * found.info.tetrahedra; // each inner face lies on two tetrahedra
  };
  CHECK(faces(simplify(ball, keeping)) == 24);
  CHECK(faces(simplify(ball)) < 24);
}
