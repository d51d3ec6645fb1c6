// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/cuts.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

struct Named {
  std::string name; ///< as `SurfaceType::str` says it
  MarkedSurface surface;
};

/// The names are the constructions' own: sums of tori and projective planes, less disks.
std::vector<Named> zoo() {
  std::vector<Named> all{
      {"sphere", tetrahedron_surface().marked()},
      {"sphere", cube_surface().marked()},
      {"sphere", icosphere(2).marked()},
      {"disk", with_holes(icosphere(2), 1).marked()},
      {"sphere, 3 holes", with_holes(icosphere(2), 3).marked()},
      {"torus", torus_grid(3, 3).marked()},
      {"torus", torus_grid(9, 7).marked()},
      {"genus 2", genus_surface(2, 3, 3).marked()},
      {"genus 5", genus_surface(5).marked()},
      {"genus 2, 4 holes", with_holes(genus_surface(2, 9, 9), 4).marked()},
      {"projective plane", projective_plane().marked()},
      {"projective plane, 1 hole", with_holes(projective_plane(), 1).marked()},
      {"Klein bottle", klein_grid(4, 4).marked()},
      {"Klein bottle, 3 holes", with_holes(klein_grid(9, 9), 3).marked()},
      {"5 crosscaps", crosscaps(5).marked()},
      {"torus", MarkedSurface(glued_polygon(canonical_word(1)))},
      {"genus 3", MarkedSurface(glued_polygon(canonical_word(3)))},
      {"Klein bottle", MarkedSurface(glued_polygon({1, 1, 2, 2}))},
      {"4 crosscaps", MarkedSurface(glued_polygon({1, 1, 2, 2, 3, 4, -3, -4}))},
      {"torus, 1 hole", MarkedSurface(glued_polygon({1, 2, -1, -2, 3}))},
  };
  Random random(11);
  for (const auto& [name, mesh] : {std::pair{"sphere", tetrahedron_surface()},
                                   {"genus 3", genus_surface(3, 3, 3)},
                                   {"3 crosscaps", crosscaps(3)},
                                   {"torus, 2 holes", with_holes(torus_grid(7, 7), 2)}})
    for (int k = 0; k < 5; ++k)
      all.push_back({name, relabelled(retriangulated(mesh, random, 300, 40), random).marked()});
  return all;
}

/// How many ends of marked edges each vertex has.
std::vector<int> cut_degrees(const MarkedSurface& surface) {
  std::vector<int> degree(static_cast<std::size_t>(surface.surface.vertex_count()), 0);
  for (int k = 0; k < surface.surface.side_count(); ++k)
    if (surface.is_cut(Side(k)))
      for (const bool at_start : {true, false}) ++degree[surface.surface.vertex({Side(k), at_start})];
  for (int& d : degree) d /= 2;
  return degree;
}

TEST_CASE("The surfaces of the tests are what their names say") {
  for (const Named& s : zoo()) CHECK(type_of(s.surface.surface).str() == s.name);
}

TEST_CASE("A cut graph opens every surface to a disk, and nothing of it dangles") {
  for (Named s : zoo()) {
    INFO(s.name);
    const int arcs = mark_cut_graph(s.surface);
    CHECK(type_of(cut_open(s.surface)).is_disk());
    std::set<int> numbers;
    for (const int m : s.surface.mark) numbers.insert(std::abs(m));
    numbers.erase(0);
    CHECK(static_cast<int>(numbers.size()) == arcs);
    CHECK((arcs == 0 || (*numbers.begin() == 1 && *numbers.rbegin() == arcs)));
    if (s.name == "sphere") continue;
    const std::vector<int> degree = cut_degrees(s.surface);
    std::vector<char> on_boundary(degree.size(), 0);
    for (int k = 0; k < s.surface.surface.side_count(); ++k)
      if (const Side b(k); s.surface.surface.is_boundary(b))
        on_boundary[s.surface.surface.from(b)] = on_boundary[s.surface.surface.to(b)] = 1;
    for (std::size_t v = 0; v < degree.size(); ++v) CHECK((degree[v] != 1 || on_boundary[v]));
  }
}

TEST_CASE("Each arc of a cut graph is one run on either bank") {
  for (Named s : zoo()) {
    INFO(s.name);
    const int arcs = mark_cut_graph(s.surface);
    const Surface open = cut_open(s.surface);
    const std::vector<int> degree = cut_degrees(s.surface);
    std::vector<SideEnd> boundary = boundary_curves(open).front();
    const auto starts_run = [&](SideEnd e) {
      return s.surface.surface.is_boundary(e.side) || degree[s.surface.surface.vertex(e)] != 2;
    };
    // The walk may start inside a run.
    std::rotate(boundary.begin(), std::find_if(boundary.begin(), boundary.end(), starts_run), boundary.end());
    std::map<int, int> runs;
    int before = 0;
    for (const SideEnd e : boundary) {
      const int here = s.surface[e.side];
      if (here != before || starts_run(e)) ++runs[here];
      before = here;
    }
    runs.erase(0);
    CHECK(static_cast<int>(runs.size()) == 2 * arcs);
    for (const auto& [mark, count] : runs) CHECK(count == 1);
  }
}

TEST_CASE("A sphere is opened along one edge, an annulus along one arc, a disk not at all") {
  MarkedSurface sphere = cube_surface().marked();
  CHECK(mark_cut_graph(sphere) == 1);
  // One edge of the cube's twelve sides of length 1, with two sides.
  CHECK(std::count_if(sphere.mark.begin(), sphere.mark.end(), [](int m) { return m != 0; }) == 2);
  MarkedSurface annulus = with_holes(icosphere(2), 2).marked();
  CHECK(mark_cut_graph(annulus) == 1);
  MarkedSurface disk = with_holes(icosphere(2), 1).marked();
  CHECK(mark_cut_graph(disk) == 0);
}

TEST_CASE("Generators are closed walks through their root, as many as the Euler characteristic says") {
  for (const Named& s : zoo()) {
    INFO(s.name);
    const SurfaceType type = type_of(s.surface.surface);
    const int root = s.surface.surface.vertex_count() / 2;
    const std::vector<Loop> loops = generators(s.surface, root);
    CHECK(static_cast<int>(loops.size()) == (type.is_closed() ? 2 : 1) - type.euler);
    for (const Loop& loop : loops) {
      int at = root;
      for (const SideEnd e : loop) {
        REQUIRE(s.surface.surface.vertex(e) == at);
        at = s.surface.surface.vertex({e.side, !e.at_start});
      }
      CHECK(at == root);
    }
  }
}

TEST_CASE("Generators of a closed surface cut it into one disk") {
  for (Named s : zoo()) {
    if (!type_of(s.surface.surface).is_closed() || s.name == "sphere") continue;
    INFO(s.name);
    for (const Loop& loop : generators(s.surface, 0))
      for (const SideEnd e : loop) set_mark(s.surface, e.side, 1);
    CHECK(type_of(cut_open(s.surface)).is_disk());
  }
}

TEST_CASE("Generators of a grid on a torus are as short as they can be") {
  // By hand: with edges of length 1 a loop once along m squares has m edges, and one along both m and n
  // squares, by diagonals, the greater of m and n.
  MarkedSurface torus(torus_grid(9, 7).surface());
  for (int root = 0; root < 63; root += 9) {
    const std::vector<Loop> loops = generators(torus, root);
    CHECK(loops[0].size() == 7);
    CHECK(loops[1].size() == 9);
  }
}

TEST_CASE("Trying more roots makes generators no longer") {
  const auto total = [](const MarkedSurface& s, int root) {
    const std::vector<double> length = side_lengths(s);
    double sum = 0;
    for (const Loop& loop : generators(s, root))
      for (const SideEnd e : loop) sum += length[e.side.value];
    return sum;
  };
  // A ring of radii 2 and 1: loops are shortest on its inside, at distance 1 from the axis.
  const MarkedSurface ring = torus_grid(24, 12).marked();
  const double one = total(ring, root_of_short_generators(ring, 1));
  const double many = total(ring, root_of_short_generators(ring, 16));
  CHECK(many < one);
  double least = many;
  for (int v = 0; v < ring.surface.vertex_count(); ++v) least = std::min(least, total(ring, v));
  CHECK(many < 1.1 * least);
}

TEST_CASE("Cuts ask for connected surfaces and existing roots") {
  const TriangleList one = tetrahedron_surface();
  TriangleList two = one;
  for (auto t : one.triangles) two.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  MarkedSurface apart(Surface(8, two.triangles));
  CHECK_THROWS_AS(mark_cut_graph(apart), PreconditionError);
  CHECK_THROWS_AS(generators(apart, 0), PreconditionError);
  CHECK_THROWS_AS(root_of_short_generators(apart), PreconditionError);
  CHECK_THROWS_AS(generators(one.marked(), 4), PreconditionError);
  CHECK_THROWS_AS(generators(one.marked(), -1), PreconditionError);
  MarkedSurface whole = one.marked();
  CHECK_THROWS_AS(mark_uncrossed(whole, std::vector<char>(3)), PreconditionError);
}

} // namespace
