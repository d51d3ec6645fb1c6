// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/slice.hpp"

#include "opened_meshes.hpp"
#include "support/errors.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::surface::test;
using Catch::Matchers::Contains;
using support::error_of;

namespace {

using Paths = std::vector<std::vector<long long>>;

/// Corner by corner the same triangles; the first copies in their places, second copies after them.
void check_kept(const OpenedMesh& before, const OpenedMesh& after) {
  REQUIRE(after.mesh.surface.triangle_count() == before.mesh.surface.triangle_count());
  CHECK(after.triangle_of == before.triangle_of);
  for (int t = 0; t < after.mesh.surface.triangle_count(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const int copy = after.mesh.surface.corners(t)[c];
      const int old = before.mesh.surface.corners(t)[c];
      CHECK(after.number[copy] == before.number[old]);
      CHECK(after.mesh.points[copy] == before.mesh.points[old]);
    }
  CHECK(std::equal(before.number.begin(), before.number.end(), after.number.begin()));
}

int copies(const OpenedMesh& mesh, long long number) {
  return static_cast<int>(std::count(mesh.number.begin(), mesh.number.end(), number));
}

} // namespace

TEST_CASE("A path becomes a loop of twice its length, its inner vertices two", "[slice]") {
  const OpenedMesh whole = plane();
  const OpenedMesh open = slice(whole, {{at(2, 3), at(3, 3), at(3, 4)}, {at(7, 2), at(7, 6)}});
  check_kept(whole, open);
  CHECK(type_of(open.mesh.surface).str() == "sphere, 3 holes");
  // By hand: one vertex more for the corner of the first path, three inside the second, which is straight.
  CHECK(open.number.size() == 121 + 4);
  for (const long long v : {at(3, 3), at(7, 3), at(7, 4), at(7, 5)}) CHECK(copies(open, v) == 2);
  for (const long long v : {at(2, 3), at(3, 4), at(7, 2), at(7, 6)}) CHECK(copies(open, v) == 1);
  const auto loops = boundary_loops(open.mesh);
  CHECK(loops.at(0).length == 40);
  CHECK(loops.at(1).length == 8);
  CHECK(loops.at(2).length == 4);
  CHECK(loops.at(1).area == Approx(0).margin(1e-14));
}

TEST_CASE("Ways between vertices keep off the paths", "[slice]") {
  const OpenedMesh whole = plane();
  // A wall across the straight way from (5, 2) to (5, 8), which then goes around it.
  const OpenedMesh open = slice(whole, {{at(3, 5), at(7, 5)}, {at(5, 2), at(5, 8)}});
  check_kept(whole, open);
  CHECK(type_of(open.mesh.surface).str() == "sphere, 3 holes");
  CHECK(boundary_loops(open.mesh).at(1).length > 12);
  // The same in two steps, the wall being boundary then.
  const OpenedMesh twice = slice(slice(whole, {{at(3, 5), at(7, 5)}}), {{at(5, 2), at(5, 8)}});
  CHECK(type_of(twice.mesh.surface) == type_of(open.mesh.surface));
  CHECK(boundary_loops(twice.mesh).at(1).length == boundary_loops(open.mesh).at(1).length);
}

TEST_CASE("A closed path around a handle opens it, one around a crosscap too", "[slice]") {
  const OpenedMesh torus = opened(support::torus_grid(6, 5));
  const OpenedMesh open = slice(torus, {{0, 10, 20, 0}}); // once along the six squares
  check_kept(torus, open);
  CHECK(type_of(open.mesh.surface).str() == "sphere, 2 holes");
  CHECK(open.number.size() == 30 + 6);
  // Any two of the six vertices are neighbours; cut along a one-sided triangle, a disk is left: 6 sides.
  const OpenedMesh projective = opened(support::projective_plane());
  int disks = 0;
  for (long long a = 0; a < 6; ++a)
    for (long long b = a + 1; b < 6; ++b)
      for (long long c = b + 1; c < 6; ++c) {
        OpenedMesh cut;
        const std::string error = error_of([&] { cut = slice(projective, {{a, b, c, a}}); });
        // Of the 20 triples 10 are triangles, which are cut off; the others go around the crosscap.
        if (!error.empty()) {
          CHECK_THAT(error, Contains("in two"));
          continue;
        }
        ++disks;
        CHECK(type_of(cut.mesh.surface).is_disk());
        CHECK(cut.number.size() == 9);
      }
  CHECK(disks == 10);
}

TEST_CASE("Random paths on random surfaces become holes", "[slice]") {
  support::Random random(8);
  int done = 0;
  for (int round = 0; round < 60; ++round) {
    const auto list = support::relabelled(
        support::retriangulated(support::torus_grid(12, 10), random, 100 * (round % 4), 30), random);
    const OpenedMesh whole = opened(list);
    Paths paths(static_cast<std::size_t>(1 + round % 4));
    for (auto& path : paths)
      for (int k = 0; k < 2 + round % 3; ++k) path.push_back(random.below(list.vertices));
    OpenedMesh open;
    if (!error_of([&] { open = slice(whole, paths); }).empty()) continue;
    ++done;
    check_kept(whole, open);
    CHECK(is_valid(open.mesh));
    CHECK(type_of(open.mesh.surface).genus() == 1);
    CHECK(type_of(open.mesh.surface).boundary_curves == static_cast<int>(paths.size()));
    for (const auto& path : paths)
      for (const long long v : path)
        CHECK(copies(open, v) == (v == path.front() || v == path.back() ? 1 : 2));
  }
  CHECK(done > 20);
}

TEST_CASE("Paths that cannot be are refused by name", "[slice]") {
  const OpenedMesh whole = plane();
  const auto error = [&](const Paths& paths) {
    return error_of([&] { static_cast<void>(slice(whole, paths)); });
  };
  CHECK_THAT(error({{at(5, 5), 121}}), Contains("no vertex 121"));
  CHECK_THAT(error({{at(5, 5), at(5, 10)}}), Contains("boundary at vertex 65"));
  CHECK_THAT(error({{at(5, 5), at(5, 6)}}), Contains("vertex 60 has fewer than two edges"));
  CHECK_THAT(error({{at(5, 5)}}), Contains("fewer than two edges"));
  CHECK_THAT(error({{}}), Contains("no vertices"));
  CHECK_THAT(error({{at(5, 5), at(5, 7), at(5, 5)}}), Contains("fewer than three"));
  CHECK_THAT(error({{at(5, 5), at(5, 7), at(7, 7), at(5, 7)}}), Contains("vertex 62") && Contains("twice"));
  CHECK_THAT(error({{at(5, 5), at(5, 7)}, {at(7, 7), at(5, 7)}}), Contains("vertex 62") && Contains("twice"));
  CHECK_THAT(error({{at(5, 5), at(5, 7), at(7, 7), at(5, 5)}}), Contains("in two"));
  // Walled in.
  CHECK_THAT(error({{at(4, 4), at(6, 4), at(6, 6), at(4, 6), at(4, 4)}, {at(5, 5), at(8, 8)}}),
             Contains("there is no way from vertex 60 to vertex 96"));
  // A cut is boundary afterwards.
  const OpenedMesh open = slice(whole, {{at(5, 4), at(5, 6)}});
  CHECK_THAT(error_of([&] {
               static_cast<void>(slice(open, {{at(5, 5), at(8, 8)}}));
             }),
             Contains("boundary at vertex 60"));
}
