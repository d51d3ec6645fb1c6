// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/equator.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/canonical_loops.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

/// Marks an equator and finds out from the marks alone whether all that is promised of it is so.
Equator checked_equator(MarkedSurface& sphere, int edges) {
  const Equator equator = mark_equator(sphere, edges);
  CHECK(equator.edges >= edges);
  CHECK(length_of(sphere, 1) == equator.edges);
  CHECK(static_cast<int>(sphere.splits.size()) == equator.edge_splits + equator.face_splits);
  // Two parts with one boundary curve each and characteristic 2 in all are two disks.
  const Surface open = cut_open(sphere);
  const Parts disks = parts(open);
  CHECK(disks.count == 2);
  CHECK(open.vertex_count() - open.edge_count() + open.triangle_count() == 2);
  const auto curves = boundary_curves(open);
  REQUIRE(curves.size() == 2);
  std::vector<char> on_boundary(static_cast<std::size_t>(open.vertex_count()), 0);
  for (const auto& curve : curves) {
    CHECK(static_cast<int>(curve.size()) == equator.edges);
    for (const SideEnd e : curve) on_boundary[open.vertex(e)] = 1;
  }
  std::array<bool, 2> has_interior{};
  for (int t = 0; t < open.triangle_count(); ++t)
    for (const int v : open.corners(t))
      if (!on_boundary[v]) has_interior[disks.of[t]] = true;
  CHECK((has_interior[0] && has_interior[1]));
  for (const int disk : {0, 1})
    CHECK(std::count(disks.of.begin(), disks.of.end(), disk) == equator.triangles[disk]);
  for (int k = 0; k < open.side_count(); ++k) {
    const int mark = sphere[Side(k)];
    CHECK((mark == 0 || mark == (disks.of[k / 3] == 0 ? 1 : -1)));
  }
  return equator;
}

TEST_CASE("An equator of four edges halves a tetrahedron and a cube") {
  // By hand: two triangles on either side of the tetrahedron's, neither with an inner vertex; the cube's
  // leaves 8 - 4 vertices, and six triangles with a rim of four edges have two of them.
  MarkedSurface tetrahedron = tetrahedron_surface().marked();
  const Equator four = checked_equator(tetrahedron, 4);
  CHECK(four.edges == 4);
  CHECK(four.edge_splits == 0);
  CHECK(four.face_splits == 2);
  MarkedSurface cube = cube_surface().marked();
  const Equator six = checked_equator(cube, 4);
  CHECK(six.edges == 4);
  CHECK(six.edge_splits + six.face_splits == 0);
  CHECK(six.triangles == std::array{6, 6});
}

TEST_CASE("An equator has as many edges as wanted, or as few as there are") {
  for (const int edges : {1, 2, 3, 4, 8, 20, 64}) {
    INFO(edges << " edges");
    for (const TriangleList& mesh : {tetrahedron_surface(), cube_surface(), icosphere(2)}) {
      MarkedSurface sphere = mesh.marked();
      // On a simplicial sphere no curve has less than three edges, and every triangle has one of three.
      CHECK(checked_equator(sphere, edges).edges == std::max(edges, 3));
    }
  }
}

TEST_CASE("An equator of a round sphere is about as short as a great circle, and splits it evenly") {
  // The octahedron's squares, three times bisected, have 4 * 2^3 edges.
  MarkedSurface sphere = icosphere(3).marked();
  const Equator equator = checked_equator(sphere, 32);
  CHECK(equator.edges == 32);
  CHECK(equator.edge_splits <= 4);
  // 512 triangles, and two more for each split.
  CHECK(std::min(equator.triangles[0], equator.triangles[1]) >= 230);
}

TEST_CASE("With more edges to spend an equator is no less even") {
  int before = 0;
  for (const int edges : {3, 6, 12, 18, 24, 32, 48}) {
    MarkedSurface sphere = icosphere(3).marked();
    const Equator equator = checked_equator(sphere, edges);
    const int lesser = std::min(equator.triangles[0], equator.triangles[1]);
    // Nine tenths, by which a shorter one may be less even.
    CHECK(lesser >= 0.9 * before);
    before = lesser;
  }
}

TEST_CASE("Random spheres have equators, with and without points") {
  Random random(21);
  for (int k = 0; k < 50; ++k) {
    INFO("sphere " << k);
    TriangleList mesh = retriangulated(tetrahedron_surface(), random, random.below(600), random.below(120));
    mesh = relabelled(mesh, random);
    if (k % 2 == 0) mesh.points.clear();
    MarkedSurface sphere = mesh.marked();
    checked_equator(sphere, 3 + random.below(30));
  }
}

TEST_CASE("Two triangles glued along all sides have an equator") {
  Table<Side, Side> mate(6);
  for (int k = 0; k < 6; ++k) mate[Side(k)] = Side(5 - k);
  MarkedSurface pillow{Surface(mate)};
  // Its three edges; both disks are a triangle without inner vertex.
  const Equator equator = checked_equator(pillow, 3);
  CHECK(equator.edges == 3);
  CHECK(equator.face_splits == 2);
}

TEST_CASE("An equator asks for a sphere without marks") {
  const auto refuses = [](MarkedSurface surface, int seeds = 8) {
    CHECK_THROWS_AS(mark_equator(surface, 4, seeds), PreconditionError);
  };
  refuses(torus_grid(4, 4).marked());
  refuses(projective_plane().marked());
  refuses(with_holes(icosphere(2), 1).marked());
  refuses(cube_surface().marked(), 0);
  MarkedSurface marked = cube_surface().marked();
  set_mark(marked, Side(0), 1);
  refuses(marked);
}

} // namespace
