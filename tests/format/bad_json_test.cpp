// SPDX-License-Identifier: GPL-2.0-or-later
// Every way to spoil a JSON document that we could think of, and the one line that it gets. The lines are
// counted by hand in `sound`, whose first line is line 1.
#include "tetrarch/format/json.hpp"

#include "expect.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

const std::string sound = R"({
  "format": "tetrarch-triangulation",
  "version": 1,
  "name": "figure eight",
  "tetrahedra": 2,
  "gluings": [
    [[1, "0123"], [1, "1203"], [1, "1032"], [1, "3021"]],
    [[0, "0123"], [0, "1320"], [0, "2013"], [0, "1032"]]
  ],
  "metric": {
    "edge_lengths": [
      [1, 2, 3, 4, 5, 6],
      [1, 2, 3, 4, 5, null]
    ],
    "dihedral_angles": [
      [1.5, 1.5, 1.5, 1.5, 1.5, 1.5],
      [0.5, 0.5, 0.5, 0.5, 0.5, "0.25"]
    ],
    "volume": 2.02988321
  },
  "provenance": {}
}
)";

std::string json_complaint(const std::string& text) {
  return error_of([&] { read_json(text, "f"); });
}

/// The complaint about `sound` with one thing changed.
std::string spoilt(const std::string& from, const std::string& to) {
  return json_complaint(with(sound, from, to));
}

} // namespace

TEST_CASE("the sound document is sound", "[bad][json]") {
  CHECK(json_complaint(sound).empty());
}

TEST_CASE("text that is no JSON", "[bad][json]") {
  CHECK(json_complaint("") == "f: the text is empty, expected a JSON object");
  CHECK(json_complaint(" \n\t") == "f: the text is empty, expected a JSON object");
  CHECK(json_complaint("[1]") == "f:1: found an array, expected an object");
  CHECK(json_complaint("\n3") == "f:2: found the number 3, expected an object");
  CHECK(json_complaint("\n\n nul ") == "f:3: the JSON text ends too early");
  CHECK(json_complaint("{\n\"a\": nil}") == "f:2: found 'ni' where the JSON text breaks: invalid literal");
  CHECK(json_complaint(sound + "garbage") ==
        "f:23: found 'g' where the JSON text breaks: invalid literal, expected end of input");
  CHECK(json_complaint(sound + "{}") ==
        "f:23: found '{' where the JSON text breaks: unexpected '{', expected end of input");
  CHECK(spoilt("\"version\": 1,", "\"version\": 1") ==
        "f:4: found '\"name\"' where the JSON text breaks: unexpected string literal, expected '}'");
  CHECK(spoilt("figure eight", "figure\neight").substr(0, 4) == "f:4:");
  CHECK(json_complaint("{\"a\": \"\xff\"}").substr(0, 4) == "f:1:");
}

TEST_CASE("a text cut anywhere ends too early", "[bad][json]") {
  CHECK(json_complaint(sound.substr(0, sound.find("[[0,"))) ==
        "f:7: the JSON text ends too early, expected '[', '{', or a literal");
  const std::size_t brace = sound.rfind('}');
  for (std::size_t length = 0; length <= brace; ++length) {
    const std::string message = json_complaint(sound.substr(0, length));
    INFO(length << ": " << message);
    REQUIRE_FALSE(message.empty());
    REQUIRE(message.find('\n') == std::string::npos);
    REQUIRE(message.size() < 200);
  }
}

TEST_CASE("another format or version", "[bad][json]") {
  CHECK(spoilt("tetrarch-triangulation", "something-else") ==
        "f:2: format: found the string 'something-else', expected \"tetrarch-triangulation\"");
  CHECK(spoilt("\"version\": 1", "\"version\": 2") == "f:3: version: found the number 2, expected version 1");
  CHECK(spoilt("\"version\": 1", "\"version\": \"1\"") ==
        "f:3: version: found the string '1', expected version 1");
  CHECK(spoilt("\"version\": 1", "\"version\": []") == "f:3: version: found an array, expected version 1");
  CHECK(spoilt("\"version\": 1", "\"version\": 1.0") ==
        "f:3: version: found the number 1.0, expected version 1");
  // A file of a later version is not blamed for what it does with its gluings.
  CHECK(json_complaint("{\n\"version\": 2,\n\"gluings\": \"elsewhere\"}") ==
        "f:2: version: found the number 2, expected version 1");
}

TEST_CASE("missing and repeated members", "[bad][json]") {
  CHECK(spoilt("  \"format\": \"tetrarch-triangulation\",\n", "") == "f:1: the member \"format\" is missing");
  CHECK(spoilt("  \"version\": 1,\n", "") == "f:1: the member \"version\" is missing");
  CHECK(spoilt("  \"tetrahedra\": 2,\n", "") == "f:1: the member \"tetrahedra\" is missing");
  CHECK(json_complaint(R"({"format":"tetrarch-triangulation","version":1,"tetrahedra":0})") ==
        "f:1: the member \"gluings\" is missing");
  CHECK(spoilt("\"provenance\": {}", "\"provenance\": {},\n\"version\": 1") ==
        "f:22: version: the member is there twice");
  CHECK(spoilt("\"provenance\": {}", "\"p\": {\"a\": 1,\n\"a\": 2}") ==
        "f:22: p.a: the member is there twice");
}

TEST_CASE("members of a wrong type", "[bad][json]") {
  CHECK(spoilt("\"figure eight\"", "8") == "f:4: name: found the number 8, expected a string");
  CHECK(spoilt("\"tetrahedra\": 2", "\"tetrahedra\": -2") ==
        "f:5: tetrahedra: found the number -2, expected the number of tetrahedra");
  CHECK(spoilt("\"tetrahedra\": 2", "\"tetrahedra\": \"2\"") ==
        "f:5: tetrahedra: found the string '2', expected the number of tetrahedra");
  CHECK(spoilt("\"provenance\": {}", "\"provenance\": \"me\"") ==
        "f:21: provenance: found the string 'me', expected an object");
  CHECK(json_complaint(R"({"gluings": 5})") ==
        "f:1: gluings: found the number 5, expected an array with one entry per tetrahedron");
  CHECK(json_complaint(R"({"gluings": {}})") ==
        "f:1: gluings: found an object, expected an array with one entry per tetrahedron");
}

TEST_CASE("a count is believed only with what it counts", "[bad][json]") {
  CHECK(spoilt("\"tetrahedra\": 2", "\"tetrahedra\": 1000000000000") ==
        "f:5: tetrahedra: found the number 1000000000000, expected 2, the number of entries of \"gluings\"");
}

TEST_CASE("faces that are none", "[bad][json]") {
  const std::string face = "[1, \"1203\"]";
  CHECK(spoilt(face, "7") ==
        "f:7: gluings[0][1]: found the number 7, expected null or [tetrahedron, \"permutation\"]");
  CHECK(spoilt(face, "[]") ==
        "f:7: gluings[0][1]: found the end of the array, expected a tetrahedron, counted from 0");
  CHECK(spoilt(face, "[1]") ==
        "f:7: gluings[0][1]: found the end of the array, expected a permutation like \"0132\"");
  CHECK(spoilt(face, "[1, \"1203\", 1]") ==
        "f:7: gluings[0][1]: found the number 1, expected the end of [tetrahedron, \"permutation\"]");
  CHECK(spoilt(face, "[-1, \"1203\"]") ==
        "f:7: gluings[0][1]: found the number -1, expected a tetrahedron, counted from 0");
  CHECK(spoilt(face, "[1.5, \"1203\"]") ==
        "f:7: gluings[0][1]: found the number 1.5, expected a tetrahedron, counted from 0");
  CHECK(spoilt(face, "[9999999999, \"1203\"]") ==
        "f:7: gluings[0][1]: found the number 9999999999, expected a tetrahedron, counted from 0");
  CHECK(spoilt(face, "[1, {}]") ==
        "f:7: gluings[0][1]: found an object, expected a permutation like \"0132\"");
  CHECK(spoilt(", [1, \"3021\"]]", "]") ==
        "f:7: gluings[0]: found the end of the array, expected null or [tetrahedron, \"permutation\"]");
  CHECK(spoilt("\"3021\"]]", "\"3021\"], null]") ==
        "f:7: gluings[0][4]: found null, expected the end of four faces");
  CHECK(spoilt("[[0, \"0123\"]", "3, [[0, \"0123\"]") ==
        "f:8: gluings[1]: found the number 3, expected an array of four faces");
}

TEST_CASE("permutations that are none", "[bad][json]") {
  for (const std::string wrong : {"1204", "1223", "123", "01234", "abcd", "", " 123"})
    CHECK(spoilt("1203", wrong) ==
          "f:7: gluings[0][1]: found the string '" + wrong + "', expected a permutation like \"0132\"");
}

TEST_CASE("gluings that cannot be", "[bad][json]") {
  CHECK(spoilt("[1, \"1203\"]", "[2, \"1203\"]") ==
        "f:7: gluings[0][1]: face 1 of tetrahedron 0 is glued to tetrahedron 2, expected one of 0 to 1");
  CHECK(spoilt("[1, \"1203\"]", "[0, \"0123\"]") ==
        "f:7: gluings[0][1]: face 1 of tetrahedron 0 is glued to itself");
  CHECK(spoilt("[1, \"1203\"]", "null") == "f:8: gluings[1][2]: face 2 of tetrahedron 1 is glued to face 1 "
                                           "of tetrahedron 0, which is on the boundary "
                                           "seen from its side");
  CHECK(spoilt("[1, \"1203\"]", "[1, \"0123\"]") == "f:7: gluings[0][1]: face 1 of tetrahedron 1 is glued "
                                                    "twice: to face 1 of tetrahedron 0 and to face 3 of "
                                                    "tetrahedron 0");
  CHECK(spoilt("[1, \"1203\"]", "[1, \"0213\"]") == "f:7: gluings[0][1]: face 1 of tetrahedron 0 is glued to "
                                                    "face 2 of tetrahedron 1 by 0213, which says 2013 "
                                                    "where the inverse 0213 was expected");
}

TEST_CASE("metrics that are none", "[bad][json]") {
  CHECK(spoilt("[1, 2, 3, 4, 5, 6],\n", "") ==
        "f:11: metric.edge_lengths: found 1 entries, expected 2 entries, one per tetrahedron");
  CHECK(spoilt("4, 5, null]", "4, 5]") ==
        "f:13: metric.edge_lengths[1]: expected an array of six numbers, for the edges 01,02,03,12,13,23");
  CHECK(spoilt("5, null]", "5, true]") ==
        "f:13: metric.edge_lengths[1][5]: found true, expected a number or a string of digits");
  CHECK(spoilt("\"0.25\"", "null") ==
        "f:17: metric.dihedral_angles[1][5]: found null, expected a number or a string of digits");
  CHECK(spoilt("\"0.25\"", "\"a quarter\"") == "f:17: metric.dihedral_angles[1][5]: found the string 'a "
                                               "quarter', expected a number or a string of digits");
  CHECK(spoilt("\"0.25\"", "9007199254740993") == "f:17: metric.dihedral_angles[1][5]: found the number "
                                                  "9007199254740993, expected a string of digits, because a "
                                                  "double would lose some");
  CHECK(spoilt("2.02988321", "[]") ==
        "f:19: metric.volume: found an array, expected a number or a string of digits");
}

TEST_CASE("numbers beyond a double are refused, not rounded", "[bad][json]") {
  CHECK(spoilt("\"provenance\": {}", "\"x\": [1,\n 0.123456789012345678901]") ==
        "f:22: x[1]: found the number '0.123456789012345678901', which is beyond a double; expected a string "
        "of digits");
  CHECK(spoilt("\"provenance\": {}", "\"x\":\n 1e400") ==
        "f:22: found the number '1e400', which is beyond a double; expected a string of digits");
  CHECK(spoilt("\"provenance\": {}", "\"x\":\n 1e-400") ==
        "f:22: x: found the number '1e-400', which is beyond a double; expected a string of digits");
  CHECK(spoilt("\"provenance\": {}", "\"x\": 0.100000000000000000000000").empty());
}

TEST_CASE("nesting bombs and long texts stay small", "[bad][json]") {
  const std::string deep = spoilt("\"provenance\": {}", "\"x\":\n" + std::string(1000000, '['));
  CHECK(deep.substr(0, 9) == "f:22: 'x[");
  const std::string ending = ": nested more than 64 deep";
  CHECK(deep.substr(deep.size() - ending.size()) == ending);
  CHECK(deep.size() < 200);
  const std::string long_key = spoilt("\"provenance\": {}", "\"" + std::string(1000000, 'k') + "\": 1e-400");
  CHECK(long_key.size() < 200);
  const std::string long_text = spoilt("\"figure eight\"", std::string(1000000, 'n'));
  CHECK(long_text.size() < 200);
  std::string many_keys;
  for (int k = 0; k < 20000; ++k) many_keys += ", \"k" + std::to_string(k) + "\": 0";
  CHECK(spoilt("\"provenance\": {}", "\"provenance\": {}" + many_keys).empty());
}

// By hand: the two classes of `sound` hold 01, 02, 23 of tetrahedron 0 with 01, 03, 23 of tetrahedron 1, and
// the six others.
TEST_CASE("bad marks", "[bad][json]") {
  const auto marked = [](const std::string& marks) {
    return spoilt("\"metric\": {", "\"marks\": " + marks + ",\n  \"metric\": {");
  };
  CHECK(marked("[]").empty());
  CHECK(marked("[[0, \"01\", 3], [1, \"21\", 0]]").empty());
  CHECK(marked("[[0, \"01\", 2.5], [0, \"10\", 2.5]]").empty());
  CHECK(marked("3") == "f:10: marks: found the number 3, expected an array of marks");
  for (const char* const bad :
       {"[3]", "[[0, \"01\"]]", "[[2, \"01\", 3]]", "[[-1, \"01\", 3]]", "[[0, \"04\", 3]]",
        "[[0, \"11\", 3]]", "[[0, 1, 3]]", "[[0, \"0\", 3]]", "[[0, \"01\", 0.5]]", "[[0, \"01\", -1]]",
        "[[0, \"01\", \"3\"]]", "[[0, \"01\", 3], [0, \"10\", 4]]", "[[0, \"01\", 3], [1, \"32\", 4]]"}) {
    INFO(bad << ": " << marked(bad));
    CHECK(marked(bad).starts_with("f:10: marks"));
  }
}
