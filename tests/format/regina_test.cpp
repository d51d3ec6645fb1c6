// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/regina.hpp"

#include "expect.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/snappea.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

const std::string regina_figure_eight = R"(<?xml version="1.0"?>
<regina engine="7.3">
<container label="">
<tri dim="3" size="2" perm="index" label="figure eight">
  <simplex> 1 11 1 13 1 5 1 15 </simplex>
  <simplex> 0 11 0 13 0 5 0 15 </simplex>
</tri>
</container>
</regina>
)";

} // namespace

// The witness is Regina, which wrote the files and named the signatures (record_rga.py).
TEST_CASE("Regina's files hold the triangulations that it was given", "[regina]") {
  std::istringstream lines(read_file(data("rga/regina.txt")));
  int seen = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.front() == '#') continue;
    const std::size_t first = line.find('\t');
    const std::size_t second = line.find('\t', first + 1);
    INFO(line);
    const Document document = read_document(data("rga/" + line.substr(0, first)));
    CHECK(document.name == line.substr(first + 1, second - first - 1));
    CHECK(find_isomorphism(document.triangulation, from_signature(line.substr(second + 1))));
    ++seen;
  }
  CHECK(seen == 7);
  // Not only up to relabelling: both generations hold the same gluings, also on the boundary.
  CHECK(read_document(data("rga/open_2.rga")).triangulation ==
        read_document(data("rga/open_3.rga")).triangulation);
  CHECK(read_document(data("rga/open_3.rga")).triangulation.gluing({0, 0}) == Gluing{1, Perm4(0, 2, 1, 3)});
  CHECK(read_any(regina_figure_eight, "f").triangulation ==
        read_document(data("rga/figure_eight_2.rga")).triangulation);
  // Files of 2003 write the byte with a sign: these two lines are of Regina's own testsuite/engine/file4.rga.
  const auto of_2003 = [](const std::string& code) {
    return "<?xml version=\"1.0\"?>\n<reginadata engine=\"3.0.0\"><packet label=\"f\" type=\"Triangulation\" "
           "typeid=\"3\" "
           "parent=\"\"><tetrahedra ntet=\"2\"><tet desc=\"\"> 1 108 1 75 1 30 1 " +
           code + " </tet>\n<tet desc=\"\"> 0 108 0 75 0 30 0 " + code +
           " </tet></tetrahedra></packet></reginadata>\n";
  };
  CHECK(signature(read_any(of_2003("-58"), "f").triangulation) == "cPcbbbiht"); // so Regina 7.3
  CHECK(read_any(of_2003("-58"), "f").triangulation == read_any(of_2003("198"), "f").triangulation);
  CHECK_THROWS_AS(read_any(of_2003("-129"), "f"), InputError);
}

TEST_CASE("wrong Regina files", "[bad][regina]") {
  const auto spoilt = [](const std::string& from, const std::string& to) {
    return complaint(with(regina_figure_eight, from, to));
  };
  CHECK(spoilt("<simplex> 1 11", "<simplex> 1 10").substr(0, 15) == "f:5: face 0 of ");
  CHECK(spoilt("<simplex> 1 11", "<simplex> 1 24") == "f:5: found '24', expected a permutation");
  CHECK(spoilt("<simplex> 0 11", "<simplex> x 11") == "f:6: found 'x', expected a neighbor");
  CHECK(spoilt(" 1 15 <", " 1 <") == "f:5: the text ends, expected a permutation");
  CHECK(spoilt(" 1 15 <", " 1 15 3 <") == "f:5: found '3', expected four neighbors");
  CHECK(spoilt("size=\"2\"", "size=\"3\"") == "f:4: found 2 tetrahedra, expected '3'");
  CHECK(spoilt("perm=\"index\"", "perm=\"pack\"") ==
        "f:4: found 'pack', expected the permutations by their index");
  CHECK(spoilt("</tri>", "").substr(0, 24) == "f:8: the text is no XML:");
  CHECK(spoilt("dim=\"3\"", "dim=\"4\"") == "f: found no triangulations of 3-manifolds, expected one");
  CHECK(complaint("<svg/>") == "f: found 'svg', expected regina or reginadata, a Regina data file");
  const std::string several = data("rga/several.rga");
  CHECK(error_of([&] { read_document(several); }) ==
        several + ": found 2 triangulations of 3-manifolds ('figure eight', 'open'), expected one: say which "
                  "by FILE#1 or FILE#NAME, or FILE#*");
  CHECK(error_of([&] { write_any(read_any(regina_figure_eight, "f"), FileFormat::regina); }) ==
        "the format regina is read only, expected json, snappea, signature or fmp");
}

// What Regina 7.3 writes (the packets of its sample file, shortened): kinds of packets, one inside of
// another.
TEST_CASE("packets that are no triangulations of 3-manifolds are counted", "[regina]") {
  const Collection third = read_regina_packets(R"(<?xml version="1.0"?>
<regina engine="7.0">
<container label="all">
<textdata label="Read Me">Welcome</textdata>
<tri dim="3" size="1" perm="index" label="S³">
  <simplex> 0 7 0 7 0 1 0 1 </simplex>
  <H1><abeliangroup rank="0"></abeliangroup></H1>
  <tri dim="2" size="0" perm="index" label="Vertex Link"></tri>
  <surfaces tri="x" type="5" algorithm="17" coords="102" label="one"></surfaces>
  <surfaces tri="x" type="5" algorithm="17" coords="0" label="two"></surfaces>
  <textdata label="Note">a note</textdata>
</tri>
<link label="trefoil"></link>
<novelty label="of a later Regina"></novelty>
</container>
</regina>
)",
                                               "f");
  REQUIRE(third.elements.size() == 1);
  CHECK(third.elements[0].name == "S\u00b3");
  // Regina 7.3 names the same gluings so, and the manifold S^3.
  CHECK(signature(third.elements[0].document.triangulation) == "bkaagb");
  CHECK(third.passed_over.entries() == std::vector<Ledger::Entry>{{"text packet", 2},
                                                                  {"triangulation of another dimension", 1},
                                                                  {"list of normal surfaces", 2},
                                                                  {"link", 1},
                                                                  {"novelty packet", 1}});
  const Collection second = read_regina_packets(R"(<?xml version="1.0"?>
<reginadata engine="5.96">
<packet label="all" type="Container" typeid="1" parent="">
<packet label="words" type="Text" typeid="2" parent="all"><text>words</text></packet>
<packet label="S3" type="3-Manifold Triangulation" typeid="3" parent="all">
  <tetrahedra ntet="1"><tet> 0 225 0 225 0 180 0 180 </tet></tetrahedra>
  <packet label="s" type="Normal Surface List" typeid="6" parent="S3"><params/></packet>
</packet>
</packet>
</reginadata>
)",
                                                "f");
  REQUIRE(second.elements.size() == 1);
  CHECK(second.elements[0].document.name == "S3");
  CHECK(second.passed_over.sentence() == "passed over: text packet, list of normal surfaces");
}

TEST_CASE("one bad triangulation does not spoil the others", "[regina]") {
  const std::string tri =
      regina_figure_eight.substr(regina_figure_eight.find("<tri"),
                                 regina_figure_eight.find("</container>") - regina_figure_eight.find("<tri"));
  const std::string bad = with(with(tri, "figure eight", "bad"), "<simplex> 1 11", "<simplex> 1 24");
  const Collection both =
      read_regina_packets(with(regina_figure_eight, "</container>", bad + "</container>"), "f");
  REQUIRE(both.elements.size() == 2);
  CHECK_FALSE(both.elements[0].error);
  CHECK(both.elements[1].name == "bad");
  CHECK(both.elements[1].error.value().place.line == 9);
  CHECK(both.elements[1].error.value().message == "found '24', expected a permutation");
}

TEST_CASE("SnapPea packets are read, of both generations", "[regina]") {
  const std::string text = read_file(data("tri/kernel_whitehead.tri"));
  // The figures are those of snappea_test.cpp's witness: Regina's own reader of the same text.
  const auto read = [&text](const std::string& before, const std::string& after) {
    return read_regina_packets(before + text + after, "f");
  };
  const Collection third = read("<regina engine=\"7.3\">\n<snappeadata label=\"W\">",
                                "<textdata label=\"\">x</textdata></snappeadata></regina>");
  const Collection second =
      read("<reginadata engine=\"5.96\"><packet label=\"W\" type=\"SnapPea Triangulation\" typeid=\"16\">"
           "<snappea>",
           "</snappea></packet></reginadata>");
  for (const Collection& file : {third, second}) {
    REQUIRE(file.elements.size() == 1);
    CHECK_FALSE(file.elements[0].error);
    CHECK(file.elements[0].document.name == "W");
    CHECK(file.elements[0].document.triangulation == read_snappea(text, "f").triangulation);
  }
  CHECK(third.passed_over.sentence() == "passed over: text packet");
  CHECK(error_of([] {
          read_regina("<regina>\n<snappeadata label=\"x\">% Tri</snappeadata></regina>", "f");
        }) == "f:2: SnapPea packet 'x':1: found '% Tri', expected \"% Triangulation\"");
}

TEST_CASE("a file declared to be Latin-1 is read as that", "[regina]") {
  const std::string latin =
      with(with(regina_figure_eight, "version=\"1.0\"", "version=\"1.0\" encoding=\"ISO-8859-1\""),
           "figure eight", "caf\xe9");
  CHECK(read_any(latin, "f").name == "caf\u00e9");
  CHECK(read_any("\xEF\xBB\xBF" + regina_figure_eight, "f").name == "figure eight"); // a byte order mark
}

// rga/two_members.rga was made by gzip from the two halves of a text, one after the other.
TEST_CASE("all members of a gzip file are read", "[regina]") {
  const std::string packed = read_file(data("rga/two_members.rga"));
  CHECK(signature(read_any(packed, "f").triangulation) == "bkaagb"); // Regina 7.3, of the same gluings
  CHECK(read_any(packed + std::string(700, '\0'), "f").passed_over.empty()); // padding, as of tapes
  CHECK(read_any(packed + "more", "f").passed_over.sentence() ==
        "passed over: byte after the compressed data (4)");
  const std::size_t second = packed.find("\x1f\x8b", 2);
  REQUIRE(second != std::string::npos);
  CHECK(complaint(packed.substr(0, second + 12)) == "f: the compressed data end too early");
  CHECK(complaint(packed.substr(0, second)).find("no XML") != std::string::npos);
}

// rga/bomb.rga holds <regina>, fifteen million times <a/>, </regina>: 60 MB, packed by gzip to 58 KB, and
// again.
TEST_CASE("a small file does not fill the memory", "[bad][regina]") {
  CHECK(complaint(read_file(data("rga/bomb.rga"))) == "f: the compressed data hold more than 16777200 bytes");
}

TEST_CASE("other formats may be packed as well", "[read]") {
  // tri/figure_eight.tri.gz is ours_figure_eight.tri, packed by gzip.
  CHECK(read_any(read_file(data("tri/figure_eight.tri.gz")), "f.tri.gz").triangulation ==
        read_document(data("tri/ours_figure_eight.tri")).triangulation);
}

TEST_CASE("a compressed file cut off anywhere, or with any byte spoilt, is an error or a file",
          "[bad][regina]") {
  for (const std::string name : {"figure_eight_3.gz.rga", "figure_eight_3.rga", "open_2.rga"}) {
    const std::string text = read_file(data("rga/" + name));
    for (std::size_t size = 2; size < text.size(); ++size) {
      if (size + 10 < text.size()) CHECK_FALSE(complaint(text.substr(0, size)).empty());
      std::string spoilt = text;
      spoilt[size] = static_cast<char>(spoilt[size] ^ 0x15);
      CHECK(complaint(spoilt).find('\n') == std::string::npos);
    }
  }
  CHECK(complaint("\x1f\x8b\x08") == "f: the compressed data end too early");
}
