// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/slit_map.hpp"

#include "slit/domains.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/surface/refine.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;
using surface::Side;

Complex identity(Complex z) {
  return z;
}
/// Maps the unit disk to itself.
Complex slit_moebius(Complex z) {
  return (z + 0.4) / (1.0 + 0.4 * z);
}
/// Conformal where |z|^2 > 0.08, so on the ring from exp(-1) = 0.37 to 1: its circles become ellipses.
Complex joukowski(Complex z) {
  return z + 0.08 / z;
}

/// With the loops that the domain was made from.
SlitMap map_of(const OneForms& forms, const CrackedCylinder& domain) {
  return slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
}

TEST_CASE("On a prism with slits the map is exact") {
  CylinderGrid grid = two_slits();
  grid.unrest = 0;
  const CrackedCylinder prism = slit_prism(grid);
  const OneForms forms(prism.mesh);
  const SlitMap map = map_of(forms, prism);
  CHECK(map.modulus == Approx(1).epsilon(1e-13));
  CHECK(map.modulus_bound == Approx(1).epsilon(1e-13));
  // Two quarter turns, of 16 sectors; the second one starts (9 - 2) / 16 of a turn or the other way round.
  REQUIRE(map.slits.size() == 2);
  const bool lower_first = map.slits[0].radius > map.slits[1].radius;
  const double between = full_turn * (lower_first ? 7 : 9) / 16;
  CHECK(map.slits[0].radius == Approx(std::exp(lower_first ? -0.25 : -0.5)).epsilon(1e-13));
  CHECK(map.slits[1].radius == Approx(std::exp(lower_first ? -0.5 : -0.25)).epsilon(1e-13));
  const auto turned = [&](int from, int to) { return map.angle[to] - map.angle[from]; };
  const Slit& first = map.slits[0];
  const Slit& second = map.slits[1];
  CHECK(turned(first.start_vertex, second.start_vertex) == Approx(between).epsilon(1e-13));
  // Ends are found as for vertices in general position. Here two lie on them, which four edges cannot know.
  const double slack = full_turn / 4 / 4 / 3;
  CHECK(first.start == 0);
  CHECK(first.end == Approx(full_turn / 4).margin(slack));
  CHECK(second.start == Approx(between).margin(slack));
  CHECK(second.end == Approx(between + full_turn / 4).margin(slack));
  for (const Slit& s : map.slits) CHECK(s.turns == 2);
  const Errors e = errors(prism, 1);
  CHECK(e.height < 1e-13);
  CHECK(e.angle < 1e-12);
  CHECK(e.quasi_conformal < 1e-12);
  CHECK(e.angles < 1e-12);
  CHECK(e.holomorphic < 1e-7); // a square root of rounding errors
  CHECK(distortion_on_cylinder(forms, map).flipped.empty());
}

/// From a mesh to one four times as fine, linear elements make second-order errors 16 times smaller and
/// first-order ones 4 times; 11 and 3.6 are orders 1.73 and 0.92.
struct Refinement {
  Errors coarse;
  Errors fine;
  void check_second(double Errors::*error) const { CHECK(coarse.*error > 11 * (fine.*error)); }
  void check_first(double Errors::*error) const { CHECK(coarse.*error > 3.6 * (fine.*error)); }
  void check_distortion() const {
    check_first(&Errors::quasi_conformal);
    check_first(&Errors::angles);
    check_first(&Errors::holomorphic);
    check_second(&Errors::bracket);
  }
};

TEST_CASE(
    "Maps converge to the logarithm of the inverse of what bent the ring, at the order of linear elements") {
  CylinderGrid annulus;
  annulus.sectors = 16;
  for (const CylinderGrid& grid : {annulus, two_slits()})
    for (Complex (*bend)(Complex) : {identity, slit_moebius, joukowski}) {
      INFO(grid.cracks.size() << " slits, image of 0.5 " << bend(0.5));
      const Refinement both{errors(slit_ring(refined(grid, 4), bend), 1),
                            errors(slit_ring(refined(grid, 16), bend), 1)};
      both.check_distortion();
      both.check_second(&Errors::modulus);
      both.check_second(&Errors::height);
      both.check_second(&Errors::angle);
      // Of the second order even 0.02 on the coarse mesh would be far off.
      CHECK(both.fine.height < 3e-4);
      CHECK(both.fine.angle < 6e-4);
      if (grid.cracks.empty()) continue;
      both.check_second(&Errors::slits);
      both.check_second(&Errors::wedges);
    }
}

TEST_CASE("Eccentric circles of radii R, r at distance d have modulus arccosh((R^2 + r^2 - d^2) / (2Rr))") {
  CylinderGrid grid;
  grid.sectors = 16;
  const double r = 0.3;
  const double d = 0.4;
  const auto eccentric = [&](int times) {
    return cracked_cylinder(refined(grid, times), [&](const OnCylinder& p) {
      const double radius = 1 - (1 - r) * p.height;
      return std::array<double, 3>{d * p.height + radius * std::cos(p.angle), radius * std::sin(p.angle), 0};
    });
  };
  const double modulus = std::acosh((1 + r * r - d * d) / (2 * r));
  const Refinement both{errors(eccentric(4), modulus), errors(eccentric(16), modulus)};
  both.check_distortion();
  both.check_second(&Errors::modulus);
  CHECK(both.fine.modulus < 2e-4);
}

/// The ring exp(-1) < |z| < 1 without the arc |z| = exp(-1/2), |arg z| < 1, which is opened to the unit
/// circle: q takes it to the positive axis, sqrt(-q) to the imaginary one. Angles and heights are spaced so
/// that vertices do not lie thinner at the ends of the arc.
struct OpenedSlit {
  static constexpr double half_width = 1;
  static OnCylinder true_place(OnCylinder p) {
    const double pi = std::numbers::pi;
    p.angle = p.angle <= pi ? -half_width * std::cos(p.angle) : pi + (pi - half_width) * std::cos(p.angle);
    const double beyond = p.height - 0.5;
    p.height = 0.5 + 2 * beyond * std::abs(beyond);
    return p;
  }
  static std::array<double, 3> place(const OnCylinder& grid_place) {
    const OnCylinder p = true_place(grid_place);
    const double radius = std::exp(-0.5);
    const Complex start = std::polar(radius, -half_width);
    const Complex end = std::polar(radius, half_width);
    const Complex z = std::polar(std::exp(-p.height), p.angle);
    const Complex over = (z - start) * (radius - end);
    const Complex under = (z - end) * (radius - start);
    if (std::abs(under) < 1e-14) return {1, 0, 0};
    if (std::abs(over) < 1e-14) return {-1, 0, 0};
    const Complex q = over / under;
    const Complex root = p.bank == 0 ? std::sqrt(-q) : Complex(0, -p.bank * std::sqrt(q.real()));
    const Complex w = (root - 1.0) / (root + 1.0);
    return {w.real(), w.imag(), 0};
  }
  static CrackedCylinder domain(int times) {
    CylinderGrid grid;
    grid.sectors = 16;
    grid.cracks = {{2, 0, 8}};
    return cracked_cylinder(refined(grid, times), place);
  }
};

TEST_CASE("A slit that was opened to a circle is found again, with its ends") {
  const Refinement both{errors(OpenedSlit::domain(4), 1, OpenedSlit::true_place),
                        errors(OpenedSlit::domain(16), 1, OpenedSlit::true_place)};
  both.check_distortion();
  both.check_second(&Errors::modulus);
  both.check_second(&Errors::slits);
  CHECK(both.fine.slits < 2e-4);
}

TEST_CASE(
    "The modulus of a surface with flat triangles lies between its bounds, which close in as it is split") {
  for (const auto& domain :
       {slit_ring(two_slits(), slit_moebius), OpenedSlit::domain(1), slit_prism(two_slits())}) {
    surface::TriangleMesh surface = domain.mesh;
    double below = 0;
    double above = 1e9;
    for (int level = 0; level < 4; ++level) {
      const OneForms forms(surface);
      // Old vertices keep their numbers.
      const SlitMap map = map_of(forms, domain);
      CHECK(below <= map.modulus + 1e-12);
      CHECK(map.modulus <= map.modulus_bound + 1e-12);
      CHECK(map.modulus_bound <= above + 1e-12);
      below = map.modulus;
      above = map.modulus_bound;
      surface = surface::refined(surface);
    }
    CHECK(above - below < 0.01);
  }
}

TEST_CASE("The squared distance from holomorphic is 2 pi times what is between the bounds") {
  const OneForms forms(slit_ring(two_slits(), slit_moebius).mesh);
  for (int outer = 0; outer < 4; ++outer)
    for (int inner = 0; inner < 4; ++inner) {
      if (outer == inner) continue;
      const SlitMap map = slit_map(forms, outer, inner);
      CHECK(std::pow(distance_from_holomorphic(forms, map.form), 2) ==
            Approx(full_turn * (map.modulus_bound - map.modulus)).epsilon(1e-10));
    }
}

TEST_CASE("For every choice of loops periods, fluxes and radii are exact, and every slit turns back twice") {
  for (const auto& domain : {slit_ring(refined(two_slits(), 2), joukowski), OpenedSlit::domain(4)}) {
    const OneForms forms(domain.mesh);
    for (int outer = 0; outer < forms.loop_count(); ++outer)
      for (int inner = 0; inner < forms.loop_count(); ++inner) {
        if (outer == inner) continue;
        const SlitMap map = slit_map(forms, outer, inner);
        const Residuals r = residuals(forms, map);
        CHECK(r.period < 1e-12);
        CHECK(r.flux < 1e-12);
        CHECK(r.harmonic < 1e-12);
        CHECK(r.radius < 1e-14);
        CHECK(static_cast<int>(map.slits.size()) == forms.loop_count() - 2);
        for (const Slit& s : map.slits) {
          CHECK(s.turns == 2);
          CHECK(s.end > s.start);
          CHECK(s.end - s.start < full_turn);
          CHECK(s.radius < 1);
          CHECK(s.radius > std::exp(-map.modulus));
        }
      }
  }
}

TEST_CASE("With outer and inner loop exchanged, the map is turned inside out") {
  const OneForms forms(slit_ring(two_slits(), slit_moebius).mesh);
  for (int outer = 0; outer < 4; ++outer)
    for (int inner = 0; inner < outer; ++inner) {
      const SlitMap map = slit_map(forms, outer, inner);
      const SlitMap other = slit_map(forms, inner, outer);
      CHECK(other.modulus == Approx(map.modulus).epsilon(1e-13));
      for (std::size_t k = 0; k < map.slits.size(); ++k) {
        // z becomes exp(-modulus) / z, up to a rotation: start and end change places.
        const Slit& a = map.slits[k];
        const Slit& b = other.slits[k];
        CHECK(a.loop == b.loop);
        CHECK(b.radius == Approx(std::exp(-map.modulus) / a.radius).epsilon(1e-12));
        CHECK(b.start_vertex == a.end_vertex);
        CHECK(b.end_vertex == a.start_vertex);
        CHECK(b.end - b.start == Approx(a.end - a.start).epsilon(1e-12));
      }
      const double shift = map.angle[0] + other.angle[0];
      for (std::size_t v = 0; v < map.angle.size(); ++v) {
        CHECK(other.log_radius[v] == Approx(-map.modulus - map.log_radius[v]).margin(1e-12));
        CHECK(std::abs(angle_between(shift, map.angle[v] + other.angle[v])) < 1e-11);
      }
    }
}

/// Green's function is symmetric.
TEST_CASE("Seen from one outer loop, loop j is as high when loop k is inner as loop k is when loop j is") {
  const OneForms forms(slit_ring(two_slits(), joukowski).mesh);
  const auto radius = [&](int outer, int inner, int loop) {
    const SlitMap map = slit_map(forms, outer, inner);
    const auto slit =
        std::find_if(map.slits.begin(), map.slits.end(), [&](const Slit& s) { return s.loop == loop; });
    return slit->radius;
  };
  for (int outer = 0; outer < 4; ++outer)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < j; ++k)
        if (j != outer && k != outer)
          CHECK(radius(outer, j, k) == Approx(radius(outer, k, j)).epsilon(1e-12));
}

OneForms renamed(const surface::TriangleMesh& mesh, Random& random) {
  const TriangleList list =
      relabelled(TriangleList{mesh.surface.triangles(), mesh.points, mesh.surface.vertex_count()}, random);
  format::Soup soup;
  soup.points = list.points;
  soup.triangles = list.triangles;
  return OneForms(doctor::build_surface(std::move(soup)));
}

TEST_CASE("Names of vertices and triangles change nothing") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 2), slit_moebius);
  const OneForms forms(domain.mesh);
  const SlitMap map = slit_map(forms, 0, 1);
  Random random(6);
  for (int round = 0; round < 3; ++round) {
    const SlitMap other = slit_map(renamed(domain.mesh, random), 0, 1);
    CHECK(other.modulus == Approx(map.modulus).epsilon(1e-12));
    CHECK(other.modulus_bound == Approx(map.modulus_bound).epsilon(1e-12));
    for (std::size_t k = 0; k < map.slits.size(); ++k) {
      CHECK(other.slits[k].radius == Approx(map.slits[k].radius).epsilon(1e-12));
      CHECK(std::abs(angle_between(other.slits[k].start, map.slits[k].start)) < 1e-11);
      CHECK(std::abs(angle_between(other.slits[k].end, map.slits[k].end)) < 1e-11);
    }
  }
}

TEST_CASE("A slit turns back twice wherever its loop begins, and angles stay in [0, 2 pi)") {
  CylinderGrid grid = two_slits();
  grid.cracks = {{1, 2, 2}, {3, 9, 2}}; // four sides each, so that loops often begin at an end
  grid.unrest = 0;
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    const SlitMap map = slit_map(renamed(slit_prism(grid).mesh, random), 0, 1);
    for (const Slit& s : map.slits) CHECK(s.turns == 2);
    for (const double angle : map.angle) {
      CHECK(angle >= 0);
      CHECK(angle < full_turn);
    }
  }
}

TEST_CASE("The unrolled cylinder is torn along the seam only, by whole turns, and has area 2 pi times the "
          "modulus") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 2), slit_moebius);
  const OneForms forms(domain.mesh);
  const auto& surface = forms.mesh().surface;
  const SlitMap map = map_of(forms, domain);
  const ParallelDomain unrolled = parallel_domain(surface, map);
  std::set<int> seam;
  for (const Side s : unrolled.seam) seam.insert(s.value);
  CHECK_FALSE(seam.empty());
  const auto place = [&](Side s, int corner) { return unrolled.corners[s.triangle()][corner]; };
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    const Side m = surface.mate(s);
    if (!m.exists()) continue;
    CHECK(seam.count(k) == seam.count(m.value));
    const auto here = place(s, s.next().corner());
    const auto there = place(m, m.previous().corner());
    CHECK(here[1] == there[1]);
    CHECK(std::abs(here[0] - there[0]) == Approx(seam.count(k) * full_turn).margin(1e-12));
  }
  double area = 0;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const auto& p = unrolled.corners[t];
    area += ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])) / 2;
    const double centroid = (p[0][0] + p[1][0] + p[2][0]) / 3;
    CHECK(centroid >= 0);
    CHECK(centroid < full_turn);
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      CHECK(std::abs(angle_between(map.angle[v], p[c][0])) < 1e-12);
      CHECK(p[c][1] == -map.log_radius[v]);
    }
  }
  CHECK(area == Approx(full_turn * map.modulus).epsilon(1e-12));
}

TEST_CASE("Places on the ring and on the cylinder tell the same") {
  const CrackedCylinder domain = slit_ring(two_slits(), joukowski);
  const OneForms forms(domain.mesh);
  const SlitMap map = map_of(forms, domain);
  for (int v = 0; v < static_cast<int>(map.angle.size()); ++v) {
    const auto p = map.cylindric(v);
    const Complex z = map.concentric(v);
    CHECK(std::abs(z) == Approx(std::exp(-p[2])).epsilon(1e-14));
    CHECK(std::abs(z - std::exp(-p[2]) * Complex(p[0], p[1])) < 1e-15);
  }
  CHECK(std::abs(map.concentric(domain.outer_vertex)) == Approx(1).epsilon(1e-14));
  CHECK(std::abs(map.concentric(domain.inner_vertex)) == Approx(std::exp(-map.modulus)).epsilon(1e-14));
}

TEST_CASE("Loops that are not there, and the same loop twice, are refused") {
  const OneForms forms(slit_ring(two_slits(), identity).mesh);
  CHECK_THROWS_WITH(slit_map(forms, 0, 4), Catch::Contains("no loop 4, only 0 to 3"));
  CHECK_THROWS_AS(slit_map(forms, -1, 0), InputError);
  CHECK_THROWS_AS(slit_map(forms, 2, 2), InputError);
}

} // namespace
