// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/surface/lay_path.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/canonical_loops.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

/// A polygon fanned from corner 0, its triangles in random order and started anywhere.
MarkedSurface polygon(int sides, Random& random) {
  TriangleList fan{{}, {}, sides};
  for (int k = 1; k + 1 < sides; ++k) fan.triangles.push_back({0, k, k + 1});
  random.shuffle(fan.triangles);
  for (auto& t : fan.triangles) std::rotate(t.begin(), t.begin() + random.below(3), t.end());
  return fan.marked();
}

SplitCount lay(MarkedSurface& surface, int from, int to) {
  const auto at = [&](int vertex) {
    return [&surface, vertex](const Surface& open) {
      std::vector<SideEnd> ends;
      for (const Corner& c : corners(surface, open))
        if (surface.surface.vertex(c.end) == vertex) ends.push_back(c.end);
      return ends;
    };
  };
  return lay_path(surface, 1, at(from), at(to));
}

TEST_CASE("A path splits the chords that it has to cross, each once") {
  // By hand: corners 1 and k of a fanned polygon are apart by the chords from 0 to 2, ..., k-1.
  Random random(2);
  for (int k = 0; k < 40; ++k) {
    const int corner = 3 + k % 4;
    MarkedSurface disk = polygon(7, random);
    const SplitCount count = k % 8 < 4 ? lay(disk, 1, corner) : lay(disk, corner, 1);
    CHECK(count.edges == corner - 2);
    CHECK(count.faces == 0);
    CHECK(length_of(disk, 1) == corner - 1);
    CHECK(parts(cut_open(disk)).count == 2);
  }
}

TEST_CASE("A path never runs along the boundary") {
  Random random(3);
  MarkedSurface disk = polygon(6, random);
  CHECK(lay(disk, 1, 2).edges == 1);
  CHECK(length_of(disk, 1) == 2);
  MarkedSurface triangle = polygon(3, random);
  CHECK(lay(triangle, 0, 1).faces == 1);
  CHECK(length_of(triangle, 1) == 2);
  CHECK(parts(cut_open(triangle)).count == 2);
}

TEST_CASE("An edge inside is a path by itself") {
  Random random(3);
  MarkedSurface disk = polygon(6, random);
  CHECK(lay(disk, 0, 3).edges == 0);
  CHECK(length_of(disk, 1) == 1);
}

TEST_CASE("No path leads from one part to another") {
  Random random(3);
  MarkedSurface disk = polygon(6, random);
  lay(disk, 0, 3);
  CHECK_THROWS_AS(lay(disk, 2, 4), PreconditionError);
}

} // namespace
