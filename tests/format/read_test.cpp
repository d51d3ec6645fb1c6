// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/read.hpp"

#include "expect.hpp"
#include "support/enumeration.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/fmp.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/snappea.hpp"

#include <catch2/catch.hpp>
#include <chrono>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

const std::string any = "a triangulation: Tetrarch JSON, a SnapPea, Regina or Orb file, a census record or "
                        "an isomorphism signature";

/// The first way in which `tri` does not survive the formats that can hold it; empty if there is none.
std::string broken_round_trip(const Triangulation& tri) {
  const std::string json = write_json(document_of(tri));
  const Document back = read_any(json, "f");
  if (back.triangulation != tri) return "JSON gives another triangulation: " + json;
  if (write_json(back) != json) return "JSON gives other bytes: " + json;
  const std::string text = write_any(back, FileFormat::signature).text;
  if (write_any(read_any(text, "f"), FileFormat::signature).text != text)
    return "the signature changes: " + text;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (tri.is_boundary({t, f})) return {};
  for (const FileFormat format : {FileFormat::snappea, FileFormat::fmp})
    if (read_any(write_any(back, format).text, "f").triangulation != tri)
      return name_of(format) + " changes " + json;
  return {};
}

} // namespace

TEST_CASE("formats are known by their content, then by their extension", "[read]") {
  CHECK(recognise("  {", "f.tri") == FileFormat::json);
  CHECK(recognise("% Triangulation\n", "f.json") == FileFormat::snappea);
  CHECK(recognise("% orb\nname", "f.tri") == FileFormat::orb);
  CHECK(recognise("<?xml version=\"1.0\"?>", "f") == FileFormat::regina);
  CHECK(recognise("\x1f\x8b\x08", "f") == FileFormat::regina);
  CHECK(recognise("2\n1 1 1 1", "f") == FileFormat::fmp);
  CHECK(recognise("2", "f") == FileFormat::fmp);
  CHECK(recognise("cPcbbbiht\n", "f") == FileFormat::signature);
  CHECK(recognise("what is this", "f.json") == FileFormat::json);
  CHECK_FALSE(recognise("what is this", "f"));
  CHECK_FALSE(recognise("", "f"));
  CHECK(format_for_extension("a/b.json") == FileFormat::json);
  CHECK(format_for_extension("b.TRI") == FileFormat::snappea);
  CHECK(format_for_extension("b.sig") == FileFormat::signature);
  CHECK(format_for_extension("b.x.txt") == FileFormat::signature);
  CHECK(format_for_extension("b.fmp") == FileFormat::fmp);
  CHECK(format_for_extension("b.rga") == FileFormat::regina);
  CHECK(format_for_extension("b.orb") == FileFormat::orb);
  CHECK_FALSE(format_for_extension("json"));
  CHECK_FALSE(format_for_extension("b.json/file"));
  CHECK_FALSE(format_for_extension("-"));
}

TEST_CASE("any format gives the same triangulation", "[read]") {
  const Document document = document_of(support::knotted_y(), "Y");
  for (const FileFormat format :
       {FileFormat::json, FileFormat::snappea, FileFormat::fmp, FileFormat::signature}) {
    INFO(name_of(format));
    const Document back = read_any(write_any(document, format).text, "f");
    CHECK(find_isomorphism(back.triangulation, document.triangulation));
  }
  // An editor's byte order mark, and line ends from elsewhere.
  CHECK(read_any("\xEF\xBB\xBF cPcbbbihq\r\n", "f").triangulation == from_signature("cPcbbbihq"));
}

TEST_CASE("a document is read from a file", "[read]") {
  CHECK(read_document(data("good/figure_eight.json")).triangulation.size() == 2);
  CHECK(read_document(data("tri/kernel_gieseking.tri")).name == "Regina_Triangulation");
  CHECK(error_of([] { read_document(data("none.json")); }) == data("none.json") + ": there is no such file");
}

TEST_CASE("every gluing of one and many of two tetrahedra survive every format", "[read]") {
  long seen = 0;
  std::string broken;
  const auto visit = [&](const Triangulation& tri) {
    // Of two tetrahedra every 97th (a prime, so that no pattern of the enumeration is followed).
    if (broken.empty() && (tri.size() == 1 || seen % 97 == 0)) broken = broken_round_trip(tri);
    ++seen;
  };
  support::for_each_small_gluing(visit);
  CHECK(broken.empty());
  INFO(broken);
  CHECK(seen == support::one_tetrahedron_gluings + support::two_tetrahedra_gluings);
  for (const support::ZooEntry& entry : support::zoo())
    CHECK(broken_round_trip(entry.triangulation()).empty());
}

TEST_CASE("bad input gets one line that names place and cause", "[bad][read]") {
  CHECK(complaint("") == "f: the text is empty, expected " + any);
  CHECK(complaint(" \n\n") == "f: the text is empty, expected " + any);
  CHECK(complaint("{\n  \"format\": \"tetra") == "f:2: the JSON text ends too early");
  CHECK(complaint("{\"format\": \"tetrarch-triangulation\",\n\"version\": 3}") ==
        "f:2: version: found the number 3, expected version 1");
  CHECK(complaint("what is this") == "f:1: found 'what', expected " + any);
  CHECK(complaint("\n\nwhat is this", "f.tri") ==
        "f.tri:3: found 'what is this', expected \"% Triangulation\"");
  CHECK(complaint("\ncPcbb!ihq") ==
        "f:2: signature 'cPcbb!ihq' has '!' at position 6, which is no signature letter");
  CHECK(complaint("cPcbbbi").substr(0, 24) == "f:1: signature 'cPcbbbi'");
  CHECK(complaint("cPcbbbihq cPcbbbiht") == "f:1: found 'cPcbbbiht', expected one signature a line");
  CHECK(
      complaint("cPcbbbihq\ncPcbbbiht") ==
      "f: found 2 triangulations of 3-manifolds, expected one: say which by FILE#1 or FILE#NAME, or FILE#*");
  CHECK(complaint("3") == "f:1: the text ends, expected a neighbor of tetrahedron 0, 0 to 2");
  CHECK(complaint("3", "f.sig").substr(0, 18) == "f.sig:1: signature");
  CHECK(complaint("% Triangulation\nname\nnot_attempted") == "f:3: the text ends, expected the volume");
  CHECK(complaint(std::string("\n\x01\x02", 3)) ==
        "f:2: found a binary file (a byte of value 1), expected " + any);
}

TEST_CASE("a hundred megabytes of zeros fail at once", "[bad][read]") {
  // Both the byte and the digit; the time is for both, without the making, and generous for a loaded machine.
  constexpr std::size_t size = 100'000'000;
  for (const char zero : {'\0', '0'}) {
    const std::string text(size, zero);
    const auto start = std::chrono::steady_clock::now();
    const std::string message = complaint(text);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    INFO(message);
    CHECK(message.substr(0, 4) == "f:1:");
    CHECK(message.size() < 200);
    CHECK(seconds.count() < 5);
  }
}

TEST_CASE("long nonsense of every first letter fails with a short line", "[bad][read]") {
  for (int c = 1; c < 256; ++c) {
    if (c == 'a') continue; // the signature of no tetrahedra, and so is any number of them
    for (const char* const source : {"f", "f.json", "f.tri", "f.fmp", "f.sig"}) {
      const std::string message = complaint(std::string(100000, static_cast<char>(c)), source);
      INFO(c << " " << source << ": " << message);
      REQUIRE_FALSE(message.empty());
      REQUIRE(message.size() < 250);
      REQUIRE(message.find('\n') == std::string::npos);
    }
  }
}
