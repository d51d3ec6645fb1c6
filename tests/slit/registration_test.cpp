// SPDX-License-Identifier: GPL-2.0-or-later
/// One surface laid onto another: the same one moved and triangulated otherwise, and surfaces that are bent.
#include "tetrarch/slit/registration.hpp"

#include "slit/domains.hpp"
#include "src/slit/flat_location.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/refine.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

using SpacePoint = std::array<double, 3>;

Complex other_moebius(Complex z) {
  return (z - Complex(0, 0.3)) / (1.0 + Complex(0, 0.3) * z);
}

/// The plane rolled onto a cylinder of radius 1, which changes no length.
template <class Bend>
auto rolled(const Bend& bend) {
  return [bend](const OnCylinder& p) {
    const Complex w = bend(std::polar(std::exp(-p.height), p.angle));
    return SpacePoint{std::sin(w.real()), w.imag(), std::cos(w.real())};
  };
}

double space_distance(const SpacePoint& p, const SpacePoint& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double greatest_distance(const std::vector<SpacePoint>& a, const std::vector<SpacePoint>& b) {
  REQUIRE(a.size() == b.size());
  double result = 0;
  for (std::size_t v = 0; v < a.size(); ++v) result = std::max(result, space_distance(a[v], b[v]));
  return result;
}

double mean_distance(const std::vector<SpacePoint>& a, const std::vector<SpacePoint>& b) {
  REQUIRE(a.size() == b.size());
  double result = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    result += space_distance(a[v], b[v]) / static_cast<double>(a.size());
  return result;
}

/// A half turn about the axis (1, 1, 0), then a shift.
SpacePoint moved(const SpacePoint& p) {
  return {p[1] + 3, p[0] - 1, -p[2] + 0.5};
}

std::vector<SpacePoint> moved(std::vector<SpacePoint> points) {
  for (SpacePoint& p : points) p = moved(p);
  return points;
}

SpacePoint carried(const RigidMotion& motion, const SpacePoint& p) {
  SpacePoint result = motion.shift;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += motion.rotation[i][j] * p[j];
  return result;
}

/// A mesh with its maps.
struct Mapped {
  Mapped(surface::TriangleMesh mesh, int outer, int inner)
      : forms(std::move(mesh)), map(circular_map(forms, slit_map(forms, outer, inner))) {}
  explicit Mapped(const CrackedCylinder& domain)
      : Mapped(domain.mesh, loop(domain, domain.outer_vertex), loop(domain, domain.inner_vertex)) {}
  static int loop(const CrackedCylinder& domain, int vertex) {
    return surface::loop_through(surface::boundary_loops(domain.mesh), domain.mesh.surface, vertex);
  }
  OneForms forms;
  CircularMap map;
};

Registration registered(const Mapped& a, const Mapped& b, const RegistrationOptions& options = {}) {
  return slit::registered(a.forms, a.map, b.forms.mesh(), b.map, options);
}

/// Of each loop of A the loop of B through the vertex of the same place.
std::vector<int> matching(const CrackedCylinder& a, const CrackedCylinder& b) {
  std::vector<std::array<int, 2>> vertices{{a.outer_vertex, b.outer_vertex},
                                           {a.inner_vertex, b.inner_vertex}};
  for (std::size_t k = 0; k < a.tips.size(); ++k) vertices.push_back({a.tips[k][0], b.tips[k][0]});
  std::vector<int> result(vertices.size());
  for (const auto& [v, w] : vertices) result[Mapped::loop(a, v)] = Mapped::loop(b, w);
  return result;
}

CylinderGrid no_slits() {
  CylinderGrid grid = two_slits();
  grid.cracks.clear();
  return grid;
}

TEST_CASE("A surface registered to itself stays where it is") {
  const Mapped a(slit_ring(refined(two_slits(), 3), moebius));
  const Registration found = registered(a, a);
  const auto& points = a.forms.mesh().points;
  CHECK(std::abs(found.turn) < 1e-12);
  CHECK(greatest_distance(found.resampled, points) < 1e-9);
  CHECK(greatest_distance(found.average, points) < 1e-9);
  CHECK(found.max_distance < 1e-9);
  CHECK(found.outside == 0);
  CHECK(found.flipped.empty());
  CHECK(found.flattened == 0);
  CHECK(found.mean_quasi_conformal == Approx(1).margin(1e-6));
  CHECK(found.max_quasi_conformal == Approx(1).margin(1e-5));
}

TEST_CASE("With two loops the turn is found in space, to half the digits") {
  const Mapped a(cracked_cylinder(refined(no_slits(), 3), rolled(moebius)));
  const Registration found = registered(a, a);
  CHECK(greatest_distance(found.resampled, a.forms.mesh().points) < 1e-6);
}

/// From a surface to the same one moved, with other triangles and names. Both are made finer, which keeps
/// them the same: mean distances from where vertices should come to lie.
double moved_error(const CylinderGrid& grid, int levels) {
  const CrackedCylinder domain = cracked_cylinder(grid, rolled(moebius));
  surface::TriangleMesh own = domain.mesh;
  Random random(7);
  // Splits only: flips would change the surface.
  const TriangleList split =
      retriangulated({own.surface.triangles(), moved(own.points), own.surface.vertex_count()}, random, 0,
                     own.surface.vertex_count() / 2);
  const TriangleList list = relabelled(split, random);
  surface::TriangleMesh other{list.points, list.surface()};
  for (int level = 0; level < levels; ++level) {
    own = surface::refined(own);
    other = surface::refined(other);
  }
  // Loops are numbered by length, which is the same.
  const Mapped a(own, Mapped::loop(domain, domain.outer_vertex), Mapped::loop(domain, domain.inner_vertex));
  const Mapped b(other, a.map.loop[0], a.map.loop[1]);
  const Registration found = registered(a, b);
  CHECK(found.flipped.empty());
  CHECK(found.outside == 0);
  // The motion takes everything back.
  const SpacePoint some{0.3, 0.2, 0.9};
  CHECK(space_distance(carried(found.motion, moved(some)), some) < 0.01);
  CHECK(greatest_distance(found.average, own.points) == Approx(found.max_distance / 2));
  return mean_distance(found.resampled, moved(own.points));
}

TEST_CASE("Moved and triangulated otherwise, a surface is found again, better on finer triangles") {
  for (const CylinderGrid& grid : {two_slits(), no_slits()}) {
    // Needles from random splits, and the tips of cracks, keep the order near 1.
    const double coarse = moved_error(grid, 0);
    const double fine = moved_error(grid, 2);
    CHECK(coarse < 0.01);
    CHECK(coarse > 2.5 * fine);
  }
}

struct KnownErrors {
  double mean = 0;
  double greatest = 0;
  double quasi_conformal = 0; ///< the mean excess over 1
};

/// From a bent ring in the plane to one in space that it can be mapped to conformally: places in the ring
/// correspond.
template <class Place>
KnownErrors known_errors(const CylinderGrid& grid, int times, const Place& place) {
  const CrackedCylinder a = slit_ring(refined(grid, times), moebius);
  const CrackedCylinder b = cracked_cylinder(refined(grid, times * 3 / 2), place);
  RegistrationOptions options;
  options.matching = matching(a, b);
  const Registration found = registered(Mapped(a), Mapped(b), options);
  CHECK(found.flipped.empty());
  CHECK(found.flattened == 0);
  std::vector<SpacePoint> known;
  for (const OnCylinder& p : a.at) known.push_back(place(p));
  return {mean_distance(found.resampled, known), greatest_distance(found.resampled, known),
          found.mean_quasi_conformal - 1};
}

TEST_CASE("Between surfaces that are conformally the same, points converge to those that correspond") {
  const KnownErrors coarse = known_errors(two_slits(), 2, rolled(other_moebius));
  const KnownErrors fine = known_errors(two_slits(), 8, rolled(other_moebius));
  // Order 1 on the tips of cracks, as for circular maps.
  CHECK(coarse.mean < 0.01);
  CHECK(coarse.mean > 8 * fine.mean);
  CHECK(coarse.greatest > 6 * fine.greatest);
  CHECK(coarse.quasi_conformal > 3.6 * fine.quasi_conformal);
}

TEST_CASE("With two loops, they do so where symmetry tells the turn") {
  // Both are symmetric under reflection of y; that is where the loops come closest.
  const KnownErrors coarse = known_errors(no_slits(), 2, rolled(moebius));
  const KnownErrors fine = known_errors(no_slits(), 8, rolled(moebius));
  CHECK(coarse.mean < 0.005);
  CHECK(coarse.mean > 11 * fine.mean);
  CHECK(coarse.greatest > 11 * fine.greatest);
  CHECK(coarse.quasi_conformal > 3.6 * fine.quasi_conformal);
}

TEST_CASE("Loops go to the loops that they are matched to") {
  const CrackedCylinder domain = slit_ring(refined(two_slits(), 3), moebius);
  const Mapped a(domain);
  RegistrationOptions options;
  options.matching = {0, 1, 2, 3};
  std::swap(options.matching[a.map.loop[2]], options.matching[a.map.loop[3]]);
  const std::vector<int> loop = surface::loops_of_vertices(a.forms.loops(), domain.mesh.surface);
  for (const bool unflip : {false, true}) {
    options.unflip = unflip;
    const Registration found = registered(a, a, options);
    // Two holes that change places wring the surface between them.
    CHECK(found.flipped.empty() == unflip);
    CHECK((found.moved > 0) == unflip);
    CHECK(found.outside > 0);
    for (std::size_t v = 0; v < loop.size(); ++v) {
      if (loop[v] < 0) continue;
      const MeshPoint& at = found.at[v];
      for (std::size_t c = 0; c < 3; ++c) {
        if (at.weight[c] <= 0) continue;
        CHECK(loop[domain.mesh.surface.corners(at.triangle)[c]] == options.matching[loop[v]]);
      }
    }
  }
}

TEST_CASE("Points of the plane are found in the triangle they are deepest in, or nearest to") {
  // The unit square by its diagonal from 0, and a triangle turned over on top of it, which is left out.
  const TriangleList list{{{0, 1, 2}, {0, 2, 3}, {2, 1, 4}}, {}, 5};
  const std::vector<Complex> position{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  const auto found = flat_points(list.surface(), position, {{0.7, 0.5}, {0.2, 0.9}, {3, 0.25}, {-3, -4}});
  CHECK(found[0].at.triangle == 0);
  CHECK(found[1].at.triangle == 1);
  CHECK(found[2].at.triangle == 0);
  // By hand: 0.2 (1, 0) + 0.5 (1, 1), 0.2 (1, 1) + 0.7 (0, 1), and (1, 0.25) on the side x = 1.
  const std::vector<std::array<double, 3>> weight{{0.3, 0.2, 0.5}, {0.1, 0.2, 0.7}, {0, 0.75, 0.25}};
  for (std::size_t k = 0; k < weight.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) CHECK(found[k].at.weight[c] == Approx(weight[k][c]).margin(1e-15));
  CHECK(found[0].outside + found[1].outside == 0);
  CHECK(found[2].outside == Approx(2));
  CHECK(found[3].outside == Approx(5));
  const std::vector<Complex> turned{{0, 0}, {0, 1}, {1, 1}, {1, 0}, {2, 2}};
  CHECK_THROWS_AS(flat_points({4, {{0, 1, 2}, {0, 2, 3}}}, turned, {0}), PreconditionError);
}

TEST_CASE("Unless both are to be aligned, they are compared where they are") {
  const Mapped a(slit_ring(two_slits(), moebius));
  surface::TriangleMesh shifted = a.forms.mesh();
  for (SpacePoint& p : shifted.points) p[2] += 2;
  const Mapped b(shifted, a.map.loop[0], a.map.loop[1]);
  CHECK(registered(a, b).max_distance < 1e-9);
  RegistrationOptions options;
  options.aligned = false;
  const Registration found = registered(a, b, options);
  CHECK(found.mean_distance == Approx(2));
  CHECK(found.average[0][2] == Approx(1));
  CHECK(carried(found.motion, {1, 2, 3}) == SpacePoint{1, 2, 3});
}

TEST_CASE("Registration refuses other numbers of loops, and matchings that are not one to one") {
  const Mapped four(slit_ring(two_slits(), moebius));
  const Mapped two(slit_ring(no_slits(), moebius));
  CHECK(error_of([&] { registered(four, two); }) ==
        "surfaces with 4 and 2 boundary loops cannot be registered");
  RegistrationOptions options;
  for (const std::vector<int>& matching : {std::vector{0, 1, 2}, {0, 1, 2, 2}, {0, 1, 2, 4}}) {
    options.matching = matching;
    CHECK(error_of([&] { registered(four, four, options); }) ==
          "a matching must name each of the 4 boundary loops of the other surface once");
  }
  options.matching = {0, 1, 2, 3};
  std::swap(options.matching[four.map.loop[0]], options.matching[four.map.loop[1]]);
  CHECK_THROWS_AS(registered(four, four, options), PreconditionError);
}

} // namespace
