// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/one_forms.hpp"

#include "slit/domains.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;
using surface::Side;

/// Two slits, bent so that nothing is symmetric: four loops on a flat mesh.
OneForms bent_forms(int times = 2) {
  return OneForms(
      slit_ring(refined(two_slits(), times), [](Complex z) { return (z + 0.4) / (1.0 + 0.4 * z); }).mesh);
}

surface::TriangleMesh mesh_of(const TriangleList& list) {
  format::Soup soup;
  soup.points = list.points;
  soup.triangles = list.triangles;
  return doctor::build_surface(std::move(soup));
}

/// d of a coordinate.
OneForm coordinate_form(const OneForms& forms, int axis) {
  std::vector<double> f;
  for (const auto& p : forms.mesh().points) f.push_back(p[axis]);
  return differential(forms.mesh().surface, f);
}

TEST_CASE("On a flat mesh dx ^ dy is the area, and dy is *dx against every closed form") {
  const OneForms forms = bent_forms();
  const auto& surface = forms.mesh().surface;
  const OneForm dx = coordinate_form(forms, 0);
  const OneForm dy = coordinate_form(forms, 1);
  double area = 0; // by the shoelace formula around each triangle
  for (const auto& [a, b, c] : surface.triangles()) {
    const auto& p = forms.mesh().points;
    area += ((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[c][0] - p[a][0]) * (p[b][1] - p[a][1])) / 2;
  }
  CHECK(wedge(surface, dx, dy) == Approx(area).epsilon(1e-13));
  CHECK(wedge(surface, dy, dx) == Approx(-area).epsilon(1e-13));
  CHECK(inner_product(forms.weight(), dx, dx) == Approx(area).epsilon(1e-12));
  for (int k = 1; k < forms.loop_count(); ++k)
    for (const OneForm& form : {forms.eta(k), forms.tau(k)})
      CHECK(wedge(surface, dy, form) == Approx(-inner_product(forms.weight(), dx, form)).margin(1e-12));
}

TEST_CASE("Potentials are 1 on their loop and 0 on the others, add up to 1 and are harmonic inside") {
  const OneForms forms = bent_forms();
  const auto& surface = forms.mesh().surface;
  REQUIRE(forms.loop_count() == 4);
  std::vector<int> on(forms.mesh().points.size(), -1);
  for (int k = 0; k < 4; ++k)
    for (const surface::SideEnd e : forms.loops()[k].sides) on[surface.vertex(e)] = k;
  for (int v = 0; v < surface.vertex_count(); ++v) {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      sum += forms.potential(k)[v];
      if (on[v] >= 0) CHECK(forms.potential(k)[v] == Approx(on[v] == k ? 1 : 0).margin(1e-15));
    }
    CHECK(sum == Approx(1).epsilon(1e-14));
  }
  for (int k = 0; k < 4; ++k) {
    const auto flux = surface::fluxes(surface, forms.weight(), forms.potential(k));
    for (int v = 0; v < surface.vertex_count(); ++v)
      if (on[v] < 0) CHECK(std::abs(flux[v]) < 1e-13);
  }
}

TEST_CASE("Values on the loops extend to harmonic functions, with any numbers inside") {
  const OneForms forms = bent_forms();
  const auto& surface = forms.mesh().surface;
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  // The mesh is flat, so coordinates are harmonic; and potentials are by definition.
  surface::LaplaceSolver::Columns known{{}, forms.potential(2)};
  for (const auto& p : forms.mesh().points) known[0].push_back(2 * p[0] - 3 * p[1] + 1);
  auto values = known;
  for (auto& column : values)
    for (std::size_t v = 0; v < column.size(); ++v)
      if (loop[v] < 0) column[v] = 1e9;
  const auto found = forms.extended(values);
  REQUIRE(found.size() == 2);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t v = 0; v < loop.size(); ++v) CHECK(found[k][v] == Approx(known[k][v]).margin(1e-12));
  CHECK_THROWS_AS(forms.extended(surface::LaplaceSolver::Columns{{1, 2}}), PreconditionError);
}

TEST_CASE("Fluxes are energies: symmetric, and what flows in flows out") {
  const OneForms forms = bent_forms();
  for (int j = 0; j < 4; ++j) {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      sum += forms.flux(j, k);
      CHECK(forms.flux(j, k) ==
            Approx(inner_product(forms.weight(), forms.eta(j), forms.eta(k))).margin(1e-12));
      if (j != k) CHECK(forms.flux(j, k) < 0);
    }
    CHECK(std::abs(sum) < 1e-12);
  }
}

TEST_CASE("tau(k) is closed, has period 1 around loop k and -1 around loop 0, and flows through no vertex") {
  const OneForms forms = bent_forms();
  const auto& surface = forms.mesh().surface;
  for (int k = 1; k < 4; ++k) {
    const OneForm tau = forms.tau(k);
    for (int j = 0; j < 4; ++j)
      CHECK(period(tau, forms.loops()[j]) == Approx(j == k ? 1 : j == 0 ? -1 : 0).margin(1e-13));
    std::vector<double> flow(forms.mesh().points.size(), 0.0);
    for (int s = 0; s < surface.side_count(); ++s) {
      const Side side(s);
      if (!surface.is_boundary(side)) CHECK(tau[s] == Approx(-tau[surface.mate(side).value]).margin(1e-15));
      CHECK(std::abs(tau[s] + tau[side.next().value] + tau[side.previous().value]) < 1e-14);
      flow[surface.to(side)] += forms.weight()[s] * tau[s];
      flow[surface.from(side)] -= forms.weight()[s] * tau[s];
    }
    // At boundary vertices too: that is the natural boundary condition.
    for (const double f : flow) CHECK(std::abs(f) < 1e-12);
  }
  for (const double value : forms.tau(0)) CHECK(value == 0);
}

TEST_CASE(
    "Stokes' theorem is exact: eta(i) ^ tau(j) has integral 1 for i = j and 0 else, eta(i) ^ eta(j) 0") {
  const OneForms forms = bent_forms();
  for (int i = 1; i < 4; ++i)
    for (int j = 1; j < 4; ++j) {
      CHECK(wedge(forms.mesh().surface, forms.eta(i), forms.tau(j)) == Approx(i == j ? 1 : 0).margin(1e-13));
      CHECK(wedge(forms.mesh().surface, forms.eta(i), forms.eta(j)) == Approx(0).margin(1e-12));
    }
}

TEST_CASE("The wedge system finds the fluxes as periods; its share of the etas is 0 for two loops") {
  const OneForms four = bent_forms();
  CylinderGrid grid;
  grid.sectors = 16;
  const OneForms two(slit_ring(grid, [](Complex z) { return z + 0.1 * z * z; }).mesh);
  REQUIRE(two.loop_count() == 2);
  for (const OneForms* forms : {&four, &two}) {
    const auto conjugates = conjugates_by_wedges(*forms);
    for (int k = 0; k < forms->loop_count(); ++k)
      for (int i = 1; i < forms->loop_count(); ++i) {
        CHECK(conjugates[k].tau[i] == Approx(forms->flux(i, k)).margin(1e-11));
        if (forms == &two) CHECK(std::abs(conjugates[k].eta[i]) < 1e-12);
      }
  }
}

TEST_CASE("A holomorphic one-form has the fluxes of its real part as periods of its imaginary part") {
  const OneForms forms = bent_forms();
  for (int k = 0; k < 4; ++k) {
    const HolomorphicOneForm form = holomorphic_one_form(forms, k);
    for (int j = 0; j < 4; ++j) {
      CHECK(period(form.real, forms.loops()[j]) == Approx(0).margin(1e-13));
      CHECK(period(form.imaginary, forms.loops()[j]) == Approx(forms.flux(j, k)).margin(1e-12));
    }
  }
  CHECK_THROWS_AS(holomorphic_one_form(forms, 4), PreconditionError);
  CHECK_THROWS_AS(holomorphic_one_form(forms, -1), PreconditionError);
}

TEST_CASE("Surfaces that have no slit maps are refused, with their type") {
  CHECK_THROWS_WITH(OneForms(mesh_of(torus_grid(5, 5))), Catch::Contains("torus"));
  CHECK_THROWS_WITH(OneForms(mesh_of(with_holes(torus_grid(9, 9), 2))), Catch::Contains("torus, 2 holes"));
  CHECK_THROWS_WITH(OneForms(mesh_of(icosphere(1))), Catch::Contains("two boundary loops"));
  CHECK_THROWS_WITH(OneForms(mesh_of(with_holes(icosphere(1), 1))), Catch::Contains("two boundary loops"));
  // Five triangles in a ring, each sharing two of its corners with the next: Moebius' strip.
  TriangleList strip;
  for (int k = 0; k < 5; ++k) {
    strip.triangles.push_back({k, (k + 1) % 5, (k + 2) % 5});
    strip.points.push_back({std::cos(1.3 * k), std::sin(1.3 * k), 0.1 * k * k});
  }
  CHECK_THROWS_WITH(OneForms(mesh_of(strip)), Catch::Contains("projective plane, 1 hole"));
}

TEST_CASE("A long job reports, and stops when asked to") {
  std::stop_source stop;
  stop.request_stop();
  const auto ring = slit_ring(two_slits(), [](Complex z) { return z; }).mesh;
  CHECK_THROWS_AS(OneForms(ring, Progress({}, stop.get_token())), Stopped);
}

TEST_CASE(
    "On the intrinsic Delaunay triangulation the bounds of the modulus are closer, and forms still closed") {
  Random random(4);
  const CrackedCylinder domain = slit_ring(two_slits(), [](Complex z) { return z; });
  const TriangleList plain{domain.mesh.surface.triangles(), domain.mesh.points,
                           domain.mesh.surface.vertex_count()};
  for (int round = 0; round < 5; ++round) {
    // Splits in the plane: the surface is the same, its triangles are bad.
    const TriangleList bad = retriangulated(plain, random, 0, 100);
    const surface::TriangleMesh mesh{bad.points, bad.surface()};
    const OneForms own(mesh);
    const OneForms intrinsic(mesh, {}, Edges::intrinsic_delaunay);
    const SlitMap a = slit_map(own, 0, 1);
    const SlitMap b = slit_map(intrinsic, 0, 1);
    CHECK(b.modulus > a.modulus);
    CHECK(b.modulus < b.modulus_bound);
    CHECK(b.modulus_bound < a.modulus_bound);
    const Residuals r = residuals(intrinsic, b);
    CHECK(std::max({r.period, r.flux, r.harmonic, r.radius}) < 1e-11);
    // Closed on the mesh's own triangles.
    for (int t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto& form = b.form.imaginary;
      CHECK(std::abs(form[3 * t] + form[3 * t + 1] + form[3 * t + 2]) < 1e-12);
    }
  }
}

} // namespace
