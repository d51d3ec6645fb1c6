// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/fields.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/workshop/bundle.hpp"
#include "tetrarch/workshop/canonical.hpp"
#include "tetrarch/workshop/check.hpp"
#include "tetrarch/workshop/embed.hpp"
#include "tetrarch/workshop/fingerprint.hpp"
#include "tetrarch/workshop/identify.hpp"
#include "tetrarch/workshop/info.hpp"
#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/registration.hpp"
#include "tetrarch/workshop/slit.hpp"
#include "tetrarch/workshop/structure.hpp"
#include "tetrarch/workshop/truncate.hpp"
#include "tetrarch/workshop/verify.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

const std::string meshes = TETRARCH_SOURCE_DIR "/tests/data/mesh/";

/// The laws of every list: names are unique words, meanings and types are there, and a result says nothing
/// that the list does not name, and all that is always there.
template <class Result>
void check_list(const Result& result) {
  const Tree tree = tree_of(result);
  std::set<std::string> names;
  for (const FieldNote& note : notes_of<Result>()) {
    INFO(note.name);
    CHECK(names.insert(note.name).second);
    CHECK(std::string(note.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") ==
          std::string::npos);
    CHECK(std::string(note.meaning).size() > 4);
    CHECK_FALSE(note.type.schema().empty());
    if (note.always) CHECK_NOTHROW(tree[note.name]);
  }
  const std::size_t members = tree_of(result).size();
  Tree rest = tree_of(result);
  for (const std::string& name : names) rest.erase(name);
  CHECK(rest.empty());
  CHECK(members <= names.size());
  CHECK(members > 0);
}

} // namespace

TEST_CASE("every result lists its fields once", "[workshop]") {
  for (const char* name : {"cPcbbbihq", "cPcbbbiht", "dLQacccjcog"}) {
    const Triangulation tri = from_signature(name);
    check_list(info(tri));
    check_list(structure(tri));
    StructureOptions certified;
    certified.certify = true;
    check_list(structure(tri, certified));
    check_list(cells(tri));
    check_list(isometry({tri, "x"}, {tri, "x"}));
    check_list(identify::identify(tri));
    check_list(checker::Report());
    check_list(simplify(tri));
    check_list(truncate(tri));
    if (const Placement at = placement(tri); at.verdict() == Verdict::yes) check_list(embedding(at));
  }
  for (const char* name : {"cube.off", "ring_two_holes.off", "gmsh_solid.mesh"})
    check_list(check(open_mesh(meshes + name)));
  check_list(circle_bundle(surface_of(open_mesh(meshes + "cube.off"))));
  const HoledSurface ring = opened(surface_of(open_mesh(meshes + "ring_two_holes.off")));
  check_list(ring);
  for (const MapDomain domain : {MapDomain::cylindric, MapDomain::circular, MapDomain::rectangle}) {
    MapOptions options;
    options.domain = domain;
    check_list(conformal_map(ring, options));
  }
  check_list(conformal_type(ring));
  check_list(registration(ring, ring));
}

TEST_CASE("a structure is found, or the answer says what kind of no it is", "[workshop]") {
  // Yin, section 4.2.3: two regular truncated tetrahedra of angle pi/6.
  const Structure knotted_y = structure(from_signature("cPcbbbihq"));
  CHECK(knotted_y.verdict() == Verdict::yes);
  CHECK(tree_of(knotted_y)["volume"].number() == Approx(6.451990270835).epsilon(0).margin(1e-12));
  CHECK(knotted_y.cusps.empty());
  CHECK(document_of(knotted_y).metric.has_value());

  // One tetrahedron whose vertex links are projective planes: no structure, proved; a search that ends is not
  // proved.
  const Triangulation sphere = from_signature("bkaagb");
  StructureOptions few;
  few.attempts = 3;
  const Structure none = structure(sphere, few);
  CHECK(none.verdict() != Verdict::yes);
  CHECK(tree_of(none)["volume"].is_null());
  CHECK(tree_of(none)["outcome"].text() != "geometric");
}

TEST_CASE("a manifold is isometric to itself relabelled, and not to its sister", "[workshop]") {
  const Triangulation figure_eight = from_signature("cPcbbbiht");
  const Triangulation relabelled_one =
      relabelled(figure_eight, {1, 0}, {Perm4::swap(0, 1), Perm4::swap(2, 3)});
  CHECK(isometry({figure_eight, "a"}, {relabelled_one, "b"}).verdict() == Verdict::yes);
  // The sister has Z + Z/5 for its first homology.
  const Isometry no = isometry({figure_eight, "a"}, {from_signature("cPcbbbdxm"), "b"});
  CHECK(no.verdict() == Verdict::proved_no);
  CHECK(tree_of(no)["proof"].text() == "homology");
  CHECK(text_of(no).find("Z + Z/5") != std::string::npos);
}

TEST_CASE("a type is the part of a schema that says it", "[workshop]") {
  const Type pair = type::list(type::number, 2);
  CHECK(pair.schema().dump() == R"({"type":"array","items":{"type":"number"},"minItems":2,"maxItems":2})");
  const Type both = type::object({{"at", pair}, {"why", type::one_of({"a", "b"}), type::sometimes}});
  CHECK(both.schema()["required"].dump() == R"(["at"])");
  CHECK(both.schema()["properties"]["why"].dump() == R"({"type":"string","enum":["a","b"]})");
  CHECK(both.schema()["additionalProperties"].dump() == "false");
  CHECK(type::or_null(type::text).schema().dump() == R"({"anyOf":[{"type":"string"},{"type":"null"}]})");
  CHECK(type::either(pair, pair).schema().dump() == pair.schema().dump());
  CHECK(Type().schema().dump() == "{}");
}

TEST_CASE("what results of two kinds share is always there if it is in both", "[workshop]") {
  const std::vector<FieldNote> one{{"a", "", "first", type::text}, {"b", "", "first", type::truth}};
  const std::vector<FieldNote> other{{"b", "", "second", type::integer}, {"c", "", "second", type::text}};
  const Tree schema = schema_of(either_of(one, other));
  CHECK(schema["required"].dump() == R"(["b"])");
  CHECK(schema["properties"].size() == 3);
  CHECK(schema["properties"]["b"].dump() ==
        R"({"description":"first","anyOf":[{"type":"boolean"},{"type":"integer"}]})");
  CHECK(schema_of(sometimes(one))["required"].empty());
  CHECK(schema_of(both_of(one, {}))["required"].size() == 2);
}

TEST_CASE("what has no field has no member", "[workshop]") {
  const Tree tree = tree_of(info(from_signature("cPcbbbihq"), "", true));
  CHECK(tree["signature"].is_null());
  CHECK(tree["tetrahedra"].integer() == 2);
  CHECK_THROWS(tree["name"]);
}
