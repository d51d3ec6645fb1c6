// SPDX-License-Identifier: GPL-2.0-or-later
/// Disks are built from corners or gluings, and what is no disk is refused by name.
#include "tetrarch/bundle/disk.hpp"

#include "bundle/disks.hpp"
#include "support/errors.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

using Triangles = std::vector<Disk::Triangle>;

std::string refusal(int vertices, const Triangles& triangles) {
  return error_of([&] { const Disk disk(vertices, triangles); });
}

} // namespace

TEST_CASE("A disk knows its mates and its boundary in order", "[bundle]") {
  // By hand: the square 0 1 2 3, cut along 0-2.
  const Disk square(4, {{0, 1, 2}, {0, 2, 3}});
  CHECK(square.edge_count() == 5);
  CHECK(square.mate(Side(0, 1)) == Side(1, 2));
  CHECK(square.boundary() == std::vector<Side>{Side(0, 0), Side(1, 0), Side(1, 1), Side(0, 2)});
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(square.to(square.boundary()[k]) == square.from(square.boundary()[(k + 1) % 4]));
}

TEST_CASE("The gluing of a disk gives the disk back", "[bundle]") {
  Random random(1);
  const Disk disk = random_disk({5, 4, 10, 10, true}, random);
  Table<Side, Side> mate(3 * disk.triangle_count());
  for (int k = 0; k < mate.size(); ++k) mate[Side(k)] = disk.mate(Side(k));
  const Disk again(mate);
  CHECK(again.boundary() == disk.boundary());
  CHECK(again.vertex_count() == disk.vertex_count());
  std::map<int, int> renamed;
  for (int t = 0; t < disk.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      CHECK(renamed.emplace(disk.corners(t)[c], again.corners(t)[c]).first->second == again.corners(t)[c]);
}

TEST_CASE("What is no disk is refused by name", "[bundle]") {
  CHECK(refusal(0, {}) == "a disk needs a triangle");
  CHECK(refusal(3, {{0, 1, 3}}) == "triangle 0 names vertex 3, but there are 3");
  CHECK(refusal(3, {{0, 1, 1}}) == "triangle 0 has a vertex twice");
  CHECK(refusal(4, {{0, 1, 2}}) == "vertex 3 is in no triangle");
  CHECK(refusal(4, {{0, 1, 2}, {1, 2, 3}}) ==
        "triangles 0 and 1, edge 1-2: both run along it in the same direction");
  CHECK(refusal(5, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}) ==
        "triangles 0 and 2, edge 0-1: more than two triangles share it");
  CHECK(refusal(6, {{0, 1, 2}, {3, 4, 5}}) == "no disk: the triangles are not connected through edges");
  CHECK(refusal(5, {{0, 1, 2}, {2, 3, 4}}) == "no disk: the triangles are not connected through edges");
  // The boundary of a tetrahedron; an annulus of six triangles; a disk of five pinched at vertex 0.
  CHECK(refusal(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) == "no disk: the surface has no boundary");
  CHECK(refusal(6, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}) ==
        "no disk: vertices - edges + triangles = 0, not 1");
  CHECK(refusal(6, {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {3, 5, 4}, {5, 0, 4}}) ==
        "no disk: vertices - edges + triangles = 0, not 1");
}

TEST_CASE("Mates that are not mutual are the caller's mistake", "[bundle]") {
  Table<Side, Side> mate(3);
  mate[Side(0)] = Side(0);
  CHECK_THROWS_AS(Disk(mate), PreconditionError);
  mate[Side(0)] = Side(1);
  CHECK_THROWS_AS(Disk(mate), PreconditionError);
  CHECK_THROWS_AS(Disk(Table<Side, Side>(4)), PreconditionError);
}
