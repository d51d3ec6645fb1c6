// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene/scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/mesh_files.hpp"

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::format;

namespace {

/// What Frey's report says of the file, read by formatted input: another route than our own cursors.
struct ReadBack {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 8>> hexahedra;
  std::vector<int> references;
};

ReadBack read_back(const std::string& text) {
  ReadBack out;
  std::istringstream in(text);
  std::string word;
  int number = 0;
  while (in >> word && word != "End") {
    REQUIRE(in >> number); // a version, a dimension, or how many follow
    if (word == "Vertices") {
      out.points.resize(static_cast<std::size_t>(number));
      for (auto& [x, y, z] : out.points) REQUIRE(in >> x >> y >> z >> number);
    } else if (word == "Hexahedra") {
      out.hexahedra.resize(static_cast<std::size_t>(number));
      for (auto& corners : out.hexahedra) {
        for (int& corner : corners) {
          REQUIRE(in >> corner);
          --corner;
        }
        REQUIRE(in >> number);
        out.references.push_back(number);
      }
    } else {
      REQUIRE((word == "MeshVersionFormatted" || word == "Dimension"));
    }
  }
  CHECK(word == "End");
  return out;
}

} // namespace

TEST_CASE("hexahedra in MEDIT's format are read back by another route", "[format]") {
  scene::Cells cells = scene::test::cubes(2);
  for (auto& p : cells.points) p = {p[0] / 3, 1e-300 * p[1], -p[2]};
  const ReadBack plain = read_back(write_medit_hexahedra(cells.points, cells.hexahedra));
  CHECK(plain.points == cells.points);
  CHECK(plain.hexahedra == cells.hexahedra);
  CHECK(plain.references == std::vector<int>(8, 0));
  const std::vector<int> layers{0, 0, 0, 0, 1, 1, 1, -1};
  CHECK(read_back(write_medit_hexahedra(cells.points, cells.hexahedra, layers)).references == layers);
  CHECK(read_back(write_medit_hexahedra({}, {})).points.empty());
}

TEST_CASE("MEDIT's hexahedra are refused where they break the rules", "[format]") {
  scene::Cells cells = scene::test::cubes(1);
  CHECK_THROWS_AS(write_medit_hexahedra(cells.points, cells.hexahedra, {1, 2}), PreconditionError);
  cells.hexahedra[0][7] = 8;
  CHECK_THROWS_AS(write_medit_hexahedra(cells.points, cells.hexahedra), PreconditionError);
  cells.hexahedra[0][7] = -1;
  CHECK_THROWS_AS(write_medit_hexahedra(cells.points, cells.hexahedra), PreconditionError);
}
