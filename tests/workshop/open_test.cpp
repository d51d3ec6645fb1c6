// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/open.hpp"

#include "support/errors.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

const std::string data = TETRARCH_SOURCE_DIR "/tests/data/";

std::string refusal(const std::string& what) {
  try {
    open_triangulation(what);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("whatever may stand for a manifold is opened", "[workshop]") {
  const std::string figure_eight = "cPcbbbiht";
  CHECK(signature(open_triangulation(figure_eight).triangulation) == figure_eight);
  CHECK(signature(open_triangulation("m004").triangulation) == figure_eight);
  CHECK(signature(open_triangulation("cPcbbbiht_BaCB").triangulation) ==
        figure_eight); // a decorated signature
  CHECK_FALSE(open_triangulation("cPcbbbiht_BaCB").passed_over.empty());
  CHECK(open_triangulation(data + "knotted_y.json").triangulation.size() == 2);
  CHECK(open_triangulation(data + "knotted_y_8k.mesh").triangulation.size() == 7709); // counted in the file
}

TEST_CASE("what is opened says what it is", "[workshop]") {
  CHECK(kind_of(open("cPcbbbiht")) == "triangulation");
  CHECK(kind_of(open("< a, b | abAB >")) == "group");
  CHECK(kind_of(open(data + "mesh/torus.off")) == "surface");
  CHECK(kind_of(open(data + "knotted_y_8k.mesh")) == "mesh");
  CHECK_THROWS_AS(triangulation_of("G", open("< a | >")), InputError);
  CHECK_THROWS_AS(open_mesh("cPcbbbiht"), InputError);
}

TEST_CASE("samples are looked for in the folder given", "[workshop]") {
  const OpenOptions options{{}, data + "mesh"};
  const format::Soup cube = open_mesh("samples/cube.off", options);
  CHECK(cube.triangles.size() == 12); // as the file says
  CHECK(cube.source == "samples/cube.off");
  CHECK(kind_of(open("samples/torus.off", options)) == "surface");
  CHECK_THROWS_WITH(open_mesh("samples/no.off", options),
                    Catch::Contains("no such sample (expected one of cube.off, double_torus.off, "));
  CHECK_THROWS_WITH(open_mesh("samples/no.off", {{}, data + "nowhere"}),
                    Catch::Contains("no samples are installed in " + data + "nowhere"));
  CHECK_THROWS_WITH(open_mesh("samples/cube.off"), Catch::Contains("there is no such file"));
  CHECK(located("samples/cube.off", std::nullopt) == "samples/cube.off");
  CHECK(located("cube.off", data + "mesh") == "cube.off");
}

TEST_CASE("what is not there is refused with the nearest names", "[workshop]") {
  CHECK(refusal("m0041").find("m004") != std::string::npos);
  CHECK(refusal("no_such_file.mesh").find("no file") != std::string::npos);
  CHECK(refusal(data + "knotted_y.json#7").find("1 triangulation") != std::string::npos);
  const Triangulation two(2); // two tetrahedra that nothing joins
  CHECK_THROWS_AS(require_manifold(two, "x"), InputError);
  CHECK_NOTHROW(require_manifolds(two, "x"));
  CHECK_THROWS_AS(require_manifolds(Triangulation(), "x"), InputError);
}

TEST_CASE("a long signature with a dash is no option", "[workshop]") {
  CHECK_FALSE(is_signature_with_dash("--json"));
  CHECK_FALSE(is_signature_with_dash("cPcbbbiht"));
  CHECK(is_signature_with_dash(signature(open_triangulation(data + "knotted_y_8k.mesh").triangulation)));
}
