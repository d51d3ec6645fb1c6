// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quality.hpp"

#include "slit/domains.hpp"
#include "tetrarch/doctor/build.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

CylinderGrid regular() {
  CylinderGrid grid = two_slits();
  grid.unrest = 0;
  return grid;
}

TEST_CASE("A cylinder drawn twice as wide has quasi-conformal error 2 everywhere") {
  const OneForms forms(slit_prism(regular()).mesh);
  SlitMap map = slit_map(forms, 0, 1);
  // The longest two loops are the rims, as both slits are shorter.
  for (double& angle : map.form.imaginary) angle *= 2;
  const Distortion d = distortion_on_cylinder(forms, map);
  CHECK(d.quasi_conformal.size() == 128); // two triangles for each of 4 x 16 squares
  for (const double ratio : d.quasi_conformal) CHECK(ratio == Approx(2).epsilon(1e-12));
  CHECK(d.mean_quasi_conformal == Approx(2).epsilon(1e-12));
  CHECK(d.max_quasi_conformal == Approx(2).epsilon(1e-12));
  // Right-angled triangles keep their right angle; the other two change by the same amount. A square is
  // 1/4 high and pi/8 wide.
  const double change = std::atan2(std::acos(-1.0) / 4, 0.25) - std::atan2(std::acos(-1.0) / 8, 0.25);
  CHECK(d.max_angle_error == Approx(change).epsilon(1e-11));
  CHECK(d.mean_angle_error == Approx(2 * change / 3).epsilon(1e-11));
}

TEST_CASE("In a mirror every triangle is flipped, and none is measured") {
  const OneForms forms(slit_prism(regular()).mesh);
  SlitMap map = slit_map(forms, 0, 1);
  CHECK(distortion_on_cylinder(forms, map).flipped.empty());
  CHECK(distortion_on_ring(forms, map).flipped.empty());
  for (double& angle : map.form.imaginary) angle = -angle;
  for (double& angle : map.angle) angle = -angle;
  for (const Distortion& d : {distortion_on_cylinder(forms, map), distortion_on_ring(forms, map)}) {
    CHECK(d.flipped.size() == 128);
    CHECK(d.mean_quasi_conformal == 0);
    CHECK(d.max_angle_error == 0);
  }
}

TEST_CASE("A triangle hanging on the boundary by one side is an ear, and no flip") {
  CylinderGrid annulus;
  annulus.sectors = 16;
  const surface::TriangleMesh ring = slit_ring(annulus, [](Complex z) { return z; }).mesh;
  format::Soup soup;
  soup.points = ring.points;
  soup.triangles = ring.surface.triangles();
  // Vertices 0 and 1 are neighbours on the outer circle, which runs from 0 to 1.
  soup.triangles.push_back({1, 0, static_cast<int>(soup.points.size())});
  soup.points.push_back({1.2, 0.2, 0});
  const OneForms forms(doctor::build_surface(std::move(soup)));
  const SlitMap map = slit_map(forms, 0, 1);
  const Distortion d = distortion_on_cylinder(forms, map);
  CHECK(d.ears == 1);
  CHECK(d.flipped.empty());
  CHECK(d.quasi_conformal.back() == 0);
}

TEST_CASE("What is wrong shows in the residual that is named after it") {
  const OneForms forms(slit_ring(regular(), [](Complex z) { return z; }).mesh);
  const SlitMap good = slit_map(forms, 0, 1);
  int inside = 0;
  std::vector<char> on_loop(good.angle.size(), 0);
  for (const auto& loop : forms.loops())
    for (const surface::SideEnd e : loop.sides) on_loop[forms.mesh().surface.vertex(e)] = 1;
  while (on_loop[inside]) ++inside;
  const int rim = forms.mesh().surface.vertex(forms.loops()[0].sides.front());

  SlitMap bad = good;
  bad.log_radius[inside] += 0.01;
  CHECK(residuals(forms, bad).harmonic > 0.01);
  CHECK(residuals(forms, bad).radius < 1e-14);
  bad = good;
  bad.log_radius[rim] -= 0.01;
  CHECK(residuals(forms, bad).radius == Approx(1 - std::exp(-0.01)).epsilon(1e-12));
  CHECK(residuals(forms, bad).flux > 0.01);
  bad = good;
  bad.form.imaginary[forms.loops()[1].sides.front().side.value] += 0.01;
  CHECK(residuals(forms, bad).period == Approx(0.01).epsilon(1e-10));
}

} // namespace
