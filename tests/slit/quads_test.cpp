// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quads.hpp"

#include "slit/domains.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

using Space = std::array<double, 3>;

double distance(const Space& p, const Space& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

surface::TriangleMesh built(const TriangleList& list) {
  format::Soup soup;
  soup.points = list.points;
  soup.triangles = list.triangles;
  return doctor::build_surface(std::move(soup));
}

/// Each quad as two triangles. Building it proves that no edge is on three, and no vertex on two fans.
surface::TriangleMesh halved(const QuadMesh& quads) {
  TriangleList list{{}, quads.points, static_cast<int>(quads.points.size())};
  for (const auto& [a, b, c, d] : quads.quads) {
    list.triangles.push_back({a, b, c});
    list.triangles.push_back({a, c, d});
  }
  return built(list);
}

int count(const std::vector<QuadEdge>& edges, Line line) {
  return static_cast<int>(
      std::count_if(edges.begin(), edges.end(), [&](const QuadEdge& e) { return e.line == line; }));
}

/// Laws of every quad mesh of a sphere with holes.
void check_quads(const QuadMesh& quads, const OneForms& forms, const SlitMap& map) {
  const surface::TriangleMesh halves = halved(quads);
  CHECK(static_cast<int>(surface::boundary_loops(halves).size()) == forms.loop_count());
  CHECK(halves.surface.triangles().size() == 2 * quads.quads.size());
  const std::vector<QuadEdge> all = edges(quads);
  CHECK(quads.points.size() - all.size() + quads.quads.size() + forms.loop_count() == 2);
  CHECK(2 * all.size() - count(all, Line::boundary) == 4 * quads.quads.size());
  CHECK(quads.quads.size() == quads.angles.size() * (quads.heights.size() - 1));
  std::set<std::array<int, 2>> directed;
  for (const auto& quad : quads.quads) {
    CHECK(std::set<int>(quad.begin(), quad.end()).size() == 4);
    // Turned the same way: no edge is run through twice in one direction.
    for (int c = 0; c < 4; ++c) CHECK(directed.insert({quad[c], quad[(c + 1) % 4]}).second);
    // Counterclockwise on the cylinder.
    const auto& place = quads.places;
    CHECK(std::remainder(place[quad[1]][0] - place[quad[0]][0], full_turn) > 0);
    CHECK(place[quad[0]][1] == place[quad[1]][1]);
    CHECK(place[quad[2]][1] > place[quad[1]][1]);
    CHECK(place[quad[0]][0] == place[quad[3]][0]);
  }
  CHECK(quads.outside < 1e-12);
  CHECK(quads.thinnest > 0);
  for (const Slit& s : map.slits)
    for (const double end : {s.start, s.end}) {
      double nearest = 1;
      for (const auto& [angle, height] : quads.places)
        nearest = std::min(nearest, std::hypot(angle_between(angle, end), height + std::log(s.radius)));
      CHECK(nearest < 1e-8);
    }
}

struct Run {
  OneForms forms;
  SlitMap map;
  QuadMesh mesh;
  Run(const surface::TriangleMesh& surface, int outer_vertex, int inner_vertex, int around)
      : forms(surface),
        map(slit_map(forms, surface::loop_through(forms.loops(), surface.surface, outer_vertex),
                     surface::loop_through(forms.loops(), surface.surface, inner_vertex))),
        mesh(quads(forms, map, around)) {}
  Run(const CrackedCylinder& domain, int around)
      : Run(domain.mesh, domain.outer_vertex, domain.inner_vertex, around) {}
};

/// Added to the angle of a place of the domain to get the angle of the map.
double turn_of(const CrackedCylinder& domain, const SlitMap& map) {
  Complex rotation = 0;
  for (std::size_t v = 0; v < domain.at.size(); ++v)
    rotation += std::polar(1.0, map.angle[v] - domain.at[v].angle);
  return std::arg(rotation);
}

/// Greatest distance of a vertex from where `exact` has it, by angle and height.
template <class Exact>
double error(const CrackedCylinder& domain, const Run& run, const Exact& exact) {
  const double turn = turn_of(domain, run.map);
  double greatest = 0;
  for (std::size_t v = 0; v < run.mesh.points.size(); ++v) {
    const auto& [angle, height] = run.mesh.places[v];
    greatest = std::max(greatest, distance(run.mesh.points[v], exact(angle - turn, height)));
  }
  return greatest;
}

/// A point of a prism of 16 sides and circumference 2 pi.
Space on_prism(double angle, double height) {
  const double side = full_turn / 16;
  const double corner = std::numbers::pi / (16 * std::sin(std::numbers::pi / 16));
  const double before = std::floor(angle / side) * side;
  const double part = (angle - before) / side;
  const Complex at = (1 - part) * std::polar(corner, before) + part * std::polar(corner, before + side);
  return {at.real(), at.imag(), height};
}

TEST_CASE("On a prism vertices lie where angle and height say") {
  CylinderGrid grid = two_slits();
  grid.unrest = 0;
  const CrackedCylinder prism = slit_prism(grid);
  Run run(prism, 16);
  // Exact here, which ends in general are not.
  for (Slit& s : run.map.slits) {
    s.start = run.map.angle[s.start_vertex];
    s.end = s.start + full_turn / 4;
  }
  for (const int around : {3, 8, 16, 21, 100}) {
    INFO(around << " around");
    run.mesh = quads(run.forms, run.map, around);
    check_quads(run.mesh, run.forms, run.map);
    CHECK(error(prism, run, on_prism) < 1e-12);
  }
}

Complex slit_joukowski(Complex z) {
  return z + 0.08 / z;
}

TEST_CASE(
    "On a bent ring vertices come to their places, and corners to right angles, as triangles get finer") {
  const auto place = [](double angle, double height) {
    const Complex w = slit_joukowski(std::polar(std::exp(-height), angle));
    return Space{w.real(), w.imag(), 0};
  };
  std::array<double, 2> errors{};
  std::array<double, 2> angles{};
  for (const int times : {4, 16}) {
    const CrackedCylinder domain = slit_ring(refined(two_slits(), times), slit_joukowski);
    const Run run(domain, 16 * times);
    check_quads(run.mesh, run.forms, run.map);
    errors[times / 16] = error(domain, run, place);
    angles[times / 16] = quality(run.mesh).mean_angle_error;
  }
  // Both are of the first order at least: 3.6 is order 0.92, as elsewhere in this room.
  CHECK(errors[0] > 3.6 * errors[1]);
  CHECK(angles[0] > 3.6 * angles[1]);
}

TEST_CASE("Spheres with holes become quads, whatever their triangles are like") {
  Random random(5);
  std::size_t flipped = 0;
  for (int round = 0; round < 12; ++round) {
    const int holes = 2 + round % 5;
    TriangleList list = with_holes(icosphere(3), holes);
    list = relabelled(retriangulated(std::move(list), random, 100 * (round / 3), 200), random);
    // Halves of edges that were flipped would lie on a line.
    for (Space& p : list.points)
      for (double& x : p) x += 0.02 * (random.below(1001) / 500.0 - 1);
    const surface::TriangleMesh surface = built(list);
    const OneForms forms(surface);
    const int outer = random.below(holes);
    const int inner = (outer + 1 + random.below(holes - 1)) % holes;
    const SlitMap map = slit_map(forms, outer, inner);
    INFO(holes << " holes, round " << round);
    flipped += distortion_on_cylinder(forms, map).flipped.size();
    for (const int around : {3, 17, 80}) check_quads(quads(forms, map, around), forms, map);
  }
  CHECK(flipped > 12); // so that it was seen that they do no harm
}

TEST_CASE("Quads below a slit end on its lower bank, those above on its upper one") {
  const CrackedCylinder gaping = cracked_cylinder(refined(two_slits(), 4), [](const OnCylinder& p) {
    return Space{std::cos(p.angle), std::sin(p.angle), p.height + 0.02 * p.bank};
  });
  const Run run(gaping, 64);
  check_quads(run.mesh, run.forms, run.map);
  std::set<int> banks;
  for (const QuadEdge& e : edges(run.mesh))
    if (e.line == Line::boundary) banks.insert({e.from, e.to});
  int above = 0;
  int below = 0;
  for (const auto& quad : run.mesh.quads)
    for (int c = 0; c < 4; ++c) {
      const double z = run.mesh.points[quad[c]][2];
      if (z < 0.1 || z > 0.9 || banks.count(quad[c]) == 0) continue;
      // Slits are at 1/4 and 1/2; their ends are nearly in the middle between banks.
      const double gap = z - (z < 0.375 ? 0.25 : 0.5);
      if (std::abs(gap) < 0.01) continue;
      CHECK((gap > 0) == (c < 2));
      ++(gap > 0 ? above : below);
    }
  // On each bank of a slit there are about 16 edges, and an end of one is a corner of two quads.
  CHECK(above > 2 * 24);
  CHECK(below > 2 * 24);
}

TEST_CASE("Where a mirror image exchanges the rims, slits end on the mirror, between vertices") {
  // Holes at the ends of the axes x, y, z. At z, four vertices, two of them beside each end of the slit.
  const TriangleList list = with_holes(icosphere(3), 3);
  const surface::TriangleMesh surface = built(list);
  const OneForms forms(surface);
  const auto loop = [&](int axis) {
    for (int k = 0; k < 3; ++k)
      if (surface.points[surface.surface.vertex(forms.loops()[k].sides.front())][axis] > 0.9) return k;
    return -1;
  };
  const SlitMap map = slit_map(forms, loop(0), loop(1));
  REQUIRE(map.slits.size() == 1);
  const QuadMesh mesh = quads(forms, map, 24);
  check_quads(mesh, forms, map);
  const Slit& s = map.slits[0];
  for (const double end : {s.start, s.end})
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto& [angle, height] = mesh.places[v];
      if (std::hypot(angle_between(angle, end), height + std::log(s.radius)) > 1e-8) continue;
      const Space& p = mesh.points[v];
      CHECK(p[2] > 0.9);
      CHECK(p[0] == Approx(p[1]).epsilon(1e-9));
    }
}

/// Vertices of a prism at angles j / 16 of a turn and heights i / 4, so that 16 quads around fit it.
Run prism_run(const std::vector<Crack>& cracks, int around) {
  CylinderGrid grid = two_slits();
  grid.unrest = 0;
  grid.cracks = cracks;
  const CrackedCylinder prism = slit_prism(grid);
  Run run(prism, around);
  for (Slit& s : run.map.slits) {
    s.start = run.map.angle[s.start_vertex];
    s.end = s.start + std::remainder(run.map.angle[s.end_vertex] - s.start, full_turn);
  }
  run.mesh = quads(run.forms, run.map, around);
  return run;
}

TEST_CASE("Lines run through slits and their ends, evenly between, and only once where they coincide") {
  // Starts at 2 and 9, ends at 6 and 13 sixteenths of a turn: gaps of 4, 3, 4 and 5 sixteenths. 16 around
  // make them so many spaces, 4 around 1 each, and 2 between the ends of a slit.
  CHECK(prism_run({{1, 2, 4}, {2, 9, 4}}, 16).mesh.angles.size() == 16);
  CHECK(prism_run({{1, 2, 4}, {2, 9, 4}}, 4).mesh.angles.size() == 6);
  // Ends of the one above ends of the other: gaps of 4 and 12.
  CHECK(prism_run({{1, 2, 4}, {3, 2, 4}}, 4).mesh.angles.size() == 5);
  // The same, one of them a rounding error below a full turn.
  Run shaken = prism_run({{1, 2, 4}, {3, 2, 4}}, 4);
  for (const int k : {0, 1}) {
    shaken.map.slits[k].start = k == 0 ? 0 : full_turn - 1e-12;
    shaken.map.slits[k].end = shaken.map.slits[k].start + full_turn / 4;
  }
  CHECK(quads(shaken.forms, shaken.map, 4).angles.size() == 5);
  // Heights 1/4 apart in the first case, with the rims 0, 1/4, 1/2, 1: a space of 2 pi / 4 is wider than all.
  CHECK(prism_run({{1, 2, 4}, {2, 9, 4}}, 4).mesh.heights.size() == 4);
  CHECK(prism_run({{2, 2, 4}, {2, 9, 4}}, 4).mesh.heights.size() == 3);
  const QuadMesh even = prism_run({{2, 2, 4}, {2, 9, 4}}, 16).mesh;
  for (std::size_t j = 0; j < 16; ++j) CHECK(even.angles[j] == Approx(full_turn * j / 16).margin(1e-12));
  // Of a half, 2 pi / 16 = 0.39 is taken once, 2 pi / 32 = 0.20 three times.
  CHECK(even.heights.size() == 3);
  CHECK(even.thinnest == Approx(1).epsilon(1e-12));
  const QuadMesh fine = prism_run({{2, 2, 4}, {2, 9, 4}}, 32).mesh;
  CHECK(fine.heights.size() == 7);
  CHECK(fine.thinnest == Approx(0.5 / 3 / (full_turn / 32)).epsilon(1e-12));
}

TEST_CASE("Lines a hair's breadth apart are both kept, and the thinnest space is told") {
  Run run = prism_run({{2, 2, 4}, {2, 9, 4}}, 16);
  run.map.slits[1].radius *= std::exp(-1e-6);
  run.map.slits[1].start += 1e-4;
  const QuadMesh both = quads(run.forms, run.map, 16);
  CHECK(both.heights.size() == 4);
  CHECK(both.thinnest == Approx(1e-6 / (full_turn / 16)).epsilon(1e-6));
  CHECK(surface::boundary_loops(halved(both)).size() == 4);
}

TEST_CASE("The quads of a regular prism are flat rectangles of known size") {
  const Run run = prism_run({{2, 2, 4}, {2, 9, 4}}, 16);
  const QuadQuality q = quality(run.mesh);
  CHECK(q.max_angle_error < 1e-12);
  CHECK(q.max_warp < 1e-12);
  CHECK(q.min_edge == Approx(full_turn / 16).epsilon(1e-12));
  CHECK(q.max_edge == Approx(0.5).epsilon(1e-12));
  // 16 columns and 2 rows. Edges: 32 vertical; on rims 32, on slits 4 on each of 4 banks, and 8 between.
  CHECK(run.mesh.quads.size() == 32);
  const std::vector<QuadEdge> all = edges(run.mesh);
  CHECK(count(all, Line::vertical) == 32);
  CHECK(count(all, Line::boundary) == 48);
  CHECK(count(all, Line::horizontal) == 8);
}

TEST_CASE("A square with one corner lifted by its side") {
  QuadMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  mesh.quads = {{0, 1, 2, 3}};
  const QuadQuality q = quality(mesh);
  // The diagonals (1,1,1) and (-1,1,0) have the normal (-1,-1,2), along which (1,0,0) is 1/sqrt(6) long.
  CHECK(q.max_warp == Approx(2 / std::sqrt(6.0) / (std::sqrt(3.0) + std::sqrt(2.0))));
  CHECK(q.mean_warp == Approx(q.max_warp));
  // Angles: at the origin 90 degrees, at its neighbours 90 each, at the lifted corner 60, as (0,1,1) and
  // (1,0,1) are at 60 degrees.
  CHECK(q.max_angle_error == Approx(full_turn / 12));
  CHECK(q.mean_angle_error == Approx(full_turn / 48));
  CHECK(q.min_edge == 1);
  CHECK(q.max_edge == Approx(std::sqrt(2.0)));
}

TEST_CASE("Where the map leaves a part of the cylinder empty, it is told by how much") {
  Run run = prism_run({}, 16);
  for (double& log_radius : run.map.log_radius) log_radius *= 0.5;
  const QuadMesh mesh = quads(run.forms, run.map, 32);
  // Of heights 0, 1/5, ..., 1, triangles reach as far as 1/2, and 4/5 is the highest that they are asked for.
  // Points are straight above ends of the diagonals of rectangles, 2 pi / 16 wide and 1/8 high.
  CHECK(mesh.heights.size() == 6);
  CHECK(mesh.outside == Approx(0.3 * std::cos(std::atan2(1.0 / 8, full_turn / 16))).epsilon(1e-9));
  for (const Space& p : mesh.points)
    for (const double x : p) CHECK(std::isfinite(x));
}

TEST_CASE("Too few quads, too many, and slits that cannot be told apart are refused") {
  Run run = prism_run({{2, 2, 4}, {2, 9, 4}}, 16);
  CHECK_THROWS_AS(quads(run.forms, run.map, 2), PreconditionError);
  CHECK_THROWS_AS(quads(run.forms, run.map, 2'000'000'000), InputError);
  const SlitMap map = run.map;
  run.map.slits[1].start = run.map.slits[0].end;
  run.map.slits[1].end = run.map.slits[1].start + 1;
  CHECK_THROWS_WITH(quads(run.forms, run.map, 16), Catch::Contains("too near another"));
  run.map = map;
  run.map.slits[1].end = run.map.slits[1].start + 1e-12;
  CHECK_THROWS_WITH(quads(run.forms, run.map, 16), Catch::Contains("too short"));
  run.map = map;
  run.map.slits[0].radius = 1;
  CHECK_THROWS_AS(quads(run.forms, run.map, 16), InputError);
  run.map = map;
  run.map.slits[0].end = run.map.slits[0].start + 7;
  CHECK_THROWS_WITH(quads(run.forms, run.map, 16), Catch::Contains("longer than a full turn"));
}

} // namespace
