// SPDX-License-Identifier: GPL-2.0-or-later

/// Regina's homology and numbers of covers (tests/oracle/regina_homology.txt) against ours.

#include "naive_algebra.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/signature.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::algebra;

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '|');) fields.push_back(field);
  return fields;
}

/// Connected covers of 2, 3 and 4 sheets, as the file writes them.
std::string covers(const Presentation& group) {
  std::string text;
  for (int sheets = 2; sheets <= 4; ++sheets) {
    if (sheets > 2) text += ' ';
    text += std::to_string(naive::representations(group, sheets).transitive_classes);
  }
  return text;
}

} // namespace

TEST_CASE("Regina finds the same homology and the same covers", "[homology][group][oracle]") {
  std::ifstream in(std::string(TETRARCH_SOURCE_DIR) + "/tests/oracle/regina_homology.txt");
  REQUIRE(in);
  int lines = 0;
  int covered = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    const std::vector<std::string> field = split(line);
    REQUIRE(field.size() == 5);
    INFO(line);
    const Triangulation tri = from_signature(field[0]);
    const Skeleton s(tri);
    CHECK(homology(tri, s, 1).str() == field[1]);
    CHECK(relative_homology(tri, s, 1).str() == field[2]);
    CHECK(homology(tri, s, 2).str() == field[3]);
    ++lines;
    if (field[4] == "-") continue;
    const Presentation group = simplified(dual_presentation(tri, s).presentation);
    CHECK(group.generators <= 4);
    CHECK(covers(group) == field[4]);
    ++covered;
  }
  CHECK(lines == 676); // the file was not cut short
  CHECK(covered > 500);
}
