// SPDX-License-Identifier: GPL-2.0-or-later
// What the doctor finds and mends beyond incidences: orientation by components, coincident and pinched
// vertices, stray triangles, surfaces inside out; welding, components, boundaries, quality.
#include "support/surface_soups.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/boundary_surface.hpp"
#include "tetrarch/doctor/quality.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/doctor/weld.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::support::soups;

namespace {

const Points corner_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles boundary_of_corner{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

format::Soup solid_soup(const Points& points, const std::vector<std::array<int, 4>>& tetrahedra,
                        const Triangles& triangles = {}) {
  return soup_of(points, tetrahedra, triangles);
}

} // namespace

// By hand: the second tetrahedron has its apex on the same side of the common face as the first one, and is
// half as large. However the two are listed, one of them is inverted against the other.
TEST_CASE("a tetrahedron that is folded over stays found after repair", "[doctor]") {
  Points points = corner_points;
  points.push_back({0.2, 0.2, 0.5});
  for (const std::array<int, 4>& second : {std::array<int, 4>{0, 2, 1, 4}, {0, 1, 2, 4}})
    for (const std::array<int, 4>& first : {std::array<int, 4>{0, 1, 2, 3}, {0, 2, 1, 3}}) {
      const format::Soup soup = solid_soup(points, {first, second});
      CHECK(validate(soup).count(Kind::folded) == 1);
      const format::Soup mended = repair(soup).soup;
      const Report report = validate(mended);
      CHECK(report.count(Kind::folded) == 1);
      CHECK(report.count(Kind::inverted) == 0);
      CHECK(report.findings.at(0).number == 2);
      CHECK(extent(mended).volume == Approx(1.0 / 6 - 0.5 / 6));
    }
}

TEST_CASE("each component is oriented for itself, by its larger volume", "[doctor]") {
  Points points = corner_points;
  for (const auto& p : corner_points) points.push_back({p[0] + 5, p[1], p[2]});
  const Repaired result = repair(solid_soup(points, {{0, 2, 1, 3}, {4, 5, 6, 7}}));
  CHECK(result.done.size() == 1);
  CHECK(validate(result.soup).count(Kind::inverted) == 0);
  CHECK(extent(result.soup).volume == Approx(2.0 / 6));
}

TEST_CASE("coincident vertices are found, in solids and surfaces, and welding joins them", "[doctor]") {
  Points points = corner_points;
  points.insert(points.end(), {{-0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  const format::Soup soup = solid_soup(points, {{0, 1, 2, 3}, {4, 6, 5, 7}});
  const Report report = validate(soup);
  CHECK(report.count(Kind::coincident_vertex) == 3);
  CHECK(report.findings.at(0).text == "vertex 5 coincides with vertex 1");
  CHECK(component_count(soup) == 2);
  const Repaired joined = weld(soup, 0);
  CHECK(joined.done == std::vector<std::string>{"welded 3 vertices to others"});
  CHECK(joined.soup.points.size() == 5);
  CHECK(component_count(joined.soup) == 1);
  CHECK(validate(joined.soup).findings.empty());
  CHECK(joined.soup.point_labels.numbers[4] == 8); // as in the file
  format::Soup surface = soup;
  surface.tetrahedra.clear();
  surface.triangles = {{0, 1, 2}, {4, 6, 7}};
  CHECK(validate_surface(surface).count(Kind::coincident_vertex) == 2);
}

TEST_CASE("welding with a tolerance joins what is near, and drops what collapses", "[doctor]") {
  Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1.0009, 0, 0}, {0, 1.0009, 0}, {1e-4, 0, 0}};
  const Triangles triangles{{0, 1, 2}, {4, 3, 5}, {0, 6, 1}};
  CHECK(weld(surface_soup(points, triangles), 0).done.empty());
  const Repaired joined = weld(surface_soup(points, triangles), 1e-3);
  CHECK(joined.done ==
        std::vector<std::string>{"welded 3 vertices to others", "removed 1 triangles that collapsed"});
  CHECK(joined.soup.triangles == Triangles{{0, 1, 2}, {1, 3, 2}});
  // Neighboring cells are looked at, and no chain of points becomes one.
  Points row;
  for (int k = 0; k < 100; ++k) row.push_back({0.6 * k - 30, 0, 0});
  const auto left = weld(surface_soup(row, {}), 1.0).soup.points.size();
  CHECK(left == 50); // every other one joins the one before it
  CHECK_THROWS_AS(weld(surface_soup(row, {}), -1), PreconditionError);
  CHECK_THROWS_AS(weld(surface_soup(row, {}), std::nan("")), PreconditionError);
}

TEST_CASE("a component is taken with its points and triangles, and labels", "[doctor]") {
  Points points = corner_points;
  for (const auto& p : corner_points) points.push_back({p[0] + 5, p[1], p[2]});
  format::Soup soup = solid_soup(points, {{0, 1, 2, 3}, {4, 5, 6, 7}}, {{0, 2, 1}, {4, 6, 5}});
  soup.triangle_tags = {8, 9};
  soup.tetrahedron_tags = {1, 2};
  const format::Soup second = component(soup, 1);
  CHECK(second.tetrahedra == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
  CHECK(second.triangles == Triangles{{0, 2, 1}});
  CHECK(second.triangle_tags == std::vector<int>{9});
  CHECK(second.tetrahedron_tags == std::vector<int>{2});
  CHECK(second.points[1] == std::array<double, 3>{6, 0, 0});
  CHECK_THROWS_AS(component(soup, 2), InputError);
  CHECK_THROWS_AS(component(soup, -1), InputError);
}

TEST_CASE("triangles that bound no tetrahedron are found, and go with unused vertices", "[doctor]") {
  Points points = corner_points;
  points.push_back({1, 1, 1});
  const format::Soup soup = solid_soup(points, {{0, 1, 2, 3}}, {{0, 1, 4}, {0, 2, 1}});
  const Report report = validate(soup);
  CHECK(report.count(Kind::stray_triangle) == 1);
  CHECK(report.findings.at(1).text == "triangle 1 is no face of a tetrahedron");
  const format::Soup mended = repair(soup).soup;
  CHECK(mended.triangles == Triangles{{0, 2, 1}});
  CHECK(validate(mended).findings.empty());
}

TEST_CASE("pinched vertices are split", "[doctor]") {
  // Two tetrahedra that share vertex 0 alone; and two discs that do.
  Points points = corner_points;
  points.insert(points.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  format::Soup soup = solid_soup(points, {{0, 1, 2, 3}, {0, 5, 4, 6}}, {{0, 4, 5}});
  CHECK(validate(soup).count(Kind::non_manifold_vertex) == 1);
  Repaired result = repair(soup);
  CHECK(result.done == std::vector<std::string>{"split off 1 vertices where tetrahedra fell apart"});
  CHECK(validate(result.soup).count(Severity::fatal) == 0);
  CHECK(result.soup.points.size() == 8);
  CHECK(result.soup.points[7] == points[0]);
  CHECK(result.soup.triangles == Triangles{{7, 4, 5}}); // it follows its tetrahedron
  result = repair(surface_soup(points, {{0, 1, 2}, {0, 4, 5}}));
  CHECK(result.done == std::vector<std::string>{"split off 1 vertices where triangles fell apart",
                                                "removed 2 unused vertices"});
  CHECK(validate_surface(result.soup).count(Severity::fatal) == 0);
  // Two tetrahedra that share an edge alone fall apart there, too: two vertices are split.
  soup = solid_soup(points, {{0, 1, 2, 3}, {0, 1, 5, 4}});
  CHECK(validate(soup).count(Kind::non_manifold_edge) == 1);
  CHECK(validate(repair(soup).soup).count(Severity::fatal) == 0);
  // Three triangles on an edge stay together.
  const format::Soup book = surface_soup(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 5}});
  CHECK(validate_surface(repair(book).soup).count(Kind::non_manifold_edge) == 1);
}

TEST_CASE("closed surfaces inside out are found and turned, cavities are not", "[doctor]") {
  Triangles inside_out;
  for (const Triangle& t : boundary_of_corner) inside_out.push_back(turned(t));
  CHECK(validate_surface(surface_soup(corner_points, boundary_of_corner)).count(Kind::inside_out) == 0);
  const format::Soup soup = surface_soup(corner_points, inside_out);
  CHECK(validate_surface(soup).count(Kind::inside_out) == 1);
  const Repaired result = repair(soup);
  CHECK(result.done == std::vector<std::string>{"turned round 4 triangles of components inside out"});
  CHECK(extent(result.soup).volume == Approx(1.0 / 6));
  // A small one within a large one is the wall of a cavity.
  Points points;
  for (const auto& p : corner_points) points.push_back({10 * p[0] - 2, 10 * p[1] - 2, 10 * p[2] - 2});
  points.insert(points.end(), corner_points.begin(), corner_points.end());
  Triangles both = boundary_of_corner;
  for (const Triangle& t : inside_out) both.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  CHECK(validate_surface(surface_soup(points, both)).count(Kind::inside_out) == 0);
  CHECK(repair(surface_soup(points, both)).done.empty());
  // A surface with boundary has no inside.
  inside_out.pop_back();
  CHECK(validate_surface(surface_soup(corner_points, inside_out)).count(Kind::inside_out) == 0);
}

TEST_CASE("the boundary of a solid looks outwards and keeps labels", "[doctor]") {
  Points points = corner_points;
  points.push_back({0, 0, -1});
  format::Soup soup = solid_soup(points, {{0, 1, 2, 3}, {0, 2, 1, 4}}, {{1, 2, 3}, {0, 1, 2}});
  soup.triangle_tags = {5, 6};
  const format::Soup boundary = boundary_surface(soup);
  CHECK(boundary.triangles.size() == 6);
  CHECK(validate_surface(boundary).findings.empty());
  CHECK(extent(boundary).volume == Approx(extent(soup).volume));
  CHECK(std::count(boundary.triangle_tags.begin(), boundary.triangle_tags.end(), 5) == 1);
  CHECK(std::count(boundary.triangle_tags.begin(), boundary.triangle_tags.end(), 6) == 0); // inside
}

// A regular tetrahedron has the dihedral angle arccos(1/3) and the scaled Jacobian 1; the corner of a cube
// has three right angles and three of arccos(1/sqrt 3) = 54.7356; at a corner on the cube's diagonals edges
// are 1, sqrt 2, sqrt 2 long, so that its Jacobian is sqrt 2 / 2.
TEST_CASE("angles and scaled Jacobians of tetrahedra known by heart", "[doctor]") {
  const ElementQuality regular =
      quality_of(std::array<std::array<double, 3>, 4>{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}});
  CHECK(regular.least_angle == Approx(std::acos(1.0 / 3) * 180 / M_PI));
  CHECK(regular.greatest_angle == Approx(regular.least_angle));
  CHECK(std::fabs(regular.scaled_jacobian) == Approx(1));
  for (const double scale : {1e-200, 1.0, 1e200}) {
    const ElementQuality corner = quality_of(
        std::array<std::array<double, 3>, 4>{{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale}}});
    CHECK(corner.least_angle == Approx(54.7356103));
    CHECK(corner.greatest_angle == Approx(90));
    CHECK(corner.scaled_jacobian == Approx(std::sqrt(0.5)));
  }
  const ElementQuality flat =
      quality_of(std::array<std::array<double, 3>, 4>{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  CHECK(flat.scaled_jacobian == 0);
  CHECK(flat.least_angle == Approx(0).margin(1e-9));
  CHECK(flat.greatest_angle == Approx(180));
  const ElementQuality right =
      quality_of(std::array<std::array<double, 3>, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  CHECK(right.least_angle == Approx(45));
  CHECK(right.greatest_angle == Approx(90));
  // The worst come first, by number where they are alike.
  Points points = corner_points;
  points.push_back({0, 0, -0.1});
  const Quality all = quality(solid_soup(points, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 3}}), 2);
  REQUIRE(all.worst.size() == 2);
  CHECK(all.worst[0].element == 1);
  CHECK(all.worst[1].element == 0);
}
