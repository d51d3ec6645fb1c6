// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/boundary_loops.hpp"

#include "support/surface_soups.hpp"
#include "tetrarch/doctor/build.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::doctor;
using namespace tetrarch::support::soups;

namespace {

/// A square of n x n unit squares in the plane z = 0, without those (i,j) for which `hole(i, j)` holds.
template <class Hole>
support::TriangleList square(int n, Hole hole) {
  support::TriangleList list;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) list.points.push_back({1.0 * i, 1.0 * j, 0});
  list.vertices = (n + 1) * (n + 1);
  const auto vertex = [&](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (hole(i, j)) continue;
      list.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      list.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return list;
}

TriangleMesh mesh_of(const support::TriangleList& list) {
  return build_surface(surface_soup(list));
}

} // namespace

// All figures by hand.

TEST_CASE("loops of a square with holes, the longest first", "[boundary_loops]") {
  // Holes of one, two and one squares in a square of seven.
  const auto hole = [](int i, int j) {
    return (i == 1 && j == 1) || (i == 3 && (j == 3 || j == 4)) || (i == 5 && j == 1);
  };
  support::TriangleList list = square(7, hole);
  list = support::with_holes(list, 0); // every vertex is used
  const TriangleMesh mesh = mesh_of(list);
  const auto loops = boundary_loops(mesh);
  REQUIRE(loops.size() == 4);
  const std::vector<std::array<double, 3>> wanted{{28, 28, 49}, {6, 6, 2}, {4, 4, 1}, {4, 4, 1}};
  for (std::size_t k = 0; k < loops.size(); ++k) {
    CHECK(static_cast<double>(loops[k].sides.size()) == wanted[k][0]);
    CHECK(loops[k].length == Approx(wanted[k][1]).epsilon(1e-14));
    CHECK(loops[k].area == Approx(wanted[k][2]).epsilon(1e-14));
    for (const SideEnd e : loops[k].sides)
      CHECK(loop_through(loops, mesh.surface, mesh.surface.vertex(e)) == static_cast<int>(k));
  }
  // The two short ones are equally long; the one with the least vertex is first.
  const auto least = [&](const BoundaryLoop& loop) {
    int v = mesh.surface.vertex_count();
    for (const SideEnd e : loop.sides) v = std::min(v, mesh.surface.vertex(e));
    return v;
  };
  CHECK(least(loops[2]) < least(loops[3]));
  int inside = 0;
  for (int v = 0; v < mesh.surface.vertex_count(); ++v) inside += loop_through(loops, mesh.surface, v) < 0;
  CHECK(inside == 64 - 28 - 6 - 4 - 4);
}

TEST_CASE("the sides of a loop follow each other", "[boundary_loops]") {
  for (const auto& list : {support::with_holes(support::torus_grid(9, 9), 3),
                           support::with_holes(support::projective_plane(), 1)}) {
    const TriangleMesh mesh = mesh_of(list);
    for (const BoundaryLoop& loop : boundary_loops(mesh))
      for (std::size_t k = 0; k < loop.sides.size(); ++k) {
        const SideEnd e = loop.sides[k];
        CHECK(mesh.surface.is_boundary(e.side));
        CHECK(mesh.surface.vertex({e.side, !e.at_start}) ==
              mesh.surface.vertex(loop.sides[(k + 1) % loop.sides.size()]));
      }
  }
}

TEST_CASE("a closed surface has no loops", "[boundary_loops]") {
  const TriangleMesh mesh = mesh_of(support::torus_grid(4, 4));
  CHECK(boundary_loops(mesh).empty());
  CHECK(loop_through({}, mesh.surface, 0) == -1);
}

TEST_CASE("a loop far away encloses the same area, to the digits of its points", "[boundary_loops]") {
  support::TriangleList list = square(2, [](int, int) { return false; });
  for (auto& p : list.points) p = {p[0] + 1e9, p[1] - 1e9, p[2] + 5e8};
  const auto loops = boundary_loops(mesh_of(list));
  CHECK(loops.at(0).area == 4);
  CHECK(loops.at(0).length == 8);
}

TEST_CASE("loops do not depend on names", "[boundary_loops]") {
  support::Random random(12);
  const support::TriangleList list = support::with_holes(support::torus_grid(10, 9), 4);
  const auto before = boundary_loops(mesh_of(list));
  REQUIRE(before.size() == 4);
  for (int round = 0; round < 10; ++round) {
    const auto after = boundary_loops(mesh_of(support::relabelled(list, random)));
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(after[k].length == before[k].length); // summed in order of size
      CHECK(after[k].sides.size() == before[k].sides.size());
    }
  }
}
