// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/build.hpp"

#include "support/surface_soups.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::surface;
using namespace tetrarch::support::soups;
using support::error_of;

namespace {

std::string complaint(const Triangles& triangles, int points) {
  return error_of([&] { build_surface(surface_soup(curve(points), triangles)); });
}

int turned_edges(const Surface& surface) {
  int sides = 0;
  for (int k = 0; k < surface.side_count(); ++k) sides += surface.is_turned(Side(k));
  return sides / 2;
}

bool has_same_corners(Triangles a, Triangles b) {
  for (Triangle& t : a) std::sort(t.begin(), t.end());
  for (Triangle& t : b) std::sort(t.begin(), t.end());
  return a == b;
}

} // namespace

TEST_CASE("a good soup becomes the surface of its triangles", "[triangle_mesh]") {
  support::Random random(9);
  for (const auto& list : {support::cube_surface(), support::torus_grid(6, 5), support::icosphere(2),
                           support::with_holes(support::torus_grid(9, 9), 3)}) {
    const support::TriangleList other = support::relabelled(list, random);
    const TriangleMesh mesh = build_surface(surface_soup(other));
    CHECK(mesh.points == other.points);
    CHECK(mesh.surface.triangles() == other.triangles);
    CHECK(turned_edges(mesh.surface) == 0);
    CHECK(type_of(mesh.surface) == type_of(list.surface()));
  }
}

// All messages by hand.

TEST_CASE("the first finding that keeps a soup from being a surface is named", "[triangle_mesh]") {
  CHECK(complaint({}, 0) == "f: the surface has no triangles");
  CHECK(complaint({{0, 1, 2}, {0, 1, 4}, {0, 1, 5}}, 3) ==
        "f:11: triangle 2 names vertex 5, which is none of the 3 there are (and 1 more)");
  CHECK(complaint({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 5) ==
        "f:14: the edge on vertices 1, 2 is shared by 3 triangles, among them 1, 2, 3");
  CHECK(complaint({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}, 9) ==
        "f:17: the surface falls apart into 3 components: triangle 2 is not connected with triangle 1");
}

TEST_CASE("what can be mended is named after what cannot, with the way to mend it", "[triangle_mesh]") {
  CHECK(
      complaint({{0, 1, 2}, {0, 1, 3}}, 4) ==
      "f:12: triangle 2 is turned against its neighbor 1 at the edge on vertices 1, 2; --repair mends this");
  CHECK(complaint({{0, 1, 2}, {1, 2, 0}, {0, 0, 1}}, 4) ==
        "f:13: triangle 3 names vertex 1 twice (and 2 more); --repair mends this");
  CHECK(complaint({{0, 1, 2}}, 4) == "f:8: vertex 4 is in no triangle; --repair mends this");
  CHECK(complaint({{0, 1, 1}, {0, 1, 2}, {3, 4, 5}}, 6) ==
        "f:15: the surface falls apart into 2 components: triangle 3 is not connected with triangle 2");
}

TEST_CASE("a surface that is not orientable is no fault, and few of its mates are turned",
          "[triangle_mesh]") {
  support::Random random(10);
  // The dual graph of the strip is one circle, so all but one of its edges can be crossed unturned.
  for (int round = 0; round < 10; ++round) {
    Triangles strip = moebius_strip(7 + 2 * round);
    for (Triangle& t : strip)
      if (random.below(2) == 0) t = turned(t);
    const int n = static_cast<int>(strip.size());
    const TriangleMesh mesh = build_surface(surface_soup(curve(n), strip));
    CHECK(has_same_corners(mesh.surface.triangles(), strip));
    CHECK(turned_edges(mesh.surface) == 1);
    CHECK(type_of(mesh.surface).str() == "projective plane, 1 hole");
  }
  // However the triangles of a Klein bottle of m x n squares are turned, some circle of about n edges is
  // left.
  support::TriangleList klein = support::klein_grid(20, 6);
  const TriangleMesh before = build_surface(surface_soup(klein));
  CHECK(turned_edges(before.surface) <= 6);
  for (Triangle& t : klein.triangles)
    if (random.below(2) == 0) t = turned(t);
  const TriangleMesh after = build_surface(surface_soup(klein));
  CHECK(turned_edges(after.surface) <= 2 * 6);
  CHECK(type_of(after.surface) == type_of(before.surface));
}
