// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/open_handles.hpp"

#include "opened_meshes.hpp"
#include "support/errors.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::doctor;
using namespace tetrarch::surface::test;
using namespace tetrarch::support::soups;
using Catch::Matchers::Contains;
using support::error_of;

namespace {

/// A sphere with two holes for each handle and the old ones; every vertex on a loop twice, all others once;
/// the loops, which occur twice among the boundary loops, as long as told.
void check_opened(const OpenedMesh& before, const OpenedHandles& after) {
  const SurfaceType old = type_of(before.mesh.surface);
  const TriangleMesh& mesh = after.opened.mesh;
  CHECK(type_of(mesh.surface) ==
        SurfaceType{2 - 2 * old.genus() - old.boundary_curves, 2 * old.genus() + old.boundary_curves, true});
  CHECK(is_valid(mesh));
  CHECK(static_cast<int>(after.loops.size()) == old.genus());
  // Each split of an edge inside adds a vertex and two triangles.
  CHECK(mesh.surface.triangle_count() == before.mesh.surface.triangle_count() + 2 * after.edge_splits);
  const std::set<int> triangles(after.opened.triangle_of.begin(), after.opened.triangle_of.end());
  CHECK(static_cast<int>(triangles.size()) == before.mesh.surface.triangle_count());
  int doubled = 0;
  for (const HandleLoop& loop : after.loops) doubled += loop.edges;
  CHECK(mesh.surface.vertex_count() == before.mesh.surface.vertex_count() + after.edge_splits + doubled);
  CHECK(std::equal(before.number.begin(), before.number.end(), after.opened.number.begin()));
  std::multiset<double> wanted;
  for (const HandleLoop& loop : after.loops)
    for (int bank = 0; bank < 2; ++bank) wanted.insert(loop.length);
  for (const BoundaryLoop& loop : boundary_loops(before.mesh)) wanted.insert(loop.length);
  std::multiset<double> found;
  for (const BoundaryLoop& loop : boundary_loops(mesh)) found.insert(loop.length);
  REQUIRE(found.size() == wanted.size());
  CHECK(std::equal(found.begin(), found.end(), wanted.begin(),
                   [](double a, double b) { return a == Approx(b).epsilon(1e-12); }));
}

} // namespace

TEST_CASE("Every surface with handles becomes a sphere with holes", "[open_handles]") {
  support::Random random(5);
  for (int genus = 1; genus <= 6; ++genus)
    for (int round = 0; round < 12; ++round) {
      const auto list = support::relabelled(
          support::retriangulated(support::genus_surface(genus, 3 + round % 2, 3 + round / 6), random,
                                  100 * (round % 3), 3 * (round % 4)),
          random);
      INFO("genus " << genus << ", round " << round);
      const OpenedMesh whole = opened(list);
      check_opened(whole, open_handles(whole));
    }
}

TEST_CASE("Old holes stay, and loops keep off them", "[open_handles]") {
  support::Random random(6);
  for (int genus = 1; genus <= 4; ++genus)
    for (int holes = 1; holes <= 3; ++holes) {
      const auto list = support::with_holes(
          support::retriangulated(support::genus_surface(genus, 5, 5), random, 60, 40), holes);
      INFO("genus " << genus << ", " << holes << " holes");
      const OpenedMesh whole = opened(list);
      check_opened(whole, open_handles(whole));
    }
}

TEST_CASE("Where all vertices are taken, edges are split", "[open_handles]") {
  // The torus of seven vertices, all neighbours of each other, less a triangle: four vertices are off the
  // boundary. Translates of two triangles (Moebius, 1861).
  support::TriangleList torus;
  torus.vertices = 7;
  for (int k = 0; k < 7; ++k) {
    torus.triangles.push_back({k, (k + 1) % 7, (k + 3) % 7});
    torus.triangles.push_back({k, (k + 3) % 7, (k + 2) % 7});
  }
  const OpenedMesh closed = opened(torus);
  REQUIRE(type_of(closed.mesh.surface).str() == "torus");
  const OpenedHandles cut = open_handles(closed);
  check_opened(closed, cut);
  CHECK(cut.edge_splits == 0);
  CHECK(cut.loops.at(0).edges == 3);
  // Without the triangles 0 1 3 and 2 5 4, which have no vertex in common, only vertex 6 is free.
  support::TriangleList punctured = torus;
  std::erase_if(punctured.triangles, [](Surface::Triangle t) {
    std::sort(t.begin(), t.end());
    return t == Surface::Triangle{0, 1, 3} || t == Surface::Triangle{2, 4, 5};
  });
  REQUIRE(punctured.triangles.size() == 12);
  const OpenedMesh holes = opened(punctured);
  REQUIRE(type_of(holes.mesh.surface).str() == "torus, 2 holes");
  const OpenedHandles split = open_handles(holes);
  check_opened(holes, split);
  // By hand: of 21 edges, 6 go to vertex 6 and 6 are boundary.
  CHECK(split.edge_splits == 9);
  CHECK(std::count(split.opened.number.begin(), split.opened.number.end(), -1) >= 9);
}

TEST_CASE("The loop of a ring goes around its tube", "[open_handles]") {
  // A ring of radii 2 and 1, finer along its axis: meridians are regular polygons of 20 sides; all others,
  // and the inner equator of 60 sides, are longer.
  const OpenedMesh ring = opened(support::torus_grid(60, 20));
  const OpenedHandles cut = open_handles(ring);
  check_opened(ring, cut);
  CHECK(cut.loops.at(0).edges == 20);
  CHECK(cut.loops.at(0).length == Approx(40 * std::sin(std::numbers::pi / 20)).epsilon(1e-12));
}

TEST_CASE("Loops of high genus do not grow", "[open_handles]") {
  // Tori of 3 x 3 squares in a chain: handles have loops of three edges; some are taken, and detours are
  // short.
  const OpenedMesh chain = opened(support::genus_surface(20, 3, 3));
  const OpenedHandles cut = open_handles(chain);
  check_opened(chain, cut);
  for (const HandleLoop& loop : cut.loops) CHECK(loop.edges <= 12);
}

TEST_CASE("Spheres have no handles, and one-sided surfaces none that open", "[open_handles]") {
  for (const auto& list : {support::cube_surface(), support::with_holes(support::icosphere(2), 3)}) {
    const OpenedMesh whole = opened(list);
    const OpenedHandles cut = open_handles(whole);
    check_opened(whole, cut);
    CHECK(cut.opened.mesh.surface.triangles() == whole.mesh.surface.triangles());
  }
  for (const auto& list : {support::projective_plane(), support::klein_grid(5, 5)})
    CHECK_THAT(error_of([&] { static_cast<void>(open_handles(opened(list))); }), Contains("not orientable"));
}

TEST_CASE("Numbers of the caller are kept", "[open_handles]") {
  const support::TriangleList list = support::torus_grid(4, 4);
  std::vector<long long> numbers;
  for (int v = 0; v < list.vertices; ++v) numbers.push_back(100 + 2 * v);
  const OpenedMesh whole(build_surface(surface_soup(list)), numbers);
  const OpenedHandles cut = open_handles(whole);
  for (const long long number : numbers) {
    const auto count = std::count(cut.opened.number.begin(), cut.opened.number.end(), number);
    CHECK((count == 1 || count == 2));
  }
  CHECK(vertex_numbered(cut.opened, 104) == 2);
  CHECK_THAT(error_of([&] { static_cast<void>(vertex_numbered(cut.opened, 3)); }), Contains("no vertex 3"));
  CHECK_THROWS_AS(OpenedMesh(whole.mesh, {1, 2}), PreconditionError);
}
