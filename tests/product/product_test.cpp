// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/product.hpp"

#include "product/solids.hpp"
#include "tetrarch/product/critical.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::product;

namespace {

struct Made {
  SplitSolid at;
  FloorMap floor;
  std::vector<double> w;
  double height = 0;
  Coordinates coordinates;
  Quality quality;
  Confirmation confirmation;
};

Made make(const support::Extrusion& from, FloorDomain domain, int threads = 1) {
  Solid whole = solid_of(from.mesh);
  Partition patches = partition(whole, support::bases(whole, from));
  Made m{split_shortcuts(std::move(whole), std::move(patches)), {}, {}, 0, {}, {}, {}};
  m.floor = floor_map(m.at.solid, m.at.partition, {.domain = domain});
  m.height = natural_height(m.at.solid, m.at.partition, m.floor);
  m.w = harmonic_field(m.at.solid, m.at.partition, {.height = m.height}).w;
  const FiberField field(m.at.solid, m.at.partition, m.w);
  m.coordinates = coordinates(field, m.floor, threads);
  m.quality = quality(m.at.solid, m.coordinates.uvw);
  m.confirmation = confirm(field, threads);
  return m;
}

void check_perfect(const Made& m) {
  CHECK(m.floor.found);
  CHECK(m.floor.flipped == 0);
  CHECK(m.coordinates.stuck.empty());
  CHECK(m.coordinates.by_gradient == 0);
  CHECK(m.quality.flipped.empty());
  CHECK(m.confirmation.not_arrived == 0);
}

} // namespace

TEST_CASE("A box goes to a box", "[product]") {
  const Made m = make(support::box({2, 1, 0.5}, {8, 5, 4}), FloorDomain::rectangle);
  check_perfect(m);
  // Width 1 for 2, so all is halved.
  CHECK(m.floor.height == Approx(0.5));
  CHECK(m.height == Approx(0.25));
  for (std::size_t v = 0; v < m.coordinates.uvw.size(); ++v) {
    const Point& p = m.at.solid.mesh.points[v];
    const Point& q = m.coordinates.uvw[v];
    // Which corner is the first is the map's choice: some quarter turn.
    CHECK(std::abs(std::abs(q[0] - 0.5) - std::abs(p[0] / 2 - 0.5)) < 1e-9);
    CHECK(std::abs(std::abs(q[1] - 0.25) - std::abs(p[1] / 2 - 0.25)) < 1e-9);
    CHECK(q[2] == Approx(p[2] / 2).margin(1e-12));
  }
  CHECK(m.quality.max_orthogonality_error < 1e-8);
  CHECK(m.quality.max_uv < 1e-8);
  CHECK(m.confirmation.max_distance < 1e-9);
}

TEST_CASE("A cylinder goes to a cylinder, at order h^2", "[product]") {
  const auto error = [](int rings) {
    const Made m = make(support::cylinder(rings, 4, 0.7), FloorDomain::circular);
    check_perfect(m);
    CHECK(m.height == Approx(0.7));
    CHECK(m.confirmation.max_distance < 1e-9);
    // The identity up to a turn about the axis and a Moebius map, which vertices nearest to 0 settle.
    double worst = 0;
    for (std::size_t v = 0; v < m.coordinates.uvw.size(); ++v) {
      const Point& p = m.at.solid.mesh.points[v];
      const Point& q = m.coordinates.uvw[v];
      worst = std::max(worst, std::abs(std::hypot(q[0], q[1]) - std::hypot(p[0], p[1])));
    }
    return worst;
  };
  const double coarse = error(4);
  const double fine = error(16);
  INFO(coarse << " " << fine);
  CHECK(fine < coarse / 8);
}

TEST_CASE("Plates with one to five holes go to disks and rectangles with as many", "[product]") {
  for (int holes = 1; holes <= 5; ++holes) {
    const Made disk = make(support::plate(holes, 8, 3), FloorDomain::circular);
    check_perfect(disk);
    CHECK(disk.confirmation.max_distance < 1e-9);

    const Made rectangle = make(support::plate(holes, 6, 3, support::Hole::square), FloorDomain::rectangle);
    check_perfect(rectangle);
    REQUIRE(static_cast<int>(rectangle.floor.rectangles.size()) == holes);
    // By hand: holes of width 1/2 in a plate of length `holes`.
    for (const auto& [low, high] : rectangle.floor.rectangles) {
      CHECK(high.real() - low.real() == Approx(0.5 / holes));
      CHECK(high.imag() - low.imag() == Approx(0.5 / holes));
    }
    CHECK(rectangle.quality.max_orthogonality_error < 1e-8);
    CHECK(rectangle.quality.max_uv < 1e-6);
  }
}

TEST_CASE("Orthogonality errors fall with the size of the triangles where fibres are curved", "[product]") {
  // Radial fibres between spheres; gradients of linear functions are of first order.
  for (const int holes : {0, 2}) {
    const Made coarse = make(support::shell(holes, 0.6, 6), FloorDomain::circular);
    const Made fine = make(support::shell(holes, 0.6, 12), FloorDomain::circular);
    check_perfect(coarse);
    check_perfect(fine);
    INFO(coarse.quality.mean_orthogonality_error << " " << fine.quality.mean_orthogonality_error);
    CHECK(fine.quality.mean_orthogonality_error < 0.65 * coarse.quality.mean_orthogonality_error);
    CHECK(fine.confirmation.mean_distance < 0.6 * coarse.confirmation.mean_distance);
    CHECK(fine.confirmation.max_distance < 0.1);
  }
}

TEST_CASE("A pipe with its cylinders as floor and ceiling has radial fibres", "[product]") {
  // The floor is a ring; its map is exp(2 pi (z - z0) / circumference) up to a Moebius map, here none: by
  // symmetry circles about the axis go to circles. So all vertices of one half plane have one angle.
  const Made m = make(support::radial_pipe(0.5, 10), FloorDomain::circular);
  check_perfect(m);
  // Whether turns are kept depends on which of two rims of the same length is the outer one.
  double worst = 9;
  for (const int sign : {1, -1}) {
    double greatest = 0;
    double start = 0;
    for (std::size_t v = 0; v < m.coordinates.uvw.size(); ++v) {
      const Point& p = m.at.solid.mesh.points[v];
      const Point& q = m.coordinates.uvw[v];
      const double turned = std::atan2(q[1], q[0]) - sign * std::atan2(p[1], p[0]);
      if (v == 0) start = turned;
      greatest = std::max(greatest, std::abs(std::remainder(turned - start, 2 * std::numbers::pi)));
    }
    worst = std::min(worst, greatest);
  }
  CHECK(worst < 0.02);
}

TEST_CASE("Of disks with several holes the middle is the centroid of the floor", "[product]") {
  for (const int holes : {2, 3}) {
    const support::Divided whole =
        support::divided(support::plate(holes, 6, 2, support::Hole::round, 0.5, 0));
    const FloorMap floor = floor_map(whole.solid, whole.partition);
    std::complex<double> sum = 0;
    for (std::size_t v = 0; v < floor.position.size(); ++v) {
      CHECK(std::abs(floor.position[v]) < 1 + 1e-9);
      sum += floor.position[v];
    }
    // By vertices, not by area: near 0, where a hole in the middle would be if nothing were done, 0.3 off.
    CHECK(std::abs(sum) / static_cast<double>(floor.position.size()) < 0.06);
    // Symmetric plates have symmetric disks.
    double right = 0;
    double left = 0;
    for (const std::complex<double> z : floor.position) {
      right = std::max(right, std::abs(z.real()));
      left = std::max(left, std::abs(z.imag()));
    }
    CHECK(right > 0.99);
    CHECK(left > 0.99);
  }
}

TEST_CASE("A rectangle's corners are the rim's, also of an L with a hole in its arm", "[product]") {
  // Four right-angled corners turn outward, one inward; the hole near the end of an arm lies askew in the
  // rectangle, so that the first guess of its corners may fail.
  support::PlanarMesh plan = support::planar_plate(3, 3, 9, 8, support::Hole::square);
  std::vector<std::array<int, 3>> kept;
  for (const auto& t : plan.triangles) {
    const double x = (plan.points[t[0]][0] + plan.points[t[1]][0] + plan.points[t[2]][0]) / 3;
    const double y = (plan.points[t[0]][1] + plan.points[t[1]][1] + plan.points[t[2]][1]) / 3;
    if (x < 1 || y < 1) kept.push_back(t);
  }
  std::vector<int> number(plan.points.size(), -1);
  support::PlanarMesh ell;
  ell.holes = 5;
  for (auto& t : kept) {
    for (int& v : t) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(ell.points.size());
        ell.points.push_back(plan.points[v]);
      }
      v = number[v];
    }
    ell.triangles.push_back(t);
  }
  const auto place = [](double x, double y, double t) { return std::array{x, y, t}; };
  const support::Divided whole = support::divided(support::extruded(ell, 2, place, 0));
  const FloorMap floor = floor_map(whole.solid, whole.partition, {.domain = FloorDomain::rectangle});
  CHECK(floor.found);
  CHECK(floor.flipped == 0);
  for (std::size_t v = 0; v < floor.vertex.size(); ++v) {
    const auto& p = floor.mesh.points[v];
    const bool is_corner = (p[0] == 0 && p[1] == 0) || (p[0] == 3 && p[1] == 0) || (p[0] == 3 && p[1] == 1) ||
                           (p[0] == 0 && p[1] == 3) || (p[0] == 1 && p[1] == 3);
    const std::complex<double> z = floor.position[v];
    const double to_corner = std::min(std::min(std::abs(z), std::abs(z - 1.0)),
                                      std::min(std::abs(z - std::complex<double>(1, floor.height)),
                                               std::abs(z - std::complex<double>(0, floor.height))));
    if (to_corner < 1e-6) CHECK(is_corner);
  }
}

TEST_CASE("The number of threads changes nothing", "[product]") {
  const support::Extrusion from = support::bent(2, 6, 5);
  CHECK(make(from, FloorDomain::circular, 1).coordinates.uvw ==
        make(from, FloorDomain::circular, 3).coordinates.uvw);
}

TEST_CASE("Edges between vertices of one base are split", "[product]") {
  // By hand: one layer of one box, both bases of two triangles. A corner tetrahedron on four floor vertices
  // is made by pushing one vertex of the ceiling down: none here, so the walls' diagonals are all there is.
  const support::Extrusion from = support::box({1, 1, 1}, {3, 3, 2}, 0);
  Solid whole = solid_of(from.mesh);
  Partition patches = partition(whole, support::bases(whole, from));
  CHECK(split_shortcuts(whole, patches).splits == 0);

  // The floor reaches up one wall to half its height: edges from there to the old floor are shortcuts.
  std::vector<int> base = support::bases(whole, from);
  for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
    bool on_wall = base[t] < 0;
    for (int c = 0; c < 3; ++c) {
      const Point& p = whole.point(whole.corner(t, c));
      on_wall = on_wall && p[0] == 1 && p[2] < 0.6;
    }
    if (on_wall) base[t] = 0;
  }
  patches = partition(whole, base);
  const SplitSolid after = split_shortcuts(whole, patches);
  CHECK(after.splits > 0);
  const auto w = harmonic_field(after.solid, after.partition).w;
  CHECK(critical_places(after.solid, after.partition, w).flat.empty());
  CHECK_FALSE(critical_places(whole, patches, harmonic_field(whole, patches).w).flat.empty());
  // Patches keep their area.
  const auto areas = [](const Solid& s, const Partition& p) {
    std::array<double, 3> area{};
    for (int t = 0; t < s.boundary.triangle_count(); ++t) {
      const Point& a = s.point(s.corner(t, 0));
      const Point& b = s.point(s.corner(t, 1));
      const Point& c = s.point(s.corner(t, 2));
      const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      area[p.patch[t]] +=
          std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    }
    return area;
  };
  for (int k = 0; k < 3; ++k)
    CHECK(areas(after.solid, after.partition)[k] == Approx(areas(whole, patches)[k]));
}

TEST_CASE("Stuck fibres are told, and their vertices lie between those around", "[product]") {
  const support::Extrusion from = support::box({2, 2, 2}, {4, 4, 4}, 0);
  const Solid whole = solid_of(from.mesh);
  const Partition patches = partition(whole, support::bases(whole, from));
  const FloorMap floor = floor_map(whole, patches, {.domain = FloorDomain::rectangle});
  std::vector<double> w;
  int pit = -1;
  for (std::size_t v = 0; v < whole.mesh.points.size(); ++v) {
    w.push_back(whole.mesh.points[v][2]);
    if (whole.mesh.points[v] == Point{1, 1, 1.5}) w[pit = static_cast<int>(v)] = 0.2;
  }
  const FiberField field(whole, patches, w, Direction::gradient);
  const Coordinates found = coordinates(field, floor);
  REQUIRE_FALSE(found.stuck.empty());
  bool pit_is_told = false;
  for (const StuckFiber& s : found.stuck) {
    CHECK(s.at == Point{1, 1, 1.5});
    pit_is_told = pit_is_told || s.vertex == pit;
  }
  CHECK(pit_is_told);
  CHECK(found.uvw[pit][0] > 0);
  CHECK(found.uvw[pit][0] < 1);
  CHECK(confirm(field).not_arrived == static_cast<int>(found.stuck.size()));
}
