// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/collection.hpp"

#include "expect.hpp"
#include "support/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/signature_text.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

std::string refusal(const std::string& word) {
  return error_of([&] { read_signature_text(word); });
}

std::string said(const std::string& word) {
  const Document document = read_signature_text(word);
  CHECK(signature(document.triangulation) == word.substr(0, word.find_first_of("_(")));
  return document.passed_over.sentence();
}

} // namespace

TEST_CASE("a ledger adds up what was passed over", "[collection]") {
  Ledger ledger;
  CHECK(ledger.empty());
  CHECK(ledger.sentence().empty());
  ledger.note("text packet");
  ledger.note("link", 3);
  ledger.note("text packet", 2);
  ledger.note("script", 0);
  CHECK(ledger.sentence() == "passed over: text packet (3), link (3)");
  Ledger other;
  other.note("link");
  other.note("byte");
  ledger.add(other);
  CHECK(ledger.entries() == std::vector<Ledger::Entry>{{"text packet", 3}, {"link", 4}, {"byte", 1}});
  for (int k = 3; k < 60; ++k) ledger.note("array " + std::to_string(k));
  CHECK(ledger.entries().size() == 60);
  CHECK(ledger.sentence().ends_with("array 48, array 49 and 10 other kinds of things"));
}

TEST_CASE("decorated signatures are read and their decorations noted", "[collection]") {
  CHECK(said("cPcbbbiht").empty());
  // SnapPy's documentation of triangulation_isosig has the first two; the third is of the veering census.
  CHECK(said("cPcbbbiht_BaCB") == "passed over: decoration _BaCB");
  CHECK(said("cPcbbbiht_BaCB(1,2)") ==
        "passed over: Dehn filling (1,2) of cusp 0, which is open here, decoration _BaCB");
  CHECK(said("cPcbbbiht_12") == "passed over: decoration _12");
  CHECK(said("eLPkbdcddhgggb(0,0)(-5,1.5)") ==
        "passed over: Dehn filling (-5,1.5) of cusp 1, which is open here");
  CHECK(read_any("eLPkbdcddhgggb_baBabBBA\n", "f").passed_over.sentence() ==
        "passed over: decoration _baBabBBA");
}

TEST_CASE("decorations that mean nothing are refused", "[bad][collection]") {
  CHECK(refusal("cPcbbbiht_") == "found the decoration '', expected letters or digits");
  CHECK(refusal("cPcbbbiht_a!") == "found the decoration 'a!', expected letters or digits");
  // A taut angle structure has a digit for each of two tetrahedra, the number of a pair of opposite edges.
  for (const std::string digits : {"1", "120", "13"})
    CHECK(refusal("cPcbbbiht_" + digits) ==
          "found the decoration '" + digits + "', expected 2 digits 0, 1, 2, one for each tetrahedron");
  CHECK(refusal("cPcbbbiht(1)").find("'('") != std::string::npos);
  CHECK(refusal("cPcbbbiht(1,x)").find("'('") != std::string::npos);
  CHECK_FALSE(is_signature_text("m004"));
  CHECK_FALSE(is_signature_text(""));
}

TEST_CASE("signatures that begin with a dash are no options", "[collection]") {
  support::Random random(8);
  const std::string text = signature(support::random_gluing({63, 3, false, true}, random));
  CHECK(text.front() == '-');
  CHECK(is_signature_text(text));
  CHECK(is_signature_text(text + "_abBA(1,2)"));
  for (const char* option : {"-", "-o", "-h", "-ab", "--json", "--", "-o_a", "--seed", "-1", "-#3"})
    CHECK_FALSE(is_signature_text(option));
}

TEST_CASE("a list of signatures has an element for each line", "[collection]") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* line :
         {"# two knots", "cPcbbbiht the figure eight", "", "dLQbcccdero_Ba  5_2", " bkaaid"})
      text += line + end;
    const Collection list = read_all(text, "list.sig");
    REQUIRE(list.elements.size() == 3);
    CHECK(list.passed_over.empty());
    CHECK(list.elements[0].name == "the figure eight");
    CHECK(list.elements[0].document.name == "the figure eight");
    CHECK(list.elements[1].name == "5_2");
    CHECK(list.elements[1].document.passed_over.sentence() == "passed over: decoration _Ba");
    CHECK(list.elements[2].name.empty());
    CHECK(list.elements[2].document.triangulation == from_signature("bkaaid"));
  }
  CHECK(read_all("cPcbbbiht a\n", "f.sig").elements[0].name == "a"); // also a signature, of nothing
  // Recognised without the extension.
  CHECK(read_all("# signatures\ncPcbbbiht\ncPcbbbihq\n", "f").elements.size() == 2);
  CHECK(read_all("\xEF\xBB\xBF"
                 "cPcbbbiht\ncPcbbbihq\n",
                 "f")
            .elements.size() == 2);
}

TEST_CASE("a line of a list that is wrong says so, and the others are read", "[bad][collection]") {
  const Collection list = read_all("cPcbbbiht\r\n\r\ncPcbb!ihq\r\nbkaaid bkaaid\r\ncPcbbbihq\r\n", "f.sig");
  REQUIRE(list.elements.size() == 4);
  CHECK_FALSE(list.elements[0].error);
  CHECK(list.elements[1].error.value().what() ==
        std::string("f.sig:3: signature 'cPcbb!ihq' has '!' at position 6, which is no signature letter"));
  CHECK(list.elements[2].error.value().place.line == 4);
  CHECK(list.elements[2].error.value().message == "found 'bkaaid', expected one signature a line");
  CHECK_FALSE(list.elements[3].error);
  CHECK(error_of([&] { document_of(list.elements[1], {}); }) == list.elements[1].error.value().what());
}

TEST_CASE("several census records are several elements", "[collection]") {
  const std::string one = write_any(document_of(from_signature("cPcbbbihq")), FileFormat::fmp).text;
  const Collection records = read_all(one + one, "f.fmp");
  CHECK(records.elements.size() == 2);
  CHECK(error_of([&] { read_any(one + one, "f.fmp"); }).find("found 2 triangulations") != std::string::npos);
}

TEST_CASE("the only element takes the ledger of its file along", "[collection]") {
  Collection file;
  CHECK(error_of([&] { the_only(file, "f"); }) == "f: found no triangulations of 3-manifolds, expected one");
  file.elements.push_back({"one", document_of(from_signature("bkaaid")), {}});
  file.elements[0].document.passed_over.note("peripheral curve", 2);
  file.passed_over.note("text packet");
  CHECK(the_only(file, "f").passed_over.sentence() == "passed over: peripheral curve (2), text packet");
  for (const char* name : {"two", "three", "four", "five", "six"}) file.elements.push_back({name, {}, {}});
  CHECK(
      error_of([&] {
        the_only(file, "f");
      }).starts_with("f: found 6 triangulations of 3-manifolds ('one', 'two', 'three', ...), expected one"));
}
