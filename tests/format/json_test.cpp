// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/json.hpp"

#include "expect.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"

#include <catch2/catch.hpp>
#include <clocale>
#include <locale>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

std::string read_and_written(const std::string& text) {
  return write_json(read_json(text, "text"));
}

} // namespace

TEST_CASE("reading what was written gives the same bytes", "[json]") {
  // The fixtures are in canonical form; they were typed by hand, their numbers are made up.
  for (const std::string& path : files_in("good")) {
    INFO(path);
    const std::string text = read_file(path);
    CHECK(read_and_written(text) == text);
  }
  for (const support::ZooEntry& entry : support::zoo()) {
    INFO(entry.name);
    const std::string text = write_json(document_of(entry.triangulation(), entry.name));
    const Document back = read_json(text, "text");
    CHECK(back.triangulation == entry.triangulation());
    CHECK(back.name == entry.name);
    CHECK(write_json(back) == text);
  }
}

TEST_CASE("layout is canonical, whatever it was", "[json]") {
  const std::string text = R"({"version":1,"tetrahedra":1,"format":"tetrarch-triangulation",
      "gluings":[[null,
                  null,[0,"1230"],[0,"3012"]]],"x":[1,{"y":2}]})";
  CHECK(read_and_written(text) == R"({
  "version": 1,
  "tetrahedra": 1,
  "format": "tetrarch-triangulation",
  "gluings": [
    [null, null, [0, "1230"], [0, "3012"]]
  ],
  "x": [
    1,
    {
      "y": 2
    }
  ]
}
)");
}

TEST_CASE("what changes is rewritten in its place, the rest survives", "[json]") {
  const std::string text = read_file(data("good/unknown_members.json"));
  Document document = read_json(text, "text");
  document.name = "renamed";
  document.metric->volume.reset();
  Json provenance = document.provenance;
  provenance["date"] = "today";
  document.provenance = provenance;
  std::string expected = with(text, R"(knotted Y \"typed in\")", "renamed");
  expected = with(expected, ",\n    \"volume\": \"6.45199027083500000000\"", "");
  expected = with(expected, "\"date\": null", "\"date\": \"today\"");
  CHECK(write_json(document) == expected);
  document.name.clear();
  document.metric.reset();
  document.provenance = nullptr;
  const Json bare = Json::parse(write_json(document));
  std::vector<std::string> keys;
  for (const auto& item : bare.items()) keys.push_back(item.key());
  CHECK(keys ==
        std::vector<std::string>{"comment", "format", "version", "colours", "tetrahedra", "gluings", "last"});
}

TEST_CASE("numbers keep every digit", "[json]") {
  const Document document = read_json(read_file(data("good/unknown_members.json")), "text");
  const Metric& metric = *document.metric;
  CHECK(metric.dihedral_angles[0][0].is_text());
  CHECK(metric.dihedral_angles[0][0].text() == "0.523598775598298873077107230547");
  CHECK(metric.dihedral_angles[0][0].value() == 0.523598775598298873077107230547);
  CHECK(metric.dihedral_angles[1][5] == Number(1e22));
  CHECK_FALSE(metric.edge_lengths[1][5].has_value());
  CHECK(metric.volume == Number("6.45199027083500000000"));
  CHECK(document.members.get().at("colours").at("weight") == 0.1 + 0.2);
  CHECK_THROWS_AS(Number(std::numeric_limits<double>::infinity()), PreconditionError);
  CHECK_THROWS_AS(Number("0x10"), PreconditionError);
  CHECK_THROWS_AS(Number("1,5"), PreconditionError);
  CHECK_THROWS_AS(Number("01"), PreconditionError);
  CHECK(Number(-0.0) == Number(0.0)); // JSON's integer -0 would come back as 0
}

TEST_CASE("doubles of every size survive as metric", "[json]") {
  Document document = document_of(Triangulation(1));
  document.metric.emplace();
  PerEdge<Number>& angles = document.metric->dihedral_angles.emplace_back();
  angles = {Number(123456789012345683968.0), Number(5e-324),
            Number(1.7976931348623157e308),  Number(9007199254740993.0),
            Number(18446744073709551616.0),  Number(-9223372036854775808.0)};
  const std::string text = write_json(document);
  CHECK(read_json(text, "text").metric->dihedral_angles[0] == angles);
  CHECK(read_and_written(text) == text);
}

TEST_CASE("a name that is no UTF-8 does not stop the saving", "[json]") {
  const Document document = document_of(Triangulation(), "caf\xe9");
  CHECK(read_json(write_json(document), "text").name == "caf\xef\xbf\xbd");
}

TEST_CASE("a metric of another size is the caller's mistake", "[json]") {
  Document document = document_of(Triangulation(2));
  document.metric.emplace();
  document.metric->dihedral_angles.resize(1);
  CHECK_THROWS_AS(write_json(document), PreconditionError);
  document.metric.reset();
  document.provenance = Json("a text");
  CHECK_THROWS_AS(write_json(document), PreconditionError);
}

TEST_CASE("no locale changes a document", "[json]") {
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string text = read_file(data("good/unknown_members.json"));
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new German));
  // The C locale too, where the machine has one with a decimal comma.
  const std::string old_c = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* const name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"})
    if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
  const std::string result = read_and_written(text);
  std::setlocale(LC_NUMERIC, old_c.c_str());
  std::locale::global(old);
  CHECK(result == text);
}

TEST_CASE("a large triangulation is read and written in linear time", "[json]") {
  // 20,000 tetrahedra in a row, each glued to the next by two faces.
  const int n = 20000;
  Triangulation tri(n);
  for (int t = 0; t + 1 < n; ++t) tri.glue({t, 0}, t + 1, Perm4(1, 0, 3, 2));
  for (int t = 0; t + 1 < n; ++t) tri.glue({t, 2}, t + 1, Perm4(1, 0, 3, 2));
  const std::string text = write_json(document_of(tri));
  CHECK(read_json(text, "text").triangulation == tri);
}

TEST_CASE("marks survive", "[json]") {
  Document document = document_of(from_signature("cPcbbbiht"));
  document.marks = {{{0, 3}, 0}, {{1, 5}, 2.5}};
  const std::string text = write_json(document);
  CHECK(text.find("\"marks\": [\n    [0, \"12\", 0],\n    [1, \"23\", 2.5]\n  ]") != std::string::npos);
  const Document again = read_json(text, "f");
  CHECK(again.marks == document.marks);
  CHECK(write_json(again) == text);
  // What else can be written has no place for them, and says so.
  for (const FileFormat format : {FileFormat::snappea, FileFormat::signature})
    CHECK(write_any(document, format).warnings.back() ==
          "the orders of 2 edges are left out: only JSON holds them");
  document.marks.clear();
  CHECK(write_json(document).find("marks") == std::string::npos);
}
