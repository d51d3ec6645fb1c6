// SPDX-License-Identifier: GPL-2.0-or-later
/// Metrics of prescribed curvature, and what they are laid out to: circles and rectangles.
#include "tetrarch/slit/ricci.hpp"

#include "slit/domains.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

namespace {

using namespace tetrarch;
using namespace tetrarch::slit;
using namespace tetrarch::support;

constexpr double half_turn = full_turn / 2;

Complex ricci_moebius(Complex z) {
  return (z + 0.4) / (1.0 + 0.4 * z);
}

/// A point of the plane, or of the sphere of which it is the stereographic projection.
using Place = std::array<double, 3>;
Place in_plane(Complex z) {
  return {z.real(), z.imag(), 0};
}
Place on_sphere(Complex z) {
  const double d = 1 + std::norm(z);
  return {2 * z.real() / d, 2 * z.imag() / d, (d - 2) / d};
}

double inversive_distance(const Circle& p, const Circle& q) {
  return std::abs(std::norm(p.center - q.center) - p.radius * p.radius - q.radius * q.radius) /
         (2 * p.radius * q.radius);
}

/// Of all pairs of loops, by their numbers in the mesh.
std::vector<double> inversive_distances(const CircularMap& map) {
  const auto circle = [&](int loop) {
    return map.domain.circles[std::find(map.loop.begin(), map.loop.end(), loop) - map.loop.begin()];
  };
  std::vector<double> all;
  for (int a = 0; a < static_cast<int>(map.loop.size()); ++a)
    for (int b = 0; b < a; ++b) all.push_back(inversive_distance(circle(a), circle(b)));
  return all;
}

double greatest_ratio(const std::vector<double>& x, const std::vector<double>& y) {
  REQUIRE(x.size() == y.size());
  double greatest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) greatest = std::max(greatest, std::abs(x[k] / y[k] - 1));
  return greatest;
}

/// A rectangle of width 1, `width` x `height` squares, without blocks of them, moved by a function.
struct Grid {
  surface::TriangleMesh mesh;
  std::vector<Complex> at;                 ///< of each vertex, before it was moved
  std::vector<std::array<int, 4>> corners; ///< of the rectangle, then of the holes
};
struct Block {
  int left, right, bottom, top;
};
template <class Bend>
Grid grid(int width, int height, const std::vector<Block>& holes, const Bend& bend) {
  Grid out;
  const auto is_hole = [&](int i, int j) {
    return std::any_of(holes.begin(), holes.end(), [&](const Block& b) {
      return i >= b.left && i < b.right && j >= b.bottom && j < b.top;
    });
  };
  std::vector<int> name(static_cast<std::size_t>((width + 1) * (height + 1)), -1);
  format::Soup soup;
  const auto vertex = [&](int i, int j) {
    int& v = name[j * (width + 1) + i];
    if (v < 0) {
      v = static_cast<int>(out.at.size());
      out.at.emplace_back(i / static_cast<double>(width), j / static_cast<double>(width));
      soup.points.push_back(bend(out.at.back()));
    }
    return v;
  };
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      if (is_hole(i, j)) continue;
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  out.mesh = doctor::build_surface(std::move(soup));
  out.corners.push_back({vertex(0, 0), vertex(width, 0), vertex(width, height), vertex(0, height)});
  for (const Block& b : holes)
    out.corners.push_back(
        {vertex(b.left, b.bottom), vertex(b.right, b.bottom), vertex(b.right, b.top), vertex(b.left, b.top)});
  return out;
}

TEST_CASE("A flat rectangle moved by a Moebius map, onto a sphere too, gets its scales and its shape back") {
  // On the sphere |f'| is 2 / (1 + |z|^2), in the plane that of the map; vertex scaling has both exactly.
  for (const bool sphere : {false, true}) {
    const Grid bent =
        grid(12, 9, {}, [&](Complex z) { return sphere ? on_sphere(z) : in_plane(ricci_moebius(z)); });
    Curvatures right_angles;
    right_angles.at.assign(bent.at.size(), 0.0);
    for (const int v : bent.corners[0]) right_angles.at[v] = half_turn / 2;
    const ScaledMetric metric = scaled_metric(bent.mesh, right_angles);
    REQUIRE(metric.found);
    CHECK(metric.residual <= 1e-10);
    CHECK(metric.steps < 12);
    const auto log_speed = [&](std::size_t v) {
      const Complex z = bent.at[v];
      return sphere ? std::log(2 / (1 + std::norm(z))) : std::log(0.84 / std::norm(1.0 + 0.4 * z));
    };
    for (std::size_t v = 0; v < bent.at.size(); ++v)
      CHECK(metric.log_scale[v] == Approx(log_speed(0) - log_speed(v)).margin(1e-8));
    const Layout layout = laid_out(metric.triangulation);
    CHECK(layout.gap < 1e-9);
    const auto [a, b, c, d] = bent.corners[0];
    const Complex unit = layout.position[b] - layout.position[a];
    for (std::size_t v = 0; v < bent.at.size(); ++v)
      CHECK(std::abs((layout.position[v] - layout.position[a]) / unit - bent.at[v]) < 1e-8);
  }
}

TEST_CASE(
    "What going round a loop does to the plane: nothing, a shift around a prism, a turn around a cone") {
  // By hand: the prism's circumference is 2 pi, and its loops are straight.
  CylinderGrid straight = two_slits();
  straight.unrest = 0;
  const CrackedCylinder prism = slit_prism(straight);
  const auto unrolled = surface::intrinsic_delaunay(prism.mesh);
  const Holonomy around = holonomy(unrolled, prism.outer_vertex);
  CHECK(std::abs(around.translation - full_turn) < 1e-12);
  CHECK(std::abs(around.rotation) < 1e-12);
  CHECK(laid_out(unrolled).gap == Approx(full_turn));
  CHECK_THROWS_AS(holonomy(unrolled, static_cast<int>(prism.at.size())), InputError);

  CylinderGrid ring;
  const CrackedCylinder planar = slit_ring(ring, ricci_moebius);
  const Holonomy none = holonomy(surface::intrinsic_delaunay(planar.mesh), planar.inner_vertex);
  CHECK(std::abs(none.translation) < 1e-12);
  CHECK(std::abs(none.rotation) < 1e-12);
  CHECK(laid_out(surface::intrinsic_delaunay(planar.mesh)).gap < 1e-12);

  // A third of a turn on each loop, shared out evenly, is a cone's: 8 vertices a loop.
  Curvatures cone;
  for (const OnCylinder& p : planar.at)
    cone.at.push_back((p.height == 0 ? 1 : p.height == ring.height ? -1 : 0) * full_turn / 3 / ring.sectors);
  const ScaledMetric metric = scaled_metric(planar.mesh, cone);
  REQUIRE(metric.found);
  CHECK(holonomy(metric.triangulation, planar.outer_vertex).rotation == Approx(full_turn / 3));
  CHECK(holonomy(metric.triangulation, planar.inner_vertex).rotation == Approx(-full_turn / 3));
}

TEST_CASE("Curvatures that no surface has are refused, and a budget that is too small finds nothing") {
  const Grid square = grid(4, 4, {{1, 3, 1, 3}}, in_plane);
  const auto metric = [&](const Curvatures& c) { return scaled_metric(square.mesh, c); };
  Curvatures curvatures;
  CHECK_THROWS_AS(metric(curvatures), PreconditionError);
  curvatures.at.assign(square.at.size(), 0.0);
  curvatures.at[0] = 0.1; // the Euler number is 0
  CHECK_THROWS_AS(metric(curvatures), InputError);
  curvatures.at[0] = std::nan("");
  CHECK_THROWS_AS(metric(curvatures), InputError);
  curvatures.at[0] = 0;
  CHECK(metric(curvatures).found);
  curvatures.round_holes = {square.corners[1][0]};
  CHECK_THROWS_AS(metric(curvatures), InputError);
  curvatures.round_holes = {static_cast<int>(square.at.size())};
  CHECK_THROWS_AS(metric(curvatures), InputError);
  curvatures.round_holes.clear();
  curvatures.held = {1};
  CHECK_THROWS_AS(metric(curvatures), PreconditionError);

  Curvatures cone;
  cone.at.assign(square.at.size(), 0.0);
  cone.at[square.corners[0][0]] = half_turn / 2;
  cone.at[square.corners[0][2]] = -half_turn / 2;
  CHECK(scaled_metric(square.mesh, cone).found);
  const ScaledMetric early = scaled_metric(square.mesh, cone, {1e-10, 1});
  CHECK_FALSE(early.found);
  CHECK(early.residual > 1e-10);
}

TEST_CASE("A hole may be round in a rectangle") {
  const Grid square = grid(12, 12, {{4, 8, 4, 8}}, in_plane);
  Curvatures curvatures;
  curvatures.at.assign(square.at.size(), 0.0);
  for (const int v : square.corners[0]) curvatures.at[v] = half_turn / 2;
  curvatures.round_holes = {square.corners[1][2]};
  const ScaledMetric metric = scaled_metric(square.mesh, curvatures);
  REQUIRE(metric.found);
  const Layout layout = laid_out(metric.triangulation);
  CHECK(layout.gap < 1e-9);
  const auto place = [&](int v) { return layout.position[v]; };
  // The grid is symmetric under half a turn, so the circle is about the middle of a diagonal.
  const Complex middle = (place(square.corners[0][0]) + place(square.corners[0][2])) / 2.0;
  const double radius = std::abs(place(square.corners[1][0]) - middle);
  const auto loops = surface::boundary_loops(square.mesh);
  for (const surface::SideEnd e : loops[1].sides)
    CHECK(std::abs(place(square.mesh.surface.vertex(e)) - middle) == Approx(radius).epsilon(1e-9));
}

TEST_CASE("An annulus up to a Moebius map is found exactly, another one as its mesh gets finer") {
  const auto error = [](int times, const auto& bend) {
    CylinderGrid cylinder;
    cylinder.sectors = 16;
    const CrackedCylinder ring = slit_ring(refined(cylinder, times), bend);
    const auto loops = surface::boundary_loops(ring.mesh);
    const int outer = surface::loop_through(loops, ring.mesh.surface, ring.outer_vertex);
    const RicciCircles found = ricci_circles(ring.mesh, outer, 1 - outer);
    REQUIRE(found.map.domain.found);
    CHECK(found.map.domain.circularity < 1e-9);
    CHECK(distortion_in_plane(ring.mesh, found.map.position).flipped.empty());
    const auto known = [&](std::size_t v) {
      return std::polar(std::exp(-ring.at[v].height), ring.at[v].angle);
    };
    const Complex turn = found.map.position[ring.outer_vertex] / known(ring.outer_vertex);
    double greatest = std::abs(found.map.domain.circles[1].radius - std::exp(-1.0));
    for (std::size_t v = 0; v < ring.at.size(); ++v)
      greatest = std::max(greatest, std::abs(found.map.position[v] - turn * known(v)));
    return greatest;
  };
  CHECK(error(1, ricci_moebius) < 1e-9);
  CHECK(error(4, ricci_moebius) < 1e-9);
  const auto bend = [](Complex z) { return z + z * z / 5.0; };
  const double coarse = error(2, bend);
  const double fine = error(8, bend);
  CHECK(coarse < 0.02);
  CHECK(coarse > 11 * fine);
}

TEST_CASE("Both routes to the circular domain approach each other") {
  const auto difference = [](int times) {
    const OneForms forms(slit_ring(refined(two_slits(), times), ricci_moebius).mesh);
    const CircularMap one = circular_map(forms, slit_map(forms, 0, 1));
    const RicciCircles two = ricci_circles(forms.mesh(), 0, 1);
    REQUIRE(one.domain.found);
    REQUIRE(two.map.domain.found);
    CHECK(two.map.domain.circularity < 1e-9);
    CHECK(two.map.loop == one.loop);
    CHECK(two.map.domain.circles[2].center.real() > 0);
    CHECK(std::abs(two.map.domain.circles[2].center.imag()) < 1e-9);
    CHECK(distortion_in_plane(forms.mesh(), two.map.position).flipped.empty());
    return greatest_ratio(inversive_distances(one), inversive_distances(two.map));
  };
  // Order 1, as at the tips of cracks.
  const double coarse = difference(2);
  const double fine = difference(8);
  CHECK(coarse < 0.1);
  CHECK(coarse > 3 * fine);
}

TEST_CASE("Which vertex was sent to infinity is not seen") {
  // A ring with two slits, sheared and bent out of the plane, so that edges are flipped near the boundary
  // too.
  surface::TriangleMesh mesh = slit_ring(refined(two_slits(), 2), ricci_moebius).mesh;
  for (auto& [x, y, z] : mesh.points) std::tie(x, z) = std::pair(x + y, x * x);
  REQUIRE(surface::intrinsic_delaunay(mesh).flips > 100);
  const TriangleList plain{mesh.surface.triangles(), mesh.points, mesh.surface.vertex_count()};
  const RicciCircles first = ricci_circles(mesh, 0, 1);
  REQUIRE(first.map.domain.found);
  Random random(7);
  for (int round = 0; round < 4; ++round) {
    const TriangleList other = relabelled(plain, random);
    const RicciCircles found = ricci_circles({other.points, other.surface()}, round, (round + 1) % 4);
    REQUIRE(found.map.domain.found);
    // Loops are renumbered.
    std::vector<double> known = inversive_distances(first.map);
    std::vector<double> distances = inversive_distances(found.map);
    std::sort(known.begin(), known.end());
    std::sort(distances.begin(), distances.end());
    CHECK(greatest_ratio(distances, known) < 1e-7);
  }
}

TEST_CASE("A disk is the same up to Moebius maps, and approaches Riemann's map") {
  const auto difference = [](int n) {
    const Grid plain = grid(n, n, {}, in_plane);
    const Grid bent = grid(n, n, {}, [](Complex z) { return on_sphere(ricci_moebius(z)); });
    const RicciCircles one = ricci_circles(plain.mesh, 0, -1);
    const RicciCircles two = ricci_circles(bent.mesh, 0, -1);
    const CircularMap riemann = disk_map(plain.mesh, innermost_vertex(plain.mesh));
    REQUIRE(one.map.domain.found);
    CHECK(one.map.domain.circularity < 1e-9);
    double greatest = 0;
    for (std::size_t v = 0; v < plain.at.size(); ++v) {
      CHECK(std::abs(one.map.position[v] - two.map.position[v]) < 1e-8);
      greatest = std::max(greatest, std::abs(one.map.position[v] - riemann.position[v]));
    }
    return greatest;
  };
  const double coarse = difference(6);
  const double fine = difference(24);
  CHECK(coarse < 0.2);
  CHECK(coarse > 4 * fine);
}

TEST_CASE("Circles are refused where there are no such loops or the surface is no sphere with holes") {
  const Grid ring = grid(4, 4, {{1, 3, 1, 3}}, in_plane);
  for (const auto& [outer, inner] : {std::pair{0, 0}, {0, -1}, {0, 2}, {2, 0}, {-1, 0}})
    CHECK_THROWS_AS(ricci_circles(ring.mesh, outer, inner), InputError);
  const Grid disk = grid(4, 4, {}, in_plane);
  CHECK_THROWS_AS(ricci_circles(disk.mesh, 0, 1), InputError);
  CHECK_THROWS_AS(ricci_circles(grid(1, 1, {}, in_plane).mesh, 0, -1), InputError);
  const TriangleList torus = with_holes(torus_grid(6, 6), 2);
  CHECK_THROWS_AS(ricci_circles({torus.points, torus.surface()}, 0, 1), InputError);
}

/// So many vertices on along the boundary.
int further(const surface::Surface& surface, int v, int times) {
  for (; times > 0; --times)
    for (int k = 0; k < surface.side_count(); ++k)
      if (const surface::Side s(k); surface.is_boundary(s) && surface.from(s) == v) {
        v = surface.to(s);
        break;
      }
  return v;
}

/// The greatest deviation of the sides of all rectangles from being horizontal or vertical, for vertices
/// beyond the two that share a corner.
double slant(const Grid& grid, const RicciRectangles& found) {
  const surface::Surface& surface = grid.mesh.surface;
  double greatest = 0;
  for (const auto& corners : found.corners)
    for (std::size_t c = 0; c < 4; ++c) {
      int v = further(surface, corners[c].vertex, corners[c].part > 0 ? 1 : 0);
      for (int w = v; v != corners[(c + 1) % 4].vertex; v = w) {
        w = further(surface, v, 1);
        const Complex along = found.position[w] - found.position[v];
        greatest = std::max(greatest, std::min(std::abs(along.real()), std::abs(along.imag())));
      }
    }
  return greatest;
}

TEST_CASE("A rectangle with rectangular holes, moved by a Moebius map, is found exactly from its corners") {
  const Grid bent = grid(24, 20, {{4, 9, 5, 10}, {13, 18, 8, 15}}, [](Complex z) { return on_sphere(z); });
  const RicciRectangles found = ricci_rectangles(bent.mesh, bent.corners);
  REQUIRE(found.found);
  CHECK(found.rounds == 0);
  CHECK(found.holonomy < 1e-9);
  for (std::size_t v = 0; v < bent.at.size(); ++v) CHECK(std::abs(found.position[v] - bent.at[v]) < 1e-8);
}

TEST_CASE("The corners of holes are moved until the holes close and are parallel to the rectangle") {
  const std::vector<Block> holes{{4, 9, 5, 10}, {13, 18, 8, 15}};
  const Grid bent = grid(24, 20, holes, [](Complex z) { return in_plane(ricci_moebius(z)); });
  for (const int shift : {1, 2}) {
    auto hints = bent.corners;
    for (int* const corner : {&hints[1][0], &hints[2][1], &hints[2][2]})
      *corner = further(bent.mesh.surface, *corner, shift);
    const RicciRectangles found = ricci_rectangles(bent.mesh, hints);
    REQUIRE(found.found);
    CHECK(found.rounds > 0);
    CHECK(found.rounds < 12);
    CHECK(found.holonomy < 1e-9);
    CHECK(slant(bent, found) < 1e-8);
    CHECK(distortion_in_plane(bent.mesh, found.position).flipped.empty());
    RectangleOptions impatient;
    impatient.most_rounds = 1;
    const RicciRectangles early = ricci_rectangles(bent.mesh, hints, impatient);
    CHECK_FALSE(early.found);
    CHECK(early.rounds == 1);
    CHECK(early.holonomy > found.holonomy);
  }
}

TEST_CASE("The rectangle of a quarter of a ring has the modulus of its logarithm") {
  // exp maps a rectangle of height pi / 2 and width 2 to it, with or without a hole.
  const auto error = [](int n, bool with_hole) {
    std::vector<Block> holes;
    if (with_hole) holes.push_back({n / 4, n / 2, n / 4, n / 2});
    const Grid ring = grid(n, n, holes, [](Complex z) {
      return in_plane(std::exp(Complex(2 * z.real(), half_turn / 2 * z.imag())));
    });
    const RicciRectangles found = ricci_rectangles(ring.mesh, ring.corners);
    REQUIRE(found.found);
    CHECK(slant(ring, found) < 1e-8);
    return std::abs(found.height - half_turn / 4);
  };
  CHECK(error(8, false) < 0.01);
  CHECK(error(8, false) > 11 * error(32, false));
  CHECK(error(32, true) < 0.01);
}

TEST_CASE("Hints that are no four corners of each loop are refused") {
  const Grid ring = grid(8, 8, {{2, 6, 2, 6}}, in_plane);
  const auto refused = [&](const auto& change) {
    auto hints = ring.corners;
    change(hints);
    CHECK_THROWS_AS(ricci_rectangles(ring.mesh, hints), InputError);
  };
  refused([](auto& hints) { hints.pop_back(); });
  refused([](auto& hints) { hints[1] = hints[0]; });
  refused([](auto& hints) { hints[0][0] = hints[1][0]; });
  refused([](auto& hints) { hints[1][0] = -1; });
  refused([](auto& hints) { hints[1][2] = 1000; });
  refused([](auto& hints) { hints[1][1] = hints[1][0]; });
  refused([&](auto& hints) { hints[1][1] = further(ring.mesh.surface, hints[1][0], 1); });
}

/// The four vertices, whichever comes first.
bool are_the_same(std::array<int, 4> a, std::array<int, 4> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

TEST_CASE("The corners of all rectangles are found from the outer ones, and those by their sharpness") {
  const std::vector<Block> holes{{4, 9, 5, 10}, {13, 18, 8, 15}};
  const Grid flat = grid(24, 20, holes, [](Complex z) { return in_plane(z); });
  const auto loops = surface::boundary_loops(flat.mesh);
  const std::array<int, 4> corners = corners_of(flat.mesh, loops[0]);
  CHECK(are_the_same(corners, flat.corners[0]));
  // Loops of holes come by length: the larger hole is the second of the grid. Corners of holes are found up
  // to half a side.
  const auto hints = rectangle_hints(flat.mesh, corners);
  REQUIRE(hints.size() == 3);
  const RicciRectangles found = ricci_rectangles(flat.mesh, hints);
  REQUIRE(found.found);
  CHECK(slant(flat, found) < 1e-8);
  CHECK(distortion_in_plane(flat.mesh, found.position).flipped.empty());
}

TEST_CASE("A loop without sharp corners gets them at quarters of its length, one too short none") {
  constexpr int n = 24;
  format::Soup soup;
  soup.points.push_back({0, 0, 0});
  for (int j = 0; j < n; ++j)
    soup.points.push_back({std::cos(2 * half_turn * j / n), std::sin(2 * half_turn * j / n), 0});
  for (int j = 0; j < n; ++j) soup.triangles.push_back({0, 1 + j, 1 + (j + 1) % n});
  const surface::TriangleMesh disk = doctor::build_surface(std::move(soup));
  const std::array<int, 4> corners = corners_of(disk, surface::boundary_loops(disk)[0]);
  for (std::size_t c = 0; c < 4; ++c) CHECK((corners[(c + 1) % 4] - corners[c] + n) % n == n / 4);
  // By the symmetry of the disk the rectangle is a square.
  const RicciRectangles square = ricci_rectangles(disk, rectangle_hints(disk, corners));
  REQUIRE(square.found);
  CHECK(square.height == Approx(1).epsilon(1e-9));
  const Grid small = grid(1, 2, {}, in_plane);
  CHECK_THROWS_AS(corners_of(small.mesh, surface::boundary_loops(small.mesh)[0]), InputError);
}

} // namespace
