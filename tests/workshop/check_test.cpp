// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/check.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/workshop/open.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

/// The corner of the unit cube: the origin and the unit vectors.
format::Soup corner() {
  format::Soup soup;
  soup.source = "corner";
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return soup;
}

format::Soup corner_surface() {
  format::Soup soup = corner();
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

bool has_member(const Diagnosis& found, const char* name) {
  Tree tree = tree_of(found);
  const std::size_t size = tree.size();
  tree.erase(name);
  return tree.size() < size;
}

} // namespace

TEST_CASE("the corner of a cube is measured from inside and outside", "[workshop]") {
  format::Soup solid = corner();
  solid.tetrahedra = {{0, 1, 2, 3}};
  // A sixth of the cube; three halves of its sides and an equilateral triangle of side sqrt 2.
  const double volume = 1.0 / 6;
  const double area = (3 + std::sqrt(3.0)) / 2;

  const Diagnosis inside = check(solid);
  CHECK(inside.verdict() == Verdict::yes);
  REQUIRE(inside.hull);
  CHECK(inside.hull->components == 1);
  CHECK(tree_of(inside)["boundary"].front()["type"].text() == "sphere");
  CHECK(tree_of(inside)["volume"].number() == Approx(volume));
  CHECK_FALSE(has_member(inside, "area"));

  const Diagnosis outside = check(corner_surface());
  CHECK(outside.encloses());
  CHECK(tree_of(outside)["type"].text() == "sphere");
  CHECK(tree_of(outside)["genus"].integer() == 0);
  CHECK(tree_of(outside)["volume"].number() == Approx(volume));
  CHECK(tree_of(outside)["area"].number() == Approx(area));
  CHECK(tree_of(outside)["boundary_loops"].empty());
  // The right angles of the three sides.
  CHECK(tree_of(outside)["quality"]["greatest_angle"].number() == Approx(90));
}

TEST_CASE("a square is a disk whose loop is as long as its sides", "[workshop]") {
  format::Soup square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Diagnosis found = check(square);
  REQUIRE(found.sheet);
  CHECK(found.sheet->types.front().is_disk());
  REQUIRE(found.sheet->loops.size() == 1);
  CHECK(found.sheet->loops.front().length == Approx(4));
  CHECK(found.sheet->loops.front().area == Approx(1));
  CHECK(found.sheet->loops.front().vertices.size() == 4);
  CHECK_FALSE(found.encloses());
  CHECK(tree_of(found)["volume"].is_null());
}

TEST_CASE("genera are those that the Euler characteristics of the files say", "[workshop]") {
  // Closed surfaces of V vertices and F triangles: chi = V - F / 2.
  for (const char* name : {"cube", "torus", "double_torus"}) {
    INFO(name);
    const Diagnosis found =
        check(open_mesh(TETRARCH_SOURCE_DIR "/tests/data/mesh/" + std::string(name) + ".off"));
    REQUIRE(found.sheet);
    const auto vertices = static_cast<int>(found.soup.points.size());
    const auto triangles = static_cast<int>(found.elements());
    CHECK(2 - 2 * tree_of(found)["genus"].integer() == vertices - triangles / 2);
  }
}

TEST_CASE("faults are findings, and what can be mended is", "[workshop]") {
  format::Soup turned = corner_surface();
  std::swap(turned.triangles[1][0], turned.triangles[1][1]);
  const Diagnosis found = check(turned);
  CHECK(found.verdict() == Verdict::yes);
  CHECK(tree_of(found)["counts"]["turned"].integer() == 1);
  CHECK(text_of(found).find("repairable") != std::string::npos);
  CheckOptions mending;
  mending.doctor.repair = true;
  const Diagnosis mended = check(turned, mending);
  CHECK(mended.repairs.size() == 1);
  CHECK(mended.report.findings.empty());
  CHECK(tree_of(mended)["volume"].number() == Approx(1.0 / 6));
  mending.doctor.component = 1; // there is one component, number 0
  CHECK_THROWS_AS(check(turned, mending), InputError);
}

TEST_CASE("three triangles at an edge are no manifold", "[workshop]") {
  format::Soup book = corner();
  book.points.push_back({1, 1, 1});
  book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Diagnosis found = check(book);
  CHECK(found.verdict() == Verdict::proved_no);
  CHECK(tree_of(found)["fatal"].integer() > 0);
  CHECK_FALSE(found.sheet);
  CHECK(text_of(found).find("no manifold") != std::string::npos);
  CHECK_FALSE(has_member(found, "components"));
  CHECK(tree_of(found)["area"].number() > 0); // it can be measured all the same

  book.points[4][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(check(book).measures);
}

TEST_CASE("findings left out are counted", "[workshop]") {
  CheckOptions none;
  none.listed = 0;
  format::Soup lonely = corner_surface();
  lonely.points.insert(lonely.points.end(), 3, {7, 7, 7}); // three that no triangle names
  const Diagnosis found = check(lonely, none);
  CHECK(found.report.findings.empty());
  CHECK(tree_of(found)["counts"]["unused_vertex"].integer() == 3);
  CHECK(text_of(found).find("and 3 more of the kind unused_vertex") != std::string::npos);
}
