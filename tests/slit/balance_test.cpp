// SPDX-License-Identifier: GPL-2.0-or-later
/// Distortion traded: surfaces that fit their domain exactly are found to do so.
#include "tetrarch/slit/balance.hpp"

#include "slit/domains.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/doctor/build.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

/// Vertices inside are moved, the map said to be so.
void shake(const OneForms& forms, SlitMap& map, double by) {
  const surface::Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  std::vector<Complex> shift(loop.size(), 0.0);
  for (std::size_t v = 0; v < loop.size(); ++v)
    if (loop[v] < 0)
      shift[v] = by * Complex(std::sin(7.0 * static_cast<double>(v)), std::cos(3.0 * static_cast<double>(v)));
  for (std::size_t v = 0; v < loop.size(); ++v) {
    map.log_radius[v] += shift[v].real();
    map.angle[v] += shift[v].imag();
  }
  for (int k = 0; k < surface.side_count(); ++k) {
    const Complex change = shift[surface.to(surface::Side(k))] - shift[surface.from(surface::Side(k))];
    map.form.real[k] += change.real();
    map.form.imaginary[k] += change.imag();
  }
}

/// A square of n x n squares in the plane, cut by its diagonals, put into space by `place`.
template <class Place>
surface::TriangleMesh sheet(int m, int n, const Place& place) {
  format::Soup soup;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) soup.points.push_back(place(i, j));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j;
      const int b = a + n + 1;
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  return doctor::build_surface(std::move(soup));
}

} // namespace

TEST_CASE("A prism with slits is isometric to its cylinder: shaken vertices find back") {
  CylinderGrid grid = refined(two_slits(), 2);
  grid.unrest = 0;
  const CrackedCylinder domain = slit_prism(grid);
  const OneForms forms(domain.mesh);
  SlitMap map = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
  const SlitMap exact = map;
  const Balanced still = balance_on_cylinder(forms, map);
  CHECK(still.before == Approx(1).epsilon(1e-10));
  CHECK(still.left_out == 0);
  shake(forms, map, 0.03);
  const Balanced found = balance_on_cylinder(forms, map);
  CHECK(found.before > 1.05);
  CHECK(found.settled);
  CHECK(found.after == Approx(1).epsilon(1e-7));
  for (std::size_t v = 0; v < exact.angle.size(); ++v) {
    CHECK(map.log_radius[v] == Approx(exact.log_radius[v]).margin(1e-3));
    CHECK(std::abs(angle_between(map.angle[v], exact.angle[v])) < 1e-3);
  }
  CHECK(distortion_on_cylinder(forms, map).mean_area_error < 1e-3);
  // What the form says along sides is what the vertices say.
  for (int k = 0; k < domain.mesh.surface.side_count(); ++k) {
    const int from = domain.mesh.surface.from(surface::Side(k));
    const int to = domain.mesh.surface.to(surface::Side(k));
    CHECK(std::abs(std::remainder(map.form.imaginary[k] - (map.angle[to] - map.angle[from]), full_turn)) <
          1e-12);
    CHECK(map.form.real[k] == Approx(map.log_radius[to] - map.log_radius[from]).margin(1e-12));
  }
}

TEST_CASE("A ring with slits that was bent by a Moebius map is balanced, its slits and circles kept") {
  const CrackedCylinder domain =
      slit_ring(refined(two_slits(), 2), [](Complex z) { return (z + 0.4) / (1.0 + 0.4 * z); });
  const OneForms forms(domain.mesh);
  SlitMap map = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
  const std::vector<double> radius = map.log_radius;
  const Distortion before = distortion_on_ring(forms, map);
  const Balanced found = balance_on_ring(forms, map);
  const Distortion after = distortion_on_ring(forms, map);
  CHECK(found.settled);
  CHECK(found.after < found.before);
  CHECK(after.flipped.empty());
  CHECK(after.mean_area_error < 0.75 * before.mean_area_error);
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), domain.mesh.surface);
  for (std::size_t v = 0; v < radius.size(); ++v)
    if (loop[v] >= 0) CHECK(map.log_radius[v] == radius[v]);
  // The slits reach as far as before.
  for (const Slit& s : map.slits) {
    double low = 0;
    double high = 0;
    double at = 0;
    for (const surface::SideEnd e : forms.loops()[s.loop].sides) {
      at += map.form.imaginary[e.side.value];
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const double reach = angle_between(map.angle[s.start_vertex], map.angle[s.end_vertex]);
    CHECK(high - low == Approx(reach < 0 ? reach + full_turn : reach).epsilon(1e-12));
  }
}

TEST_CASE("A flat disk seen from one side is laid out as it is, its circle kept") {
  // A polar grid without its middle, which is one more vertex.
  constexpr int rings = 6;
  constexpr int sectors = 24;
  format::Soup soup;
  soup.points.push_back({0, 0, 0});
  for (int i = 1; i <= rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const Complex z = std::polar(i / static_cast<double>(rings), full_turn * j / sectors);
      soup.points.push_back({z.real(), z.imag(), 0});
    }
  const auto at = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
  for (int j = 0; j < sectors; ++j) {
    soup.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i < rings; ++i) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const surface::TriangleMesh mesh = doctor::build_surface(std::move(soup));
  CircularMap map = disk_map(mesh, at(4, 0)); // far from the middle
  const Balanced found = balance_in_disk(mesh, map);
  CHECK(found.before > 1.5);
  // Scaled to the area that the start had: a polygon of sides that differ has less of the circle.
  CHECK(found.after < 1.005);
  for (int j = 0; j < sectors; ++j) CHECK(std::abs(map.position[at(rings, j)]) == Approx(1).epsilon(1e-13));
  CHECK(distortion_in_disk(mesh, map).max_area_error < 2e-3);
}

TEST_CASE("Sheets that are flat but for bends are unrolled to their own size; what overlaps is told") {
  // On a cylinder of radius 1/2: arcs of a fifth, chords sin(1/5).
  const surface::TriangleMesh rolled = sheet(10, 12, [](int i, int j) {
    return std::array<double, 3>{0.5 * std::cos(0.4 * i), 0.5 * std::sin(0.4 * i), 0.3 * j};
  });
  const FreeMap flat = free_map(rolled, disk_map(rolled, innermost_vertex(rolled)).position);
  CHECK(flat.balanced.settled);
  CHECK(flat.balanced.after == Approx(1).epsilon(1e-6));
  CHECK(flat.crossings == 0);
  const double diagonal = std::hypot(10 * std::sin(0.2), 12 * 0.3);
  CHECK(std::abs(flat.position[0] - flat.position[10 * 13 + 12]) == Approx(diagonal).epsilon(2e-3));

  // A band that winds round a little more than once and hardly climbs lies on itself.
  const surface::TriangleMesh spiral = sheet(80, 6, [](int i, int j) {
    const double angle = full_turn * 1.3 * i / 80;
    const double radius = 2 - 0.1 * j;
    return std::array<double, 3>{radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle};
  });
  // Laid into the disk it covers it once; the middle of one end goes round with the rest.
  std::vector<Complex> start;
  for (int i = 0; i <= 80; ++i)
    for (int j = 0; j <= 6; ++j) start.push_back(std::polar(2 - 0.1 * j, 0.5 * full_turn * i / 80));
  const FreeMap twice = free_map(spiral, start);
  CHECK(twice.balanced.after < 1.01);
  CHECK(twice.crossings > 0);
}

TEST_CASE("An ear, which a round hole turns over, is set right where the shape is free") {
  // A square ring of squares in the plane; the inner corner of the hole is cut by an ear.
  format::Soup soup;
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; j <= 6; ++j) soup.points.push_back({1.0 * i, 1.0 * j, 0});
  const auto at = [](int i, int j) { return 7 * i + j; };
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      if (i >= 2 && i < 4 && j >= 2 && j < 4 && !(i == 2 && j == 2)) continue;
      if (i == 2 && j == 2) { // half a square is left of the hole's corner
        soup.triangles.push_back({at(2, 2), at(3, 2), at(2, 3)});
        continue;
      }
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  // The ear's tip is a corner of one triangle only.
  soup.points.push_back({2.9, 2.9, 0});
  soup.triangles.push_back({at(3, 2), static_cast<int>(soup.points.size()) - 1, at(2, 3)});
  // Point (3, 3) is in the hole: drop it.
  const int unused = at(3, 3);
  soup.points[static_cast<std::size_t>(unused)] = soup.points.back();
  for (auto& t : soup.triangles)
    for (int& v : t)
      if (v == static_cast<int>(soup.points.size()) - 1) v = unused;
  soup.points.pop_back();
  const surface::TriangleMesh mesh = doctor::build_surface(std::move(soup));
  const OneForms forms(mesh);
  const CircularMap map = circular_map(forms, slit_map(forms, 0, 1));
  REQUIRE(distortion_in_disk(mesh, map).ears == 1);
  const FreeMap flat = free_map(mesh, map.position);
  CHECK(flat.balanced.left_out == 0);
  CHECK(flat.balanced.after == Approx(1).epsilon(1e-6));
  CHECK(distortion_in_plane(mesh, flat.position).flipped.empty());
}

/// What holds for every softened map. Whether any vertex moved.
bool check_softened(const OneForms& forms, int outer, int inner, bool on_ring) {
  const surface::Surface& surface = forms.mesh().surface;
  SlitMap map = slit_map(forms, outer, inner);
  const SlitMap before = map;
  const auto distortion = [&] {
    return on_ring ? distortion_on_ring(forms, map) : distortion_on_cylinder(forms, map);
  };
  const Distortion first = distortion();
  const Softened found = on_ring ? soften_ends_on_ring(forms, map) : soften_ends_on_cylinder(forms, map);
  const Distortion then = distortion();
  CHECK(then.flipped.size() <= first.flipped.size());
  CHECK(then.max_quasi_conformal <= first.max_quasi_conformal * (1 + 1e-12));
  if (found.moved > 0) {
    CHECK(found.before > 10);
    CHECK(found.after < found.before);
  }
  // Vertices stay on their loops, the form says what the vertices say, and periods are what they were.
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  int moved = 0;
  for (std::size_t v = 0; v < loop.size(); ++v) {
    if (loop[v] >= 0) CHECK(map.log_radius[v] == before.log_radius[v]);
    if (map.angle[v] != before.angle[v] || map.log_radius[v] != before.log_radius[v]) ++moved;
  }
  CHECK(moved <= found.moved);
  for (int k = 0; k < surface.side_count(); ++k) {
    const int from = surface.from(surface::Side(k));
    const int to = surface.to(surface::Side(k));
    CHECK(std::abs(std::remainder(map.form.imaginary[k] - (map.angle[to] - map.angle[from]), full_turn)) <
          1e-12);
    CHECK(map.form.real[k] == Approx(map.log_radius[to] - map.log_radius[from]).margin(1e-12));
  }
  for (const surface::BoundaryLoop& l : forms.loops())
    CHECK(period(map.form.imaginary, l) == Approx(period(before.form.imaginary, l)).margin(1e-12));
  return found.moved > 0;
}

TEST_CASE("Needles where a slit turns back between vertices are relaxed, the rest of the map left alone") {
  int softened = 0;
  for (const int times : {1, 2, 3})
    for (const double bend : {0.1, 0.2}) {
      const CrackedCylinder domain = slit_ring(refined(two_slits(), times), [&](Complex z) {
        const Complex w = (z + 0.4) / (1.0 + 0.4 * z);
        return w + bend * w * w;
      });
      const OneForms forms(domain.mesh);
      for (int outer = 0; outer < 4; ++outer)
        for (int inner = 0; inner < 4; ++inner)
          for (const bool on_ring : {false, true})
            if (inner != outer && check_softened(forms, outer, inner, on_ring)) ++softened;
    }
  CHECK(softened > 10);
}
