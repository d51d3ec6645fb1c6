// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/bundle.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/workshop/open.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

NumberedSurface sample(const std::string& name) {
  return surface_of(open_mesh(TETRARCH_SOURCE_DIR "/tests/data/mesh/" + name + ".off"));
}

/// First homology of the bundle of Euler number e over the surface.
std::string homology_over(const std::string& name, std::optional<int> euler, int fiber = 2) {
  BundleOptions options;
  options.plan.fiber = fiber;
  options.plan.euler = euler;
  const SurfaceBundle found = circle_bundle(sample(name), options);
  REQUIRE(found.verdict() == Verdict::yes);
  return tree_of(found)["homology"].text();
}

NumberedSurface triangle() {
  format::Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  return surface_of(std::move(soup));
}

} // namespace

TEST_CASE("bundles have the homology that Gysin's sequence gives them", "[workshop]") {
  // Over genus g: Z^2g + Z/|e|, and Z^(2g+1) where e = 0.
  CHECK(homology_over("cube", std::nullopt) == "Z/2"); // projective space
  CHECK(homology_over("cube", 3) == "Z/3");
  CHECK(homology_over("torus", 0) == "Z^3");
  CHECK(homology_over("double_torus", std::nullopt, 1) == "Z^4 + Z/2");
}

TEST_CASE("a unit tangent bundle tells its fibers and its singularities", "[workshop]") {
  BundleOptions options;
  options.plan.fiber = 2;
  options.field = {0.1, 0.2, 1};
  const SurfaceBundle found = circle_bundle(sample("cube"), options);
  REQUIRE(found.made);
  // Poincare and Hopf: the indices add up to the Euler characteristic, of field and section alike.
  CHECK(std::accumulate(found.made->field.begin(), found.made->field.end(), 0) == 2);
  CHECK(tree_of(found)["field"]["index_sum"].integer() == 2);
  CHECK(tree_of(found)["section"]["index_sum"].integer() == 2);
  CHECK(tree_of(found)["euler_number"].integer() == 2);
  // A circle of two vertices over each vertex; three tetrahedra to a prism.
  CHECK(found.made->info.vertices == 2 * found.made->bundle.base.vertex_count());
  CHECK(found.made->info.tetrahedra == 3 * 2 * found.made->bundle.base.triangle_count());
  CHECK(text_of(found).find("\nfield ") != std::string::npos);
  const format::Document document = document_of(found);
  REQUIRE(document.bundle);
  CHECK(document.bundle->euler_number == 2);
  CHECK(document.bundle->levels.size() == document.bundle->triangle_of.size());

  // No tangent field is a section of a bundle of another Euler number.
  options.plan.euler = 3;
  CHECK(tree_of(circle_bundle(sample("cube"), options))["field"].is_null());
}

TEST_CASE("a triangle whose boundary has one value throughout has no pattern", "[workshop]") {
  BundleOptions options;
  options.plan.boundary = bundle::BoundaryValues{1, 1, 1};
  const SurfaceBundle none = circle_bundle(triangle(), options);
  CHECK(none.verdict() == Verdict::proved_no);
  REQUIRE(none.obstruction);
  CHECK(none.obstruction->forbidding == 1);
  CHECK(none.obstruction->mesh.triangles.size() == 1);
  CHECK(tree_of(none)["obstruction"]["triangles"].size() == 1);
  CHECK(tree_of(none).size() == 2); // solvable, obstruction
  CHECK(text_of(none).starts_with("no solution"));
  CHECK_THROWS_AS(document_of(none), PreconditionError);

  options.plan.boundary = bundle::BoundaryValues{1, -1, 1};
  const SurfaceBundle torus = circle_bundle(triangle(), options);
  CHECK(torus.verdict() == Verdict::yes);
  CHECK(tree_of(torus)["euler_number"].is_null());
  CHECK(tree_of(torus)["homology"].text() == "Z"); // a solid torus
}

TEST_CASE("what takes too much memory is not begun", "[workshop]") {
  BundleOptions options;
  options.most_bytes = 1000;
  const SurfaceBundle found = circle_bundle(triangle(), options);
  CHECK(found.verdict() == Verdict::undecided);
  REQUIRE(found.bytes_needed);
  CHECK(*found.bytes_needed == Approx(bundle::bundle_bytes(3 * 8, 1))); // one triangle, 8 prisms
  options.bytes_a_tetrahedron = 100;
  CHECK(*circle_bundle(triangle(), options).bytes_needed == Approx(bundle::bundle_bytes(3 * 8, 1) + 2400));
}
