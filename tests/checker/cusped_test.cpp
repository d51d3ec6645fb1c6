// SPDX-License-Identifier: GPL-2.0-or-later

/// Cusped manifolds of up to seven tetrahedra, orientable and not: what SnapPea's kernel computes is proved.

#include "../verified/certified.hpp"

#include "tetrarch/checker/check.hpp"

#include <catch2/catch.hpp>
#include <fstream>

using namespace tetrarch;

TEST_CASE("certified volumes of cusped manifolds hold those of SnapPea's kernel", "[checker]") {
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/snappea_volumes.txt");
  int count = 0;
  int non_orientable = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    CAPTURE(line);
    const std::size_t bar = line.find('|');
    const support::Certified c(line.substr(0, bar));
    REQUIRE(c.result.proof);
    const auto [low, high] = verified::volume_interval(*c.result.proof);
    const double kernel = std::stod(line.substr(bar + 1));
    CHECK(std::stod(low) == Approx(kernel).epsilon(0).margin(1e-12)); // doubles on either side
    CHECK(std::stod(high) == Approx(kernel).epsilon(0).margin(1e-12));
    CHECK(checker::check(c.text(), line).why_not.empty());
    ++count;
    non_orientable += c.skeleton.is_orientable() ? 0 : 1;
  }
  CHECK(count == 302);
  CHECK(non_orientable == 92);
}
