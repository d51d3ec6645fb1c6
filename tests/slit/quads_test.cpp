// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quads.hpp"

#include "slit/domains.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"

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

mesh::TriangleMesh built(const TriangleList& list) {
  format::Soup soup;
  soup.points = list.points;
  soup.triangles = list.triangles;
  return mesh::build_surface(std::move(soup));
}

/// Each quad as two triangles. Building it proves that no edge is on three, and no vertex on two fans.
mesh::TriangleMesh halved(const QuadMesh& quads) {
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
  const mesh::TriangleMesh halves = halved(quads);
  CHECK(static_cast<int>(mesh::boundary_loops(halves).size()) == forms.loop_count());
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
  Run(const mesh::TriangleMesh& surface, int outer_vertex, int inner_vertex, int around)
      : forms(surface), map(slit_map(forms, mesh::loop_through(forms.loops(), surface.surface, outer_vertex),
                                     mesh::loop_through(forms.loops(), surface.surface, inner_vertex))),
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

Complex joukowski(Complex z) {
  return z + 0.08 / z;
}

TEST_CASE(
    "On a bent ring vertices come to their places, and corners to right angles, as triangles get finer") {
  const auto place = [](double angle, double height) {
    const Complex w = joukowski(std::polar(std::exp(-height), angle));
    return Space{w.real(), w.imag(), 0};
  };
  std::array<double, 2> errors{};
  std::array<double, 2> angles{};
  for (const int times : {4, 16}) {
    const CrackedCylinder domain = slit_ring(refined(two_slits(), times), joukowski);
    const Run run(domain, 16 * times);
    check_quads(run.mesh, run.forms, run.map);
    errors[times / 16] = error(domain, run, place);
    angles[times / 16] = quality(run.mesh).mean_angle_error;
  }
  WARN(errors[0] << " " << errors[1] << " " << angles[0] << " " << angles[1]);
  CHECK(errors[0] > 3.6 * errors[1]);
  CHECK(angles[0] > 3.6 * angles[1]);
}

TEST_CASE("Spheres with holes become quads, whatever their triangles are like") {
  Random random(5);
  for (int round = 0; round < 12; ++round) {
    const int holes = 2 + round % 5;
    TriangleList list = with_holes(icosphere(3), holes);
    list = relabelled(retriangulated(std::move(list), random, 100 * (round / 3), 200), random);
    // Halves of edges that were flipped would lie on a line.
    for (Space& p : list.points)
      for (double& x : p) x += 0.02 * (random.below(1001) / 500.0 - 1);
    const mesh::TriangleMesh surface = built(list);
    const OneForms forms(surface);
    const int outer = random.below(holes);
    const int inner = (outer + 1 + random.below(holes - 1)) % holes;
    const SlitMap map = slit_map(forms, outer, inner);
    INFO(holes << " holes, round " << round);
    WARN(distortion_on_cylinder(forms, map).flipped.size());
    for (const int around : {3, 17, 80}) check_quads(quads(forms, map, around), forms, map);
  }
}

} // namespace
