// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/canonical_loops.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/cuts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr int most_splits_a_handle = 250; // 165 were seen

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

/// Everything that is promised of canonical loops, found out from the marks alone.
void check_canonical(const MarkedSurface& marked, const CanonicalLoops& loops, int genus, int splits_before) {
  CHECK(why_not_canonical(marked) == "");
  CHECK(boundary_word(marked) == canonical_word(genus));
  const Surface open = cut_open(marked);
  CHECK(type_of(open).is_disk());
  // Each loop is on the boundary of the disk twice, and the base point 4g times.
  const std::vector<SideEnd> boundary = boundary_curves(open).front();
  CHECK(static_cast<int>(boundary.size()) ==
        2 * std::accumulate(loops.length.begin(), loops.length.end(), 0));
  CHECK(std::count_if(boundary.begin(), boundary.end(),
                      [&](SideEnd e) { return marked.surface.vertex(e) == loops.base; }) == 4 * genus);
  CHECK(type_of(marked.surface).genus() == genus);
  CHECK(static_cast<int>(marked.splits.size()) == splits_before + loops.edge_splits + loops.face_splits);
  for (int k = 1; k <= 2 * genus; ++k) CHECK(length_of(marked, k) == loops.length[k - 1]);
}

/// Whether a mesh of lone marked loops runs along its positive sides, base to base.
void check_directions(const MarkedSurface& marked, const CanonicalLoops& loops) {
  for (int k = 1; k <= static_cast<int>(loops.length.size()); ++k) {
    std::vector<int> next(static_cast<std::size_t>(marked.surface.vertex_count()), -1);
    for (int s = 0; s < marked.surface.side_count(); ++s)
      if (marked[Side(s)] == k) next[marked.surface.from(Side(s))] = marked.surface.to(Side(s));
    int at = loops.base;
    for (int step = 0; step < loops.length[k - 1]; ++step) at = next[at];
    CHECK(at == loops.base);
  }
}

TEST_CASE("Canonical loops open surfaces of every genus to the polygon with the canonical word") {
  for (const int genus : {1, 2, 3, 5, 10}) {
    INFO("genus " << genus);
    MarkedSurface surface = genus_surface(genus).marked();
    const CanonicalLoops loops = mark_canonical_loops(surface);
    check_canonical(surface, loops, genus, 0);
    check_directions(surface, loops);
  }
}

// The number of splits is bound from experience, there to be seen when it breaks.
TEST_CASE("Canonical loops of many handles stay short and stop when told to") {
  MarkedSurface surface = genus_surface(25).marked();
  MarkedSurface same = surface;
  const CanonicalLoops loops = mark_canonical_loops(surface);
  check_canonical(surface, loops, 25, 0);
  CHECK(loops.edge_splits + loops.face_splits < 25 * most_splits_a_handle);
  std::stop_source source;
  const Progress progress(
      [&source](std::string_view, double fraction) {
        if (fraction > 0.4) source.request_stop();
      },
      source.get_token());
  CHECK_THROWS_AS(mark_canonical_loops(same, -1, progress), Stopped);
}

TEST_CASE("Canonical loops stop in each of their stages") {
  for (const std::string_view last : {"opening handles", "leading loops to the base"}) {
    MarkedSurface surface = plate_surface(3, 4).marked(); // more handles than are laid in turn
    std::stop_source source;
    std::vector<std::string> stages;
    const Progress progress(
        [&](std::string_view stage, double) {
          stages.emplace_back(stage);
          if (stage == last) source.request_stop();
        },
        source.get_token());
    CHECK_THROWS_AS(mark_canonical_loops(surface, -1, progress), Stopped);
    CHECK(stages.back() == last);
  }
}

// Splits are bound from experience: 42, 108, 272 and 334 for each handle were seen. On a wide surface the way
// to a handle is about the root of their number.
TEST_CASE("Canonical loops of wide plates grow like the genus times its root") {
  for (const int side : {3, 5, 7, 10}) {
    INFO(side << " x " << side << " holes");
    MarkedSurface surface = plate_surface(side, side).marked();
    const int genus = side * side;
    const CanonicalLoops loops = mark_canonical_loops(surface);
    check_canonical(surface, loops, genus, 0);
    CHECK(loops.edge_splits + loops.face_splits < 50 * genus * side);
  }
}

// Nothing folds: the parts of each triangle of the first surface look the same way and have its area.
TEST_CASE("Canonical loops leave the shape of a surface alone") {
  const MarkedSurface before = plate_surface(3, 4).marked();
  MarkedSurface surface = before;
  mark_canonical_loops(surface);
  REQUIRE(surface.splits.size() > 100);
  const auto normal = [](const MarkedSurface& s, int t) {
    const auto& [a, b, c] = s.surface.corners(t);
    const auto edge = [&](int v, std::size_t k) { return s.points[v][k] - s.points[a][k]; };
    std::array<double, 3> n{};
    for (std::size_t k = 0; k < 3; ++k)
      n[k] = edge(b, (k + 1) % 3) * edge(c, (k + 2) % 3) - edge(b, (k + 2) % 3) * edge(c, (k + 1) % 3);
    return n;
  };
  std::vector<double> part(static_cast<std::size_t>(before.surface.triangle_count()), 0);
  for (int t = 0; t < surface.surface.triangle_count(); ++t) {
    const std::array<double, 3> whole = normal(before, surface.origin[t]);
    const std::array<double, 3> here = normal(surface, t);
    double along = 0; // twice areas: those of the plate's triangles are 1
    for (std::size_t k = 0; k < 3; ++k) along += whole[k] * here[k];
    CHECK(along > 0);
    part[surface.origin[t]] += along;
  }
  for (const double sum : part) CHECK(sum == Approx(1).margin(1e-12));
}

TEST_CASE("Canonical loops exist on surfaces with one vertex") {
  for (const int genus : {1, 2, 3, 5}) {
    INFO("genus " << genus);
    MarkedSurface surface(glued_polygon(canonical_word(genus)));
    REQUIRE(surface.surface.vertex_count() == 1);
    const CanonicalLoops loops = mark_canonical_loops(surface);
    check_canonical(surface, loops, genus, 0);
    // The loop edges at the base are split, at least: 6g - 3 edges by Euler's formula with one vertex.
    CHECK(loops.edge_splits >= 6 * genus - 3);
    for (int k = 0; k < surface.surface.side_count(); ++k)
      if (surface.surface.from(Side(k)) == loops.base) CHECK(surface.surface.to(Side(k)) != loops.base);
  }
}

TEST_CASE("Canonical loops survive any triangulation") {
  Random random(5);
  for (int k = 0; k < 50; ++k) {
    const int genus = 1 + k % 5;
    INFO("surface " << k);
    TriangleList mesh = genus_surface(genus, 3 + k % 2, 3);
    mesh = relabelled(retriangulated(mesh, random, random.below(400), random.below(80)), random);
    MarkedSurface surface = mesh.marked();
    const CanonicalLoops loops = mark_canonical_loops(surface);
    check_canonical(surface, loops, genus, 0);
  }
}

// Beyond ten handles loops are led along a tree.
TEST_CASE("Many handles survive any triangulation, one vertex, and any base") {
  Random random(6);
  for (int k = 0; k < 8; ++k) {
    const int genus = 11 + k;
    INFO("surface " << k);
    TriangleList mesh = genus_surface(genus, 3 + k % 2, 3);
    mesh = relabelled(retriangulated(mesh, random, random.below(2000), random.below(400)), random);
    MarkedSurface surface = mesh.marked();
    check_canonical(surface, mark_canonical_loops(surface), genus, 0);
  }
  MarkedSurface one(glued_polygon(canonical_word(12)));
  const CanonicalLoops loops = mark_canonical_loops(one);
  check_canonical(one, loops, 12, 0);
  check_directions(one, loops);
  const MarkedSurface whole = genus_surface(11, 3, 3).marked();
  for (int v = 0; v < whole.surface.vertex_count(); v += 7) {
    MarkedSurface surface = whole;
    const CanonicalLoops at = mark_canonical_loops(surface, v);
    CHECK(at.base == v);
    check_canonical(surface, at, 11, 0);
  }
}

TEST_CASE("Every vertex can be the base point") {
  const MarkedSurface whole = genus_surface(2, 3, 3).marked();
  for (int v = 0; v < whole.surface.vertex_count(); ++v) {
    MarkedSurface surface = whole;
    const CanonicalLoops loops = mark_canonical_loops(surface, v);
    CHECK(loops.base == v);
    check_canonical(surface, loops, 2, 0);
  }
}

TEST_CASE("Loops on a wide surface need no splits and are short") {
  // By hand: without points, the two loops of an m x n grid have m and n edges.
  MarkedSurface torus(torus_grid(12, 7).surface());
  const CanonicalLoops loops = mark_canonical_loops(torus);
  CHECK(loops.edge_splits + loops.face_splits == 0);
  std::vector<int> length = loops.length;
  std::sort(length.begin(), length.end());
  CHECK(length == std::vector<int>{7, 12});
}

TEST_CASE("The history of splits tells where every vertex came from") {
  Random random(8);
  const TriangleList mesh = genus_surface(3, 3, 3);
  MarkedSurface surface = mesh.marked();
  mark_canonical_loops(surface);
  REQUIRE(!surface.splits.empty());
  for (std::size_t k = 0; k < surface.splits.size(); ++k) {
    CHECK(surface.splits[k].vertex == mesh.vertices + static_cast<int>(k));
    for (const int v : surface.splits[k].of) CHECK(v < surface.splits[k].vertex);
  }
  for (const int t : surface.origin) CHECK((t >= 0 && t < static_cast<int>(mesh.triangles.size())));
}

TEST_CASE("Loops are lengthened where they are longest") {
  MarkedSurface torus(torus_grid(5, 4).surface());
  mark_canonical_loops(torus);
  const int before = length_of(torus, 1);
  CHECK(lengthen(torus, 1, before) == 0);
  CHECK(lengthen(torus, 1, 1) == 0);
  // Each edge once, and then one of them again.
  CHECK(lengthen(torus, 1, 2 * before + 1) == before + 1);
  CHECK(length_of(torus, 1) == 2 * before + 1);
  CHECK(why_not_canonical(torus) == "");
  for (std::size_t k = 0; k < torus.splits.size(); ++k) {
    const auto is_new = [&](int v) { return v >= 20; };
    const auto& of = torus.splits[k].of;
    CHECK((is_new(of[0]) || is_new(of[1])) == (static_cast<int>(k) >= before));
  }
}

TEST_CASE("With points, the longest edge is split first, and equal ones in the order of sides") {
  // The boundary of the square face x = 0 of the unit cube, whose edges have length 1, and then halves.
  MarkedSurface cube = cube_surface().marked();
  std::vector<Side> marked;
  for (int k = 0; k < cube.surface.side_count(); ++k) {
    const Side s(k);
    const bool inside = s.triangle() < 2;
    const bool outside = cube.surface.mate(s).triangle() >= 2;
    if (inside && outside) marked.push_back(s);
  }
  REQUIRE(marked.size() == 4);
  for (const Side s : marked) set_mark(cube, s, 1);
  const std::array<int, 2> first{cube.surface.from(marked[0]), cube.surface.to(marked[0])};
  CHECK(lengthen(cube, 1, 11) == 7);
  CHECK(std::array{cube.splits[0].of[0], cube.splits[0].of[1]} == first);
  const std::vector<double> length = side_lengths(cube);
  int halves = 0;
  int quarters = 0;
  for (int k = 0; k < cube.surface.side_count(); ++k) {
    if (cube[Side(k)] != 1) continue;
    halves += length[k] == 0.5 ? 1 : 0;
    quarters += length[k] == 0.25 ? 1 : 0;
  }
  CHECK(halves == 5);
  CHECK(quarters == 6);
}

TEST_CASE("What is not canonical is told") {
  MarkedSurface surface = genus_surface(2).marked();
  CHECK(why_not_canonical(surface) == "the surface cut open is no disk");
  MarkedSurface by_graph = surface;
  mark_cut_graph(by_graph);
  CHECK(why_not_canonical(by_graph).find("the boundary word") == 0);
  mark_canonical_loops(surface);
  MarkedSurface swapped = surface;
  for (int& m : swapped.mark) m = m == 1 ? 2 : m == 2 ? 1 : m == -1 ? -2 : m == -2 ? -1 : m;
  // 2 1 -2 -1 3 4 -3 -4, which from letter 1 on reads 1 -2 ...
  CHECK(why_not_canonical(swapped) == "the boundary word is not canonical at letter 2");
  MarkedSurface opened = surface;
  for (int& m : opened.mark) m = std::abs(m) == 3 ? 0 : m;
  CHECK(why_not_canonical(opened) == "the surface cut open is no disk");
  CHECK(why_not_canonical(cube_surface().marked()) == "this is no closed oriented surface of positive genus");
}

TEST_CASE("A canonical word alone does not make loops canonical") {
  // A torus from a hexagon a b c -a -b -c: sides a and b, taken as one loop, are not met in reverse order on
  // the way back; they and c meet at two points.
  MarkedSurface hexagon(glued_polygon({1, 2, 3, -1, -2, -3}));
  set_mark(hexagon, Side(0, 2), 1);
  set_mark(hexagon, Side(0, 0), 1);
  set_mark(hexagon, Side(1, 0), 2);
  CHECK(boundary_word(hexagon) == canonical_word(1));
  CHECK(why_not_canonical(hexagon) == "loops meet at 2 points");
}

TEST_CASE("Canonical loops ask for a closed oriented surface of positive genus, without marks") {
  const auto refuses = [](MarkedSurface surface, int base = -1) {
    CHECK_THROWS_AS(mark_canonical_loops(surface, base), PreconditionError);
  };
  refuses(icosphere(1).marked());
  refuses(klein_grid(5, 5).marked());
  refuses(with_holes(torus_grid(6, 6), 1).marked());
  refuses(torus_grid(4, 4).marked(), 16);
  TriangleList turned = torus_grid(4, 4);
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  refuses(turned.marked());
  MarkedSurface marked = torus_grid(4, 4).marked();
  set_mark(marked, Side(0), 1);
  refuses(marked);
  CHECK_THROWS_AS(lengthen(marked, 2, 5), PreconditionError);
  CHECK_THROWS_AS(lengthen(marked, 0, 5), PreconditionError);
  CHECK_THROWS_AS(boundary_word(torus_grid(4, 4).marked()), PreconditionError);
}

} // namespace
