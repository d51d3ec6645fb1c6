// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/surface_soups.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/format/surface_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::surface;
using namespace tetrarch::support::soups;

namespace {

/// Makes faults that can be mended: in the triangles, and points that nobody uses.
void damage(support::TriangleList& list, support::Random& random) {
  const auto some = [&] { return list.triangles[random.below(static_cast<int>(list.triangles.size()))]; };
  for (int k = random.below(5); k > 0; --k)
    list.triangles.push_back(random.below(2) == 0 ? some() : turned(some()));
  for (int k = random.below(5); k > 0; --k) {
    const Triangle t = some();
    list.triangles.push_back({t[0], t[1], t[random.below(2)]});
  }
  for (Triangle& t : list.triangles)
    if (random.below(4) == 0) t = turned(t);
  for (int k = random.below(3); k > 0; --k) list.points.push_back({1, 2, 3});
  list.vertices = static_cast<int>(list.points.size());
  list = support::relabelled(std::move(list), random);
}

support::TriangleList any_surface(int k) {
  const std::vector<support::TriangleList> zoo{support::icosphere(1),
                                               support::torus_grid(4, 5),
                                               support::klein_grid(4, 4),
                                               support::genus_surface(2),
                                               support::crosscaps(3),
                                               support::with_holes(support::torus_grid(9, 9), 2),
                                               support::cube_surface(),
                                               support::projective_plane(),
                                               support::with_holes(support::projective_plane(), 1)};
  support::TriangleList list = zoo[static_cast<std::size_t>(k) % zoo.size()];
  if (list.points.empty()) list.points = curve(list.vertices);
  return list;
}

Counts fatal_in(const Report& report) {
  Counts found = counts_in(report);
  for (int k = 0; k < kind_count; ++k)
    if (severity_of(static_cast<Kind>(k)) != Severity::fatal)
      found.erase(std::string(name_of(static_cast<Kind>(k))));
  return found;
}

void check_law(const format::Soup& soup) {
  const Report before = validate_surface(soup);
  const Repaired once = repair(soup);
  const Report after = validate_surface(once.soup);
  // Pinched vertices are split and components turned that are inside out; both are no repairable findings,
  // for a mesh may be used as it is, or may not be used at all.
  CHECK(once.done.empty() ==
        (before.count(Severity::repairable) == 0 && before.count(Kind::non_manifold_vertex) == 0 &&
         before.count(Kind::inside_out) == 0));
  CHECK(after.count(Kind::inside_out) == 0);
  CHECK(after.count(Kind::non_manifold_vertex) == 0);
  CHECK(after.count(Severity::repairable) == 0);
  Counts left = fatal_in(before);
  left.erase("non_manifold_vertex");
  CHECK(fatal_in(after) == left);
  const Repaired twice = repair(once.soup);
  CHECK(twice.done.empty());
  CHECK(twice.soup.points == once.soup.points);
  CHECK(twice.soup.triangles == once.soup.triangles);
  CHECK(twice.soup.triangle_labels == once.soup.triangle_labels);
  CHECK(twice.soup.point_labels == once.soup.point_labels);
}

} // namespace

TEST_CASE("a damaged surface is repaired to the surface that it was", "[repair_surface]") {
  support::Random random(3);
  for (int round = 0; round < 90; ++round) {
    support::TriangleList list = any_surface(round);
    const SurfaceType type = type_of(list.surface());
    const std::size_t triangles = list.triangles.size();
    damage(list, random);
    const format::Soup soup = surface_soup(list);
    check_law(soup);
    const TriangleMesh mesh = build_surface(repair(soup).soup);
    CHECK(mesh.surface.triangles().size() == triangles);
    CHECK(type_of(mesh.surface) == type);
  }
}

TEST_CASE("what cannot be mended stays, and the rest is mended", "[repair_surface]") {
  support::Random random(4);
  for (int round = 0; round < 200; ++round) {
    support::TriangleList list = any_surface(round);
    for (int k = 1 + random.below(3); k > 0; --k)
      list.triangles.push_back(
          {random.below(list.vertices), random.below(list.vertices), random.below(list.vertices)});
    damage(list, random);
    check_law(surface_soup(list));
  }
}

// All literals from here on are by hand.

TEST_CASE("repair of a surface says what it did and keeps numbers and lines", "[repair_surface]") {
  // Three good triangles, the second turned; 2, 4 and 5 are bad.
  format::Soup soup = surface_soup({{0, 0, 0}, {1, 0, 0}, {7, 7, 7}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}},
                                   {{0, 1, 3}, {0, 0, 1}, {1, 3, 4}, {3, 1, 0}, {4, 3, 1}, {1, 5, 4}});
  soup.triangle_tags = {10, 11, 12, 13, 14, 15};
  const Repaired result = repair(soup);
  CHECK(result.done == std::vector<std::string>{
                           "removed 1 degenerate triangles", "removed 2 duplicate triangles",
                           "turned round 1 triangles against their component", "removed 1 unused vertices"});
  CHECK(result.soup.triangles == Triangles{{0, 1, 2}, {1, 3, 2}, {1, 4, 3}});
  CHECK(result.soup.triangle_tags == std::vector<int>{10, 12, 15});
  CHECK(result.soup.triangle_labels.numbers[1] == 3);
  CHECK(result.soup.triangle_labels.lines[2] == 18);
  CHECK(result.soup.point_labels.numbers[2] == 4);
}

TEST_CASE("an index out of range stays out of range in a surface", "[repair_surface]") {
  const Repaired result = repair(surface_soup(curve(5), {{0, 1, 2}, {0, 1, 3}, {0, 1, 9}}));
  const Report report = validate_surface(result.soup);
  CHECK(counts_in(report) == Counts{{"index_out_of_range", 1}, {"unused_vertex", 1}});
  CHECK(repair(result.soup).done.empty());
}

TEST_CASE("triangles beside tetrahedra are left as they are", "[repair_surface]") {
  const Triangles triangles{{0, 1, 2}, {0, 1, 3}, {0, 0, 1}};
  CHECK(repair(soup_of(curve(4), {{0, 1, 2, 3}}, triangles)).soup.triangles == triangles);
}

TEST_CASE("corners of STL triangles are merged where they are equal", "[repair_surface]") {
  const format::Soup soup = surface_soup(support::torus_grid(4, 4));
  const format::Soup read = format::read_stl(format::write_stl(soup), "f");
  CHECK(read.points.size() == 16);
  CHECK(counts_in(validate_surface(read)).empty());
}
