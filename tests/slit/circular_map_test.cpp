// SPDX-License-Identifier: GPL-2.0-or-later
/// Circular domains of meshes, disks, flipped triangles and fingerprints.
#include "tetrarch/slit/circular_map.hpp"

#include "slit/domains.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/slit/fingerprint.hpp"
#include "tetrarch/slit/matching.hpp"
#include "tetrarch/slit/unflip.hpp"
#include "tetrarch/surface/refine.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <stop_token>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

/// The slits that `slit_ring(two_slits(), ...)` has.
SlitRing exact_ring() {
  return {std::exp(-1.0),
          {{std::exp(-0.25), 0, full_turn / 4}, {std::exp(-0.5), full_turn * 7 / 16, full_turn * 11 / 16}}};
}

struct CircleErrors {
  double circles = 0;  ///< of centres and radii
  double boundary = 0; ///< of the vertices on the slits' circles
  double angles = 0;   ///< the mean angle error
  std::size_t flipped = 0;
};

/// Against the exact ring's circles; the slit at height 1/4 is the one of `tips[0]`.
CircleErrors circle_errors(int times) {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), times), moebius);
  const OneForms forms(domain.mesh);
  const SlitMap map = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
  const CircularMap found = circular_map(forms, map);
  REQUIRE(found.domain.found);
  const CircularDomain exact = circular_domain(exact_ring());
  CircleErrors e;
  const int first = surface::loop_through(forms.loops(), domain.mesh.surface, domain.tips[0][0]);
  // The mesh may number the second slit first; then that one's circle is on the positive axis.
  const bool exchanged = found.loop[2] != first;
  const Complex turn =
      exchanged ? std::conj(exact.circles[3].center) / std::abs(exact.circles[3].center) : 1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Circle& known = exact.circles[k < 2 || !exchanged ? k : 5 - k];
    e.circles = std::max({e.circles, std::abs(found.domain.circles[k].center - turn * known.center),
                          std::abs(found.domain.circles[k].radius - known.radius)});
  }
  for (std::size_t slit = 0; slit < 2; ++slit) {
    const Arc arc = exact_ring().slits[slit];
    for (std::size_t v = 0; v < domain.at.size(); ++v) {
      const OnCylinder& at = domain.at[v];
      const double height = -std::log(arc.radius);
      const double from_start = std::remainder(at.angle - full_turn * 2 / 16 - arc.start, full_turn);
      const double length = arc.end - arc.start;
      if (std::abs(at.height - height) > 1e-12 || from_start < -1e-9 || from_start > length + 1e-9) continue;
      const double t = std::acos(std::clamp(2 * from_start / length - 1, -1.0, 1.0));
      // Bank 1 is above, at greater height, nearer the origin.
      const Complex place =
          curve_at(exact, static_cast<int>(slit) + 2, {at.bank >= 0 ? t : full_turn - t})[0];
      e.boundary = std::max(e.boundary, std::abs(found.position[v] - turn * place));
    }
  }
  const Distortion distortion = distortion_in_plane(domain.mesh, found.position);
  e.angles = distortion.mean_angle_error;
  e.flipped = distortion.flipped.size();
  return e;
}

TEST_CASE("Circles of a bent ring with slits converge to those of the ring, and so do the places on them") {
  const CircleErrors coarse = circle_errors(2);
  const CircleErrors fine = circle_errors(8);
  CHECK(coarse.flipped + fine.flipped == 0);
  CHECK(coarse.circles > 11 * fine.circles);
  // Harmonic measure, by which the ends of slits are found, goes as a square root at the tips of these
  // cracks.
  CHECK(coarse.boundary > 4 * fine.boundary);
  CHECK(coarse.angles > 3.6 * fine.angles);
}

/// The greatest relative difference between inversive distances of circles, for other loops as outer and
/// inner circle of the ring on the way.
double dependence_on_loops(int times) {
  const OneForms forms(slit_ring(refined(two_slits(), times), moebius).mesh);
  const auto distance = [](const CircularMap& map, int a, int b) {
    const auto circle = [&](int loop) {
      return map.domain.circles[static_cast<std::size_t>(std::find(map.loop.begin(), map.loop.end(), loop) -
                                                         map.loop.begin())];
    };
    const Circle p = circle(a);
    const Circle q = circle(b);
    return std::abs(std::norm(p.center - q.center) - p.radius * p.radius - q.radius * q.radius) /
           (2 * p.radius * q.radius);
  };
  double greatest = 0;
  const CircularMap first = circular_map(forms, slit_map(forms, 0, 1));
  for (const auto& [outer, inner] : {std::pair{0, 2}, {0, 3}, {2, 0}, {3, 1}}) {
    const CircularMap other = circular_map(forms, slit_map(forms, outer, inner));
    REQUIRE(other.domain.found);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b)
        greatest = std::max(greatest, std::abs(distance(other, a, b) / distance(first, a, b) - 1));
  }
  return greatest;
}

TEST_CASE("Whatever loops the ring is made from, the circular domain is the same up to a Moebius map") {
  // Two loops are cracks here, at whose tips harmonic functions go as square roots: order 1.
  const double coarse = dependence_on_loops(2);
  const double fine = dependence_on_loops(8);
  CHECK(coarse < 0.2);
  CHECK(coarse > 3 * fine);
}

/// The unit disk: a fan about 0 and rings around it, moved by a function.
template <class Bend>
surface::TriangleMesh disk(int rings, int sectors, const Bend& bend) {
  format::Soup soup;
  const auto add = [&](Complex z) {
    const Complex w = bend(z);
    soup.points.push_back({w.real(), w.imag(), 0});
  };
  add(0);
  for (int i = 1; i <= rings; ++i)
    for (int j = 0; j < sectors; ++j)
      add(std::polar(static_cast<double>(i) / rings, full_turn * (j + i / 2.0) / sectors));
  const auto at = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
  for (int j = 0; j < sectors; ++j) {
    soup.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i < rings; ++i) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      soup.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return doctor::build_surface(std::move(soup));
}

TEST_CASE("Riemann's map of a disk converges to the exact one") {
  // z + z^2 / 4 is one to one on the unit disk; the way back is what is to be found.
  const auto bend = [](Complex z) { return z + z * z / 4.0; };
  const auto error = [&](int rings) {
    const surface::TriangleMesh mesh = disk(rings, 4 * rings, bend);
    const CircularMap map = disk_map(mesh, 0);
    const auto known = disk(rings, 4 * rings, [](Complex z) { return z; }).points;
    const int first = mesh.surface.vertex(surface::boundary_loops(mesh)[0].sides.front());
    const Complex turn = 1.0 / Complex(known[first][0], known[first][1]);
    double greatest = 0;
    for (std::size_t v = 0; v < known.size(); ++v)
      greatest = std::max(greatest, std::abs(map.position[v] - turn * Complex(known[v][0], known[v][1])));
    CHECK(distortion_in_plane(mesh, map.position).flipped.empty());
    return greatest;
  };
  const double coarse = error(8);
  const double fine = error(32);
  CHECK(coarse < 0.1);
  CHECK(coarse > 11 * fine);
}

/// A strip of squares, long and two wide.
surface::TriangleMesh strip(int length) {
  format::Soup soup;
  for (int i = 0; i <= length; ++i)
    for (int j = 0; j < 3; ++j) soup.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (int i = 0; i < length; ++i)
    for (int j = 0; j < 2; ++j) {
      const int at = 3 * i + j;
      soup.triangles.push_back({at, at + 3, at + 4});
      soup.triangles.push_back({at, at + 4, at + 1});
    }
  return doctor::build_surface(std::move(soup));
}

TEST_CASE("A disk of which the centre sees next to nothing is refused") {
  // The far end of a strip of width 2 and length L sees e^(-pi L / 2): 1e-5 and 1e-55. Two of the corners
  // have no neighbor inside.
  const surface::TriangleMesh near = strip(8);
  const CircularMap map = disk_map(near, 4);
  CHECK(distortion_in_plane(near, map.position).flipped.empty());
  CHECK_THROWS_AS(disk_map(strip(80), 4), InputError);
  CHECK_NOTHROW(disk_map(strip(14), 3 * 7 + 1));
}

TEST_CASE("Riemann's map refuses what is no disk, and a centre that is not inside") {
  const surface::TriangleMesh mesh = disk(2, 8, [](Complex z) { return z; });
  CHECK(innermost_vertex(mesh) == 0);
  CHECK_THROWS_AS(disk_map(mesh, 16), InputError);
  CHECK_THROWS_AS(disk_map(mesh, 17), InputError);
  CHECK_THROWS_AS(disk_map(mesh, -1), InputError);
  CHECK_THROWS_AS(disk_map(slit_ring(two_slits(), moebius).mesh, 20), InputError);
  const TriangleList fan = {{{0, 1, 2}}, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, 3};
  CHECK(innermost_vertex({fan.points, fan.surface()}) == -1);
}

TEST_CASE("Vertices pulled out of their place are put back until no triangle is flipped") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 4), moebius);
  const OneForms forms(domain.mesh);
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), domain.mesh.surface);
  const CircularMap good = circular_map(forms, slit_map(forms, 0, 1));
  CircularMap map = good;
  CHECK(unflip_in_disk(domain.mesh, map).moved == 0);
  Random random(3);
  int pulled = 0;
  for (int k = 0; k < 12; ++k) {
    const int v = random.below(static_cast<int>(map.position.size()));
    if (loop[v] >= 0) continue;
    map.position[v] += std::polar(0.1, full_turn * random.uniform());
    ++pulled;
  }
  REQUIRE(pulled > 5);
  REQUIRE_FALSE(distortion_in_plane(domain.mesh, map.position).flipped.empty());
  const Unflipped done = unflip_in_disk(domain.mesh, map);
  CHECK(done.left == 0);
  CHECK(done.moved >= pulled);
  CHECK(done.moved < 20 * pulled);
  CHECK(done.farthest > 0.05);
  CHECK(distortion_in_plane(domain.mesh, map.position).flipped.empty());
  for (std::size_t k = 0; k < map.loop.size(); ++k)
    for (const surface::SideEnd e : forms.loops()[map.loop[k]].sides) {
      const Circle& circle = map.domain.circles[k];
      CHECK(std::abs(map.position[domain.mesh.surface.vertex(e)] - circle.center) ==
            Approx(circle.radius).epsilon(1e-12));
    }
}

TEST_CASE("A hub of a thousand triangles comes back to the middle of its ring") {
  const surface::TriangleMesh mesh = disk(2, 1000, [](Complex z) { return z; });
  CircularMap map = disk_map(mesh, 0);
  REQUIRE(std::abs(map.position[0]) < 1e-12);
  map.position[0] = {0.8, 0.4};
  REQUIRE_FALSE(distortion_in_plane(mesh, map.position).flipped.empty());
  const CircularMap before = map;
  const Unflipped done = unflip_in_disk(mesh, map);
  CHECK(done.left == 0);
  // As far as can be from all sides of a regular polygon is its center.
  CHECK(std::abs(map.position[0]) < 1e-9);

  std::stop_source stop;
  stop.request_stop();
  map = before;
  CHECK_THROWS_AS(unflip_in_disk(mesh, map, Unflip::everywhere, Progress({}, stop.get_token())), Stopped);
}

TEST_CASE("On the cylinder and on the ring vertices of slits stay on them") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 2), moebius);
  const OneForms forms(domain.mesh);
  const SlitMap good = slit_map(forms, 0, 1);
  // A slit's vertex pushed past its neighbour.
  const auto& sides = forms.loops()[good.slits[0].loop].sides;
  const int v = domain.mesh.surface.vertex(sides[2]);
  for (const bool on_ring : {false, true}) {
    SlitMap map = good;
    const double push = 2 * (map.form.imaginary[sides[2].side.value]);
    map.angle[v] += push;
    for (int s = 0; s < domain.mesh.surface.side_count(); ++s) {
      if (domain.mesh.surface.to(surface::Side(s)) == v) map.form.imaginary[s] += push;
      if (domain.mesh.surface.from(surface::Side(s)) == v) map.form.imaginary[s] -= push;
    }
    const auto flipped = [&] {
      return (on_ring ? distortion_on_ring(forms, map) : distortion_on_cylinder(forms, map)).flipped.size();
    };
    REQUIRE(flipped() > 0);
    const Unflipped done = on_ring ? unflip_on_ring(forms, map) : unflip_on_cylinder(forms, map);
    CHECK(done.left == 0);
    CHECK(flipped() == 0);
    CHECK(map.log_radius[v] == Approx(good.log_radius[v]).epsilon(1e-12));
    CHECK(residuals(forms, map).radius < 1e-12);
  }
}

TEST_CASE("On bad triangles maps flip some, and no flipped triangle is left") {
  Random random(9);
  std::size_t flipped = 0;
  for (int round = 0; round < 15; ++round) {
    const CrackedCylinder domain = slit_ring(refined(two_slits(), 1 + round % 3), moebius);
    const TriangleList plain{domain.mesh.surface.triangles(), domain.mesh.points,
                             domain.mesh.surface.vertex_count()};
    const TriangleList bad = retriangulated(plain, random, 0, 20 + round % 5 * 40);
    const surface::TriangleMesh mesh{bad.points, bad.surface()};
    const OneForms forms(mesh, {}, round % 2 == 0 ? Edges::own : Edges::intrinsic_delaunay);
    SlitMap cylinder = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
    SlitMap ring = cylinder;
    CircularMap disk = circular_map(forms, ring);
    flipped += distortion_on_cylinder(forms, cylinder).flipped.size() +
               distortion_on_ring(forms, ring).flipped.size() +
               distortion_in_plane(mesh, disk.position).flipped.size();
    CHECK(unflip_on_cylinder(forms, cylinder).left == 0);
    CHECK(unflip_on_ring(forms, ring).left == 0);
    CHECK(unflip_in_disk(mesh, disk).left == 0);
    CHECK(distortion_on_cylinder(forms, cylinder).flipped.empty());
    CHECK(distortion_on_ring(forms, ring).flipped.empty());
    CHECK(distortion_in_plane(mesh, disk.position).flipped.empty());
    // Loops still lie on their slits.
    CHECK(residuals(forms, cylinder).radius < 1e-12);
    CHECK(residuals(forms, ring).radius < 1e-12);
  }
  CHECK(flipped > 10);
}

/// A tube of this modulus with two cracks, standing in space.
CrackedCylinder tube(double height) {
  CylinderGrid grid;
  grid.sectors = 24;
  grid.rings = static_cast<int>(std::lround(height / full_turn * grid.sectors));
  grid.height = height;
  grid.cracks = {{grid.rings / 5, 2, 6}, {grid.rings * 3 / 4, 9, 6}};
  return slit_prism(grid);
}

TEST_CASE("Circular domains of tubes flip no triangle, however long the tubes are") {
  for (const double height : {10.0, 50.0, 200.0, 650.0}) {
    const CrackedCylinder domain = tube(height);
    const OneForms forms(domain.mesh);
    const SlitMap ring = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
    CHECK(ring.modulus == Approx(height).epsilon(3e-3));
    const CircularMap map = circular_map(forms, ring);
    REQUIRE(map.domain.found);
    const Distortion found = distortion_in_disk(domain.mesh, map);
    CHECK(found.flipped.empty());
    // That of straight edges between 24 vertices a turn, and of cracks that these resolve barely.
    CHECK(found.mean_quasi_conformal < 1.25);
    // Both cracks shorten the ring by what their arcs do alone: 2 log cos(a / 4) for an angle a, as they are
    // far apart.
    CHECK(std::log(map.domain.circles[1].radius) ==
          Approx(-ring.modulus + 4 * std::log(std::cos(full_turn / 16))).margin(0.1));
  }
}

TEST_CASE("Rings that doubles cannot hold are refused") {
  const CrackedCylinder domain = tube(720);
  const OneForms forms(domain.mesh);
  const SlitMap map = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
  CHECK_THROWS_AS(circular_map(forms, map), InputError);
  CHECK(distortion_on_cylinder(forms, map).mean_quasi_conformal < 1.2);
}

TEST_CASE("The search for a better drawing never returns a worse one") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 2), moebius);
  const OneForms forms(domain.mesh);
  const CircularMap good = circular_map(forms, slit_map(forms, 0, 1));
  Random random(11);
  for (int round = 0; round < 10; ++round) {
    // Too much disorder to be put right.
    CircularMap map = good;
    const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), domain.mesh.surface);
    for (std::size_t v = 0; v < map.position.size(); ++v)
      if (loop[v] < 0) map.position[v] += std::polar(0.08 * round, full_turn * random.uniform());
    const std::size_t before = distortion_in_disk(domain.mesh, map).flipped.size();
    unflip_in_disk(domain.mesh, map);
    CHECK(distortion_in_disk(domain.mesh, map).flipped.size() <= before);
  }
}

TEST_CASE("A part in disorder is unfolded, in the disk, on the ring and on the cylinder") {
  // Where one vertex after the other is moved, many of these end with triangles that block each other.
  Random random(21);
  std::size_t disturbed = 0;
  for (int round = 0; round < 20; ++round) {
    const CrackedCylinder domain = slit_ring(refined(two_slits(), 1 + round % 2), moebius);
    const TriangleList plain{domain.mesh.surface.triangles(), domain.mesh.points,
                             domain.mesh.surface.vertex_count()};
    const TriangleList bad = retriangulated(plain, random, 0, 100);
    const surface::TriangleMesh mesh{bad.points, bad.surface()};
    const surface::Surface& faces = mesh.surface;
    const OneForms forms(mesh);
    const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), faces);
    const SlitMap slits = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
    const CircularMap circles = circular_map(forms, slits);
    // All vertices near one take random places there; those of loops slide.
    const int center = random.below(faces.vertex_count());
    constexpr double reach = 0.8;
    CircularMap disk = circles;
    for (std::size_t v = 0; v < disk.position.size(); ++v)
      if (loop[v] < 0 && std::abs(circles.position[v] - circles.position[center]) < reach)
        disk.position[v] = circles.position[center] +
                           std::polar(reach * std::sqrt(random.uniform()), full_turn * random.uniform());
    SlitMap cylinder = slits;
    std::map<int, double> shift; // of angles
    for (int v = 0; v < faces.vertex_count(); ++v)
      if (std::abs(slits.log_radius[v] - slits.log_radius[center]) < reach &&
          std::abs(std::remainder(slits.angle[v] - slits.angle[center], full_turn)) < reach)
        shift[v] = reach * (2 * random.uniform() - 1);
    for (int s = 0; s < faces.side_count(); ++s)
      for (const auto& [v, angle] : shift) {
        if (faces.to(surface::Side(s)) == v) cylinder.form.imaginary[s] += angle;
        if (faces.from(surface::Side(s)) == v) cylinder.form.imaginary[s] -= angle;
      }
    for (const auto& [v, angle] : shift) cylinder.angle[v] += angle;
    SlitMap ring = cylinder;
    INFO("round " << round);
    disturbed += distortion_in_disk(mesh, disk).flipped.size() +
                 distortion_on_cylinder(forms, cylinder).flipped.size();
    unflip_in_disk(mesh, disk);
    unflip_on_cylinder(forms, cylinder);
    unflip_on_ring(forms, ring);
    CHECK(distortion_in_disk(mesh, disk).flipped.empty());
    CHECK(distortion_on_cylinder(forms, cylinder).flipped.empty());
    CHECK(distortion_on_ring(forms, ring).flipped.empty());
    CHECK(residuals(forms, cylinder).radius < 1e-12); // loops still lie on their slits
  }
  CHECK(disturbed > 300);
}

TEST_CASE("A vertex of one triangle is put between its neighbors on the circle") {
  // A polygon whose corner 0 is cut off by an ear; the ear's tip has slid past a neighbor.
  constexpr int corners = 12;
  TriangleList plain{{}, {}, corners + 1};
  for (int k = 0; k < corners; ++k) {
    const Complex at = std::polar(1.0, full_turn * k / corners);
    plain.points.push_back({at.real(), at.imag(), 0});
    if (k > 0 && k + 1 < corners) plain.triangles.push_back({k, k + 1, corners});
  }
  plain.points.push_back({0, 0, 0});
  plain.triangles.push_back({corners - 1, 1, corners});
  plain.triangles.push_back({0, 1, corners - 1});
  const surface::TriangleMesh mesh{plain.points, plain.surface()};
  CircularMap map = disk_map(mesh, corners);
  REQUIRE(distortion_in_disk(mesh, map).flipped.empty());

  map.position[0] = map.position[1] * std::polar(1.0, 0.01);
  REQUIRE(distortion_in_disk(mesh, map).flipped == std::vector<int>{corners - 1});
  const std::vector<Complex> before = map.position;
  unflip_in_disk(mesh, map);
  CHECK(distortion_in_disk(mesh, map).flipped.empty());
  CHECK(std::abs(map.position[0]) == Approx(1));
  // It went back itself; its neighbors need not make room.
  CHECK(std::arg(before[1] / map.position[0]) > 0.1);
  CHECK(std::arg(map.position[0] / before[corners - 1]) > 0.1);
}

TEST_CASE("Fingerprints are those of the surface, not of its triangles") {
  const surface::TriangleMesh mesh = slit_ring(two_slits(), moebius).mesh;
  Random random(5);
  const TriangleList plain{mesh.surface.triangles(), mesh.points, mesh.surface.vertex_count()};
  const Fingerprint one = fingerprint(mesh, {}, 30'000);
  REQUIRE(one.found);
  REQUIRE(one.triangles.size() == 4);
  REQUIRE(one.ring.size() == 7);
  REQUIRE(one.disk.size() == 7);
  CHECK(distance(one, one) < 1e-15);
  for (int round = 0; round < 2; ++round) {
    // Splits only: flips would change the surface.
    const TriangleList other = relabelled(retriangulated(plain, random, 0, 60), random);
    const Fingerprint two = fingerprint({other.points, other.surface()}, {}, 30'000);
    for (std::size_t k = 0; k < one.ring.size(); ++k) {
      // Errors are estimates: three of them are allowed.
      const double ring = 3 * (one.ring_error[k] + two.ring_error[k]) + 1e-12;
      CHECK(std::abs(std::remainder(one.ring[k] - two.ring[k], full_turn)) < ring);
      CHECK(std::abs(one.disk[k] - two.disk[k]) < 3 * (one.disk_error[k] + two.disk_error[k]) + 1e-12);
      CHECK(std::abs(one.disk[k] - two.disk[k]) < 1e-3);
    }
    CHECK(distance(one, two) < 1e-3);
  }
}

TEST_CASE("Inversion in space changes the lengths of loops, but no fingerprint") {
  const surface::TriangleMesh mesh = slit_ring(refined(two_slits(), 4), moebius).mesh;
  const Fingerprint one = fingerprint(mesh, {}, 40'000);
  Random random(17);
  for (int round = 0; round < 3; ++round) {
    surface::TriangleMesh inverted = mesh;
    const std::array<double, 3> pole{random.uniform() - 0.5, random.uniform() - 0.5, 0.7};
    for (auto& p : inverted.points) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] -= pole[k];
        square += p[k] * p[k];
      }
      for (double& x : p) x /= square;
    }
    const TriangleList plain{inverted.surface.triangles(), inverted.points, inverted.surface.vertex_count()};
    const TriangleList other = relabelled(plain, random);
    // Triangles stay flat, so this is the same surface up to the square of their size.
    const Fingerprint two = fingerprint({other.points, other.surface()}, {}, 40'000);
    CHECK(distance(one, two) < 1e-3);
    CHECK(distance(two, one) < 1e-3);
  }
}

/// Disjoint circles in a ring.
std::vector<Circle> some_circles(std::size_t count, Random& random) {
  std::vector<Circle> result{{0, 1, 0}, {0, 0.1, 0}};
  while (result.size() < count) {
    const Circle c{std::polar(0.15 + 0.8 * random.uniform(), full_turn * random.uniform()),
                   0.01 + 0.05 * random.uniform(), 0};
    const auto meets = [&](const Circle& other) {
      return std::abs(c.center - other.center) < c.radius + other.radius + 0.01;
    };
    if (std::abs(c.center) + c.radius < 0.99 && std::none_of(result.begin() + 1, result.end(), meets))
      result.push_back(c);
  }
  return result;
}

TEST_CASE(
    "Circles are found again after a Moebius map and a new numbering, and mirrored if that is allowed") {
  Random random(23);
  for (const std::size_t count : {2, 3, 4, 7, 20}) {
    const std::vector<Circle> a = some_circles(count, random);
    for (const bool mirrored : {false, true}) {
      const auto outer = static_cast<std::size_t>(random.below(static_cast<int>(count)));
      const std::size_t inner = (outer + 1) % count;
      std::vector<Circle> b = normalised(a, outer, inner);
      std::vector<int> number{static_cast<int>(outer), static_cast<int>(inner)};
      for (std::size_t k = 0; k < count; ++k)
        if (k != outer && k != inner) number.push_back(static_cast<int>(k));
      const Complex turn = std::polar(1.0, full_turn * random.uniform());
      for (Circle& c : b) c.center = turn * (mirrored ? std::conj(c.center) : c.center);
      MatchingOptions options;
      options.with_mirror_images = true;
      const std::vector<Matching> found = best_matchings(a, b, options);
      CHECK(found.front().distance < 1e-10);
      if (count < 4) continue; // symmetric in themselves
      CHECK(found.front().mirrored == mirrored);
      for (std::size_t k = 0; k < count; ++k)
        CHECK(number[static_cast<std::size_t>(found.front().to[k])] == static_cast<int>(k));
      CHECK((best_matchings(a, b).front().distance < 1e-10) == !mirrored);
      // Others are clearly worse.
      CHECK(found.at(1).distance > 1e-3);
    }
  }
}

TEST_CASE("Three circles can be exchanged, and no fewer or more are matched") {
  Random random(3);
  CHECK_THROWS_AS(best_matchings(some_circles(3, random), some_circles(4, random)), InputError);
  // A pair of pants of three equal legs is symmetric under all six permutations, three of them mirrored.
  const double root = std::sqrt(3.0);
  const std::vector<Circle> pants =
      normalised({{0, 1, 0}, {{1 / root - 0.5 + 0.0, 0.2}, 0.15, 0}, {{-0.3, 0.1}, 0.2, 0}}, 0, 1);
  MatchingOptions options;
  options.with_mirror_images = true;
  const std::vector<Matching> found = best_matchings(pants, pants, options);
  // Any three circles have the mirror image that fixes each.
  CHECK(found.at(0).distance < 1e-12);
  CHECK(found.at(1).distance < 1e-12);
  CHECK(found.at(0).to == found.at(1).to);
}

TEST_CASE("Fingerprints are near the exact numbers, whatever the position in space") {
  const CrackedCylinder bent = slit_ring(refined(two_slits(), 4), moebius);
  surface::TriangleMesh turned = bent.mesh;
  for (auto& [x, y, z] : turned.points) std::tie(x, y, z) = std::tuple{5 - 3 * z, 3 * x, -3 * y};
  const auto loops = surface::boundary_loops(turned);
  const LoopPair pair{surface::loop_through(loops, turned.surface, bent.outer_vertex),
                      surface::loop_through(loops, turned.surface, bent.inner_vertex)};
  const Fingerprint found = fingerprint(turned, pair, 40'000);
  const CircularDomain exact = circular_domain(exact_ring());
  // The outer polygon of 64 sides has an area 0.2 percent smaller than its circle.
  CHECK(found.disk[0] == Approx(exact.circles[1].radius).margin(1e-3));
  std::vector<double> radii{found.disk[3], found.disk[6]};
  std::vector<double> known{exact.circles[2].radius, exact.circles[3].radius};
  std::sort(radii.begin(), radii.end());
  std::sort(known.begin(), known.end());
  CHECK(radii[0] == Approx(known[0]).margin(1e-3));
  CHECK(radii[1] == Approx(known[1]).margin(1e-3));
}

TEST_CASE("Fingerprints of surfaces with other holes are not compared") {
  const surface::TriangleMesh two = slit_ring(two_slits(), moebius).mesh;
  CylinderGrid grid = two_slits();
  grid.cracks.pop_back();
  const surface::TriangleMesh one = slit_ring(grid, moebius).mesh;
  CHECK_THROWS_AS(distance(fingerprint(two, {}, 0), fingerprint(one, {}, 0)), InputError);
  CHECK_THROWS_AS(fingerprint(two, LoopPair{0, 4}, 0), InputError);
  CHECK(std::isinf(fingerprint(two, {}, 0).disk_error[0]));
}

TEST_CASE("Turning the disk changes no distance, moving one circle changes it by as much") {
  Fingerprint a;
  a.disk = {0.2, 0.5, 0, 0.1, -0.3, 0.4, 0.05};
  Fingerprint b = a;
  const Complex turn = std::polar(1.0, 0.7);
  for (const std::size_t k : {1, 4}) {
    const Complex z = turn * Complex(a.disk[k], a.disk[k + 1]);
    b.disk[k] = z.real();
    b.disk[k + 1] = z.imag();
  }
  CHECK(distance(a, b) < 1e-15);
  b.disk[6] += 0.01;
  CHECK(distance(a, b) == Approx(0.01).epsilon(1e-9));
}

TEST_CASE("A drawing twice as large has the factor 2 everywhere") {
  const surface::TriangleMesh mesh = disk(3, 9, [](Complex z) { return z; });
  std::vector<Complex> doubled;
  for (const auto& p : mesh.points) doubled.emplace_back(2 * p[0], 2 * p[1]);
  for (const double factor : distortion_in_plane(mesh, doubled).log_factor)
    CHECK(factor == Approx(std::log(2.0)).epsilon(1e-12));
}

} // namespace
