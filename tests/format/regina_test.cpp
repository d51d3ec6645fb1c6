// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/regina.hpp"

#include "expect.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

std::string complaint(const std::string& text) {
  return error_of([&] { read_any(text, "f"); });
}

const std::string figure_eight = R"(<?xml version="1.0"?>
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
  CHECK(read_any(figure_eight, "f").triangulation ==
        read_document(data("rga/figure_eight_2.rga")).triangulation);
}

TEST_CASE("wrong Regina files", "[bad][regina]") {
  const auto spoilt = [](const std::string& from, const std::string& to) {
    return complaint(with(figure_eight, from, to));
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
        several + ": found 2 triangulations of 3-manifolds ('figure eight', 'open'), expected one");
  CHECK(error_of([&] { write_any(read_any(figure_eight, "f"), FileFormat::regina); }) ==
        "the format regina is read only, expected json, snappea, signature or fmp");
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
