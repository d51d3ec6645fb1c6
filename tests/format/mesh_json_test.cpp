// SPDX-License-Identifier: GPL-2.0-or-later
// JSON of meshes and groups: what is read back, and what is refused and how.
#include "tetrarch/format/mesh_json.hpp"

#include "expect.hpp"
#include "meshes.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/json.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

using On = MeshField::On;

/// Lines are counted by hand; the first is line 1.
const std::string sound_mesh = R"({
  "format": "tetrarch-mesh",
  "version": 1,
  "vertices": [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0.5]
  ],
  "triangles": [
    [0, 1, 2]
  ],
  "triangle_tags": [
    4
  ],
  "fields": [
    {
      "name": "uv",
      "on": "vertices",
      "values": [
        [0, 0],
        [1, null],
        [0, 1]
      ]
    }
  ]
}
)";

std::string mesh_complaint(const std::string& text) {
  return error_of([&] { read_mesh_json(text, "f"); });
}
std::string spoilt_mesh(const std::string& from, const std::string& to) {
  return mesh_complaint(with(sound_mesh, from, to));
}

MeshDocument with_field(MeshField field) {
  MeshDocument mesh = mesh_document_of(two_tetrahedra());
  mesh.fields = {std::move(field)};
  return mesh;
}

} // namespace

TEST_CASE("a mesh with everything survives as JSON", "[json][mesh]") {
  MeshDocument mesh = mesh_document_of(two_tetrahedra());
  mesh.soup.points[1] = {5e-324, 1.7976931348623157e308, -0.0};
  mesh.soup.points[2] = {9007199254740993.0, 18446744073709551616.0, 0.1};
  mesh.soup.triangle_tags = {-3};
  mesh.hexahedra = {{0, 1, 2, 3, 4, 3, 2, 1}};
  mesh.name = "caf\xc3\xa9";
  mesh.provenance = Json{{"by", "hand"}};
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.fields = {field_of("height", On::vertices, std::vector<double>{0, 1, -0.0, none, 2}),
                 field_of("area", On::triangles, std::vector<double>{0.5}),
                 field_of("volume", On::tetrahedra, std::vector<double>{1, 2}),
                 field_of("jacobian", On::hexahedra, std::vector<double>{-1}),
                 field_of("uv", On::triangle_corners, std::vector<std::array<double, 2>>(3, {0, 0.1})),
                 field_of("uvw", On::tetrahedron_corners, std::vector<std::array<double, 3>>(8, {1, 2, 3}))};
  const std::string text = write_mesh_json(mesh);
  const MeshDocument back = read_mesh_json(text, "f");
  CHECK(write_mesh_json(back) == text);
  CHECK(back.soup.points == mesh.soup.points);
  CHECK(std::signbit(back.soup.points[1][2]));
  CHECK(back.soup.triangles == mesh.soup.triangles);
  CHECK(back.soup.triangle_tags == mesh.soup.triangle_tags);
  CHECK(back.soup.tetrahedra == mesh.soup.tetrahedra);
  CHECK(back.hexahedra == mesh.hexahedra);
  CHECK(back.name == mesh.name);
  CHECK(back.provenance == mesh.provenance);
  REQUIRE(back.fields.size() == mesh.fields.size());
  for (std::size_t k = 0; k < mesh.fields.size(); ++k) {
    CHECK(back.fields[k].name == mesh.fields[k].name);
    CHECK(back.fields[k].on == mesh.fields[k].on);
    CHECK(back.fields[k].components == mesh.fields[k].components);
    CHECK(back.fields[k].values.size() == mesh.fields[k].values.size());
  }
  CHECK(find_field(back, "area")->values == std::vector<double>{0.5});
  CHECK(std::isnan(find_field(back, "height")->values[3]));
  CHECK(find_field(back, "nothing") == nullptr);
}

TEST_CASE("a JSON mesh is read as any other mesh", "[json][mesh]") {
  CHECK(recognise_mesh(sound_mesh, "f.json") == MeshFormat::json);
  CHECK(recognise_mesh("{\"x\": [{\"format\": 1}], \"format\": \"tetrarch-mesh\"}", "f") == MeshFormat::json);
  CHECK_FALSE(recognise_mesh("{\"format\": \"tetrarch-triangulation\"}", "f.obj"));
  CHECK_FALSE(recognise_mesh("{\"x\": {\"format\": \"tetrarch-mesh\"}}", "f.json"));
  CHECK_FALSE(looks_like_mesh_json(R"({"format": "tetrarch-group", "format": "tetrarch-mesh"})"));
  CHECK_FALSE(looks_like_mesh_json("[\"format\", \"tetrarch-mesh\"]"));
  CHECK_FALSE(looks_like_mesh_json(std::string(1000000, '[')));
  const Soup soup = read_soup(sound_mesh, "f");
  CHECK(soup.source == "f");
  CHECK(soup.points.size() == 3);
  CHECK(soup.triangle_tags == std::vector<int>{4});
  CHECK(write_soup(read_soup(write_soup(soup, MeshFormat::json), "f"), MeshFormat::json) ==
        write_soup(soup, MeshFormat::json));
}

TEST_CASE("bad JSON meshes are told by place and cause", "[bad][json][mesh]") {
  CHECK(mesh_complaint(sound_mesh).empty());
  CHECK(mesh_complaint("") == "f: the text is empty, expected a JSON object");
  CHECK(mesh_complaint("{}") == "f:1: the member \"format\" is missing");
  CHECK(spoilt_mesh("tetrarch-mesh", "tetrarch-triangulation") ==
        "f:2: format: found the string 'tetrarch-triangulation', expected \"tetrarch-mesh\"");
  CHECK(spoilt_mesh("\"version\": 1", "\"version\": 2") ==
        "f:3: version: found the number 2, expected version 1");
  CHECK(spoilt_mesh("\"vertices\": [", "\"points\": [") == "f:1: the member \"vertices\" is missing");
  CHECK(spoilt_mesh("[1, 0, 0]", "[1, 0]") == "f:6: vertices[1]: found 2 entries, expected 3 coordinates");
  CHECK(spoilt_mesh("[1, 0, 0]", "7") ==
        "f:6: vertices[1]: found the number 7, expected an array of 3 coordinates");
  CHECK(spoilt_mesh("[1, 0, 0]", "[1, null, 0]") == "f:6: vertices[1][1]: found null, expected a number");
  CHECK(spoilt_mesh("[0, 1, 2]", "[0, 1, 3]") ==
        "f:10: triangles[0][2]: found the number 3, expected a vertex, 0 to 2");
  CHECK(spoilt_mesh("[0, 1, 2]", "[0, -1, 2]") ==
        "f:10: triangles[0][1]: found the number -1, expected a vertex, 0 to 2");
  CHECK(spoilt_mesh("[0, 1, 2]", "[0, 18446744073709551615, 2]") ==
        "f:10: triangles[0][1]: found the number 18446744073709551615, expected a vertex, 0 to 2");
  CHECK(spoilt_mesh("    4\n", "    4, 5\n") ==
        "f:12: triangle_tags: found 2 entries, expected 1 entries, one per triangle");
  CHECK(spoilt_mesh("    4\n", "    4.5\n") ==
        "f:13: triangle_tags[0]: found the number 4.5, expected an integer");
  CHECK(spoilt_mesh("\"fields\": [", "\"fields\": [3,") ==
        "f:15: fields[0]: found the number 3, expected an object");
  CHECK(spoilt_mesh("\"name\"", "\"title\"") == "f:16: fields[0]: the member \"name\" is missing");
  CHECK(spoilt_mesh("\"uv\"", "1") == "f:17: fields[0].name: found the number 1, expected a string");
  CHECK(spoilt_mesh("\"on\": \"vertices\"", "\"on\": \"edges\"") ==
        "f:18: fields[0].on: found the string 'edges', expected one of \"vertices\", \"triangles\", "
        "\"tetrahedra\", \"hexahedra\", \"triangle corners\", \"tetrahedron corners\"");
  CHECK(spoilt_mesh("\"on\": \"vertices\"", "\"on\": \"triangles\"") ==
        "f:19: fields[0].values: found 3 entries, expected 1 entries, one for each of the triangles");
  CHECK(spoilt_mesh("[1, null]", "1") ==
        "f:21: fields[0].values[1]: found 1, expected 2 components as in the entries before");
  CHECK(spoilt_mesh("[1, null]", "[1, true]") ==
        "f:21: fields[0].values[1][1]: found true, expected a number");
  CHECK(spoilt_mesh("[1, null]", "[]") ==
        "f:21: fields[0].values[1]: found an array of 0, expected one to three numbers");
  CHECK(spoilt_mesh("[1, null]", "[1, 9007199254740993]").find("a double would lose some") !=
        std::string::npos);
  CHECK(mesh_complaint(R"({"format":"tetrarch-mesh","version":1,"vertices":[],"triangles":[[0,0,0]]})") ==
        "f:1: triangles[0][0]: found the number 0, expected no vertex, as there are none");
}

TEST_CASE("a JSON mesh cut anywhere is refused", "[bad][json][mesh]") {
  for (std::size_t length = 0; length < sound_mesh.rfind('}'); ++length) {
    const std::string message = mesh_complaint(sound_mesh.substr(0, length));
    REQUIRE_FALSE(message.empty());
    REQUIRE(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("what JSON cannot hold is not written", "[json][mesh]") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(write_mesh_json(with_field(field_of("x", On::triangles, std::vector{infinite}))),
                  PreconditionError);
  CHECK_THROWS_AS(write_mesh_json(with_field(field_of("x", On::triangles, std::vector<double>(2)))),
                  PreconditionError);
  CHECK_THROWS_AS(write_mesh_json(with_field({"x", On::triangles, 4, std::vector<double>(4), {}})),
                  PreconditionError);
  MeshDocument mesh = mesh_document_of(two_tetrahedra());
  mesh.soup.triangles[0][1] = 5;
  CHECK(error_of([&] { (void)write_mesh_json(mesh); }) ==
        "triangles name vertex 5, counted from 0, which is none of the 5 there are");
  mesh = mesh_document_of(two_tetrahedra());
  mesh.soup.triangle_tags = {1, 2};
  CHECK_THROWS_AS(write_mesh_json(mesh), PreconditionError);
}

TEST_CASE("groups survive as JSON", "[json][group]") {
  GroupDocument group;
  CHECK(write_group_json(read_group_json(write_group_json(group), "f")) == write_group_json(group));
  group = {30, {{1, -30}, {}, {2, 2, 2}}, "a group", Json{{"by", "hand"}}, nullptr};
  const std::string text = write_group_json(group);
  const GroupDocument back = read_group_json(text, "f");
  CHECK(back.generators == group.generators);
  CHECK(back.relators == group.relators);
  CHECK(back.name == group.name);
  CHECK(write_group_json(back) == text);
  CHECK(looks_like_group_json(text));
  group.relators = {{31}};
  CHECK_THROWS_AS(write_group_json(group), PreconditionError);
  group.relators = {{0}};
  CHECK_THROWS_AS(write_group_json(group), PreconditionError);
}

TEST_CASE("bad JSON groups are told by place and cause", "[bad][json][group]") {
  const std::string good = "{\n\"format\": \"tetrarch-group\",\n\"version\": 1,\n\"generators\": 2,\n"
                           "\"relators\": [\n[1, -2],\n[2]]}";
  const auto said = [&good](const std::string& from, const std::string& to) {
    return error_of([&] { read_group_json(with(good, from, to), "f"); });
  };
  CHECK(error_of([&] { read_group_json(good, "f"); }).empty());
  CHECK(said("\"generators\": 2", "\"generators\": -2") ==
        "f:4: generators: found the number -2, expected the number of generators, 0 to 4000000");
  CHECK(said("\"generators\": 2", "\"generators\": 2147483647") ==
        "f:4: generators: found the number 2147483647, expected the number of generators, 0 to 4000000");
  CHECK(said("\"generators\"", "\"letters\"") == "f:1: the member \"generators\" is missing");
  CHECK(said("\"relators\"", "\"words\"") == "f:1: the member \"relators\" is missing");
  const std::string wish = ", expected a letter, 1 to 2 or minus that";
  CHECK(said("-2", "-3") == "f:6: relators[0][1]: found the number -3" + wish);
  CHECK(said("-2", "0") == "f:6: relators[0][1]: found the number 0" + wish);
  CHECK(said("-2", "\"b\"") == "f:6: relators[0][1]: found the string 'b'" + wish);
  CHECK(said("[2]", "2") == "f:7: relators[1]: found the number 2, expected an array of letters");
}

TEST_CASE("cells and fibres that do not fit are told by place and cause", "[bad][json]") {
  const auto said = [](const std::string& name, const std::string& from, const std::string& to) {
    const std::string path = std::string(TETRARCH_SOURCE_DIR) + "/tests/data/frozen/1/" + name + ".json";
    const std::string message = error_of([&] { read_json(with(read_file(path), from, to), "f"); });
    return message.substr(message.find(": ") + 2); // without the line
  };
  CHECK(said("octahedron", "[\n      \"octahedron\"\n    ]", "8") ==
        "canonical.cells: found the number 8, expected an array of names");
  CHECK(said("octahedron", "\"octahedron\"", "8") ==
        "canonical.cells[0]: found the number 8, expected the name of a cell");
  CHECK(said("octahedron", "\"cells\"", "\"parts\"") == "canonical: the member \"cells\" is missing");
  CHECK(said("octahedron", "\"cell_of\": [\n      0", "\"cell_of\": [\n      1") ==
        "canonical.cell_of[0]: found the number 1, expected a cell, 0 to 0");
  CHECK(said("octahedron", "\"flat_faces\": [\n      [1, 2]", "\"flat_faces\": [\n      [2, 1]") ==
        "canonical.flat_faces[0][1]: found the number 1, expected a face, 0 to 3, in increasing order");
  CHECK(said("octahedron", "\"flat_faces\": [\n      [1, 2]", "\"flat_faces\": [\n      []")
            .find("is flat, but not from its other side") != std::string::npos);
  CHECK(said("octahedron", "\"isometry_signature\": ", "\"isometry_signature\": 1, \"x\": ") ==
        "canonical.isometry_signature: found the number 1, expected a string");
  CHECK(said("bundle", "\"fiber\": 1", "\"fiber\": 0") ==
        "bundle.fiber: found the number 0, expected the edges of a fiber");
  CHECK(said("bundle", "\"euler_number\": 2", "\"euler_number\": 0.5") ==
        "bundle.euler_number: found the number 0.5, expected an integer or null");
  CHECK(said("bundle", "\"triangle_of\": [", "\"triangle_of\": [ 0,") ==
        "bundle.triangle_of: found 43 entries, expected 42 entries, one per tetrahedron");
  CHECK(said("bundle", "\"levels\": [\n      [0", "\"levels\": [\n      [2") ==
        "bundle.levels[0][0]: found the number 2, expected a level, 0 to 1");
  CHECK(said("bundle", "\"base_triangles\": [\n      [", "\"base_triangles\": [\n      [90, ") ==
        "bundle.base_triangles[0]: found 4 entries, expected 3 vertices");
}
