// SPDX-License-Identifier: GPL-2.0-or-later
/// Surfaces: walks around vertices and boundaries, types, splits, and what these leave as it was.
#include "tetrarch/surface/surface.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/planar.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

namespace {

struct Named {
  std::string type;
  Surface surface;
};

/// Types by the classification of surfaces, from how each is made.
std::vector<Named> zoo() {
  return {{"sphere", tetrahedron_surface().surface()},
          {"sphere", cube_surface().surface()},
          {"torus", torus_grid(3, 4).surface()},
          {"torus", glued_polygon({1, 2, -1, -2})},
          {"genus 2", genus_surface(2).surface()},
          {"genus 3", glued_polygon(canonical_word(3))},
          {"projective plane", projective_plane().surface()},
          {"Klein bottle", klein_grid(4, 4).surface()},
          {"Klein bottle", glued_polygon({1, 2, -1, 2})},
          {"3 crosscaps", glued_polygon({1, 1, 2, 2, 3, 3})},
          {"sphere, 2 holes", with_holes(icosphere(2), 2).surface()},
          {"torus, 1 hole", glued_polygon({1, 2, -1, -2, 3})},
          {"projective plane, 1 hole", glued_polygon({1, 1, 2, 3})},
          {"disk", glued_polygon({1, -1, 2, 3})}};
}

/// Mates are mutual, and see each other's ends where vertices say so.
void check_sound(const Surface& surface) {
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    if (surface.is_boundary(s)) continue;
    REQUIRE(surface.mate(surface.mate(s)) == s);
    for (const bool at_start : {true, false}) {
      const SideEnd e{s, at_start};
      REQUIRE(surface.vertex(surface.across(e)) == surface.vertex(e));
      REQUIRE(surface.across(surface.across(e)) == e);
    }
  }
}

} // namespace

TEST_CASE("The type of a surface is found", "[surface]") {
  for (const Named& n : zoo()) {
    check_sound(n.surface);
    CHECK(type_of(n.surface).str() == n.type);
  }
}

TEST_CASE("The fans of all vertices are all corners, each once", "[surface]") {
  for (const Named& n : zoo()) {
    const Surface& s = n.surface;
    std::set<std::pair<int, int>> corners;
    std::set<int> vertices;
    for (int t = 0; t < s.triangle_count(); ++t)
      for (int c = 0; c < 3; ++c) {
        if (!vertices.insert(s.corners(t)[c]).second) continue;
        const SideEnd start{Side(t, (c + 2) % 3), true};
        for (const SideEnd& first : {start, start.pivot()})
          CHECK(fan(s, first).size() == fan(s, start).size());
        for (const SideEnd& e : fan(s, start)) {
          CHECK(s.vertex(e) == s.corners(t)[c]);
          CHECK(corners.insert({e.side.triangle(), e.corner()}).second);
        }
      }
    CHECK(static_cast<int>(corners.size()) == s.side_count());
    CHECK(static_cast<int>(vertices.size()) == s.vertex_count());
  }
}

TEST_CASE("Boundary curves run through every boundary side once, end to end", "[surface]") {
  for (const Named& n : zoo()) {
    const auto curves = boundary_curves(n.surface);
    std::size_t sides = 0;
    for (const auto& curve : curves) {
      sides += curve.size();
      for (std::size_t k = 0; k < curve.size(); ++k) {
        const SideEnd& e = curve[k];
        CHECK(n.surface.is_boundary(e.side));
        CHECK(n.surface.vertex({e.side, !e.at_start}) == n.surface.vertex(curve[(k + 1) % curve.size()]));
      }
    }
    CHECK(static_cast<int>(sides) == 2 * n.surface.edge_count() - n.surface.side_count());
  }
}

TEST_CASE("Splits keep the type, also of triangles glued to themselves, and carry numbers along",
          "[surface]") {
  Random random(5);
  for (const Named& n : zoo()) {
    Surface s = n.surface;
    // A number on every edge, opposite on the two sides; the halves of an edge inherit it.
    std::vector<int> carried(static_cast<std::size_t>(s.side_count()), 0);
    for (int k = 0; k < s.side_count(); ++k)
      if (s.is_boundary(Side(k)) || s.mate(Side(k)).value > k) carried[k] = k + 1;
    for (int k = 0; k < s.side_count(); ++k)
      if (carried[k] == 0) carried[k] = -carried[s.mate(Side(k)).value];
    std::map<int, int> pieces; // of each number, how many sides have it
    for (const int c : carried) pieces[c] = 1;
    std::vector<int> origin(static_cast<std::size_t>(s.triangle_count()));
    std::iota(origin.begin(), origin.end(), 0);
    for (int step = 0; step < 40; ++step) {
      const int vertices = s.vertex_count();
      if (random.below(2) == 0) {
        const Side side(random.below(s.side_count()));
        const int number = carried[side.value];
        const bool inside = !s.is_boundary(side);
        CHECK(s.split_edge(side, &carried, &origin) == vertices);
        if (number != 0) {
          ++pieces[number];
          if (inside) ++pieces[-number];
        }
      } else {
        CHECK(s.split_face(random.below(s.triangle_count()), &carried, &origin) == vertices);
      }
    }
    check_sound(s);
    CHECK(type_of(s).str() == n.type);
    CHECK(static_cast<int>(origin.size()) == s.triangle_count());
    std::map<int, int> found;
    for (const int c : carried)
      if (c != 0) ++found[c];
    pieces.erase(0);
    CHECK(found == pieces);
    for (int k = 0; k < s.side_count(); ++k)
      if (carried[k] != 0 && !s.is_boundary(Side(k))) CHECK(carried[s.mate(Side(k)).value] == -carried[k]);
    // The names that vertices have kept are those that gluings give, up to renaming.
    Table<Side, Side> mate(s.side_count());
    std::vector<char> turned(static_cast<std::size_t>(s.side_count()));
    for (int k = 0; k < s.side_count(); ++k) {
      mate[Side(k)] = s.mate(Side(k));
      turned[k] = static_cast<char>(s.is_turned(Side(k)));
    }
    CHECK(Surface(mate, turned).vertex_count() == s.vertex_count());
  }
}

TEST_CASE("Triangles turned over make the same surface, and turned back the same bytes", "[surface]") {
  Random random(6);
  for (const Named& n : zoo()) {
    Surface s = n.surface;
    std::vector<char> over(static_cast<std::size_t>(s.triangle_count()));
    for (char& o : over) o = static_cast<char>(random.below(2));
    s.turn(over);
    check_sound(s);
    CHECK(type_of(s).str() == n.type);
    if (const auto sign = orientation(s); !sign.empty()) {
      std::vector<char> back(sign.size());
      for (std::size_t t = 0; t < sign.size(); ++t) back[t] = static_cast<char>(sign[t] < 0);
      s.turn(back);
      for (int k = 0; k < s.side_count(); ++k) CHECK(!s.is_turned(Side(k)));
      s.turn(back);
    }
    s.turn(over);
    CHECK(s.triangles() == n.surface.triangles());
  }
}

TEST_CASE("The parts of a surface are put apart", "[surface]") {
  // Two triangles side by side, and a tetrahedron's boundary.
  const Surface s(8, {{0, 1, 2}, {4, 6, 5}, {2, 1, 3}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}});
  const Parts both = parts(s);
  CHECK(both.of == std::vector<int>{0, 1, 0, 1, 1, 1});
  const auto part = split(s, both);
  CHECK(type_of(part[0].surface).is_disk());
  CHECK(type_of(part[1].surface).is_sphere());
  CHECK(part[1].triangles == std::vector<int>{1, 3, 4, 5});
  CHECK(part[1].in_whole(Side(2, 1)) == Side(4, 1));
  CHECK_THROWS_AS(type_of(s), PreconditionError);
}

TEST_CASE("Bad corners are refused by name", "[surface]") {
  CHECK_THROWS_WITH(Surface(3, {{0, 1, 3}}), "triangle 0 names vertex 3, but there are 3");
  CHECK_THROWS_WITH(Surface(5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}),
                    "triangles 0 and 2, edge 0-1: more than two triangles share it");
}

TEST_CASE("Tutte's embedding keeps every triangle counterclockwise", "[surface]") {
  // A sphere with a hole, where by chance no edge inside joins two boundary vertices.
  const Surface disk = with_holes(icosphere(2), 1).surface();
  const auto points = tutte_embedding(disk);
  double area = 0;
  for (int t = 0; t < disk.triangle_count(); ++t) {
    const auto& [a, b, c] = disk.corners(t);
    const double twice = (points[b][0] - points[a][0]) * (points[c][1] - points[a][1]) -
                         (points[c][0] - points[a][0]) * (points[b][1] - points[a][1]);
    CHECK(twice > 0);
    area += twice / 2;
  }
  // All of them together are the regular polygon on the circle.
  const auto n = static_cast<double>(boundary_curves(disk)[0].size());
  CHECK(area == Approx(n / 2 * std::sin(2 * std::acos(-1.0) / n)));
  CHECK_THROWS_AS(tutte_embedding(cube_surface().surface()), PreconditionError);
}
