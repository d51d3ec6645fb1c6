// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/slit.hpp"

#include "support/planar_domains.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/fingerprint.hpp"
#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

HoledSurface holed(surface::TriangleMesh mesh) {
  NumberedSurface surface;
  surface.mesh = std::move(mesh);
  return opened(surface);
}

HoledSurface sample_surface(const std::string& name, const Openings& openings = {}) {
  return opened(surface_of(open_mesh(TETRARCH_SOURCE_DIR "/tests/data/mesh/" + name)), openings);
}

/// The flat ring between circles of radius 3 and 1, of so many squares around.
HoledSurface flat_ring(int around, double stretched = 1) {
  support::CylinderGrid grid;
  grid.sectors = around;
  grid.rings = around / 6;
  grid.height = std::log(3.0);
  return holed(
      support::cracked_cylinder(grid, [&](const support::OnCylinder& p) {
        const double radius = 3 * std::exp(-p.height);
        return std::array<double, 3>{stretched * radius * std::cos(p.angle), radius * std::sin(p.angle), 0.0};
      }).mesh);
}

/// A rectangle of n by n pieces.
HoledSurface flat_rectangle(int n, double width, double height) {
  format::Soup soup;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) soup.points.push_back({width * i / n, height * j / n, 0});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int at = j * (n + 1) + i;
      soup.triangles.push_back({at, at + 1, at + n + 2});
      soup.triangles.push_back({at, at + n + 2, at + n + 1});
    }
  return opened(surface_of(std::move(soup)));
}

ConformalMap mapped(HoledSurface surface, MapDomain domain) {
  MapOptions options;
  options.domain = domain;
  return conformal_map(std::move(surface), options);
}

std::string refusal_of(HoledSurface surface, MapDomain domain) {
  MapOptions options;
  options.name = "the surface";
  options.domain = domain;
  try {
    conformal_map(std::move(surface), options);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("a prism with a cut is its own slit map", "[workshop]") {
  // The circumference is 2 pi, so that the cylinder has the height of the prism.
  support::CylinderGrid grid;
  grid.sectors = 16;
  grid.unrest = 0;
  grid.cracks = {{1, 2, 4}};
  const ConformalMap found = mapped(holed(support::slit_prism(grid).mesh), MapDomain::cylindric);
  CHECK(found.verdict() == Verdict::yes);
  const Tree tree = tree_of(found);
  CHECK(tree["boundaries"].size() == 3);
  CHECK(tree["domain"].text() == "cylindric");
  CHECK(tree["modulus"].number() == Approx(1).margin(1e-12));
  CHECK(tree["modulus_bounds"].back().number() == Approx(1).margin(1e-12));
  const Tree& slit = tree["slits"].front(); // its ends are found to half an edge
  const double height = slit["height"].number();
  // The two ends look alike: whichever is the outer one, the cut is a quarter away from the one and three
  // from the other.
  CHECK(std::min(height, 1 - height) == Approx(0.25).margin(1e-12));
  CHECK(slit["end"].number() - slit["start"].number() ==
        Approx(std::numbers::pi / 2).margin(std::numbers::pi / 16));
  CHECK_THROWS_AS(tree["radii"], PreconditionError); // a cylinder has none
  CHECK(tree_of(mapped(found.surface, MapDomain::concentric))["radii"]["inner"].number() ==
        Approx(std::exp(-1)).margin(1e-12));
}

TEST_CASE("a flat ring has the modulus log(R / r)", "[workshop]") {
  const ConformalMap found = mapped(flat_ring(96), MapDomain::concentric);
  CHECK(found.verdict() == Verdict::yes);
  CHECK(found.remarks().empty());
  REQUIRE(found.slits);
  CHECK(found.slits->modulus == Approx(std::log(3.0)).epsilon(2e-3));
  CHECK(found.slits->modulus <= found.slits->modulus_bound);
  CHECK(tree_of(found)["slits"].empty());
  // The same ring by three other ways: circles from harmonic functions, circles by Ricci flow, invariants.
  MapOptions options;
  options.domain = MapDomain::circular;
  for (const bool by_ricci_flow : {false, true}) {
    options.by_ricci_flow = by_ricci_flow;
    const ConformalMap disk = conformal_map(found.surface, options);
    CHECK(tree_of(disk)["circles"].back()["radius"].number() == Approx(1.0 / 3).epsilon(2e-3));
    CHECK(tree_of(disk)["outer"].integer() == 0);
    CHECK(disk.slits.has_value() != by_ricci_flow);
  }
  const ConformalType type = conformal_type(flat_ring(24));
  CHECK(tree_of(type)["fingerprint"]["ring"]["inner_radius"]["value"].number() ==
        Approx(1.0 / 3).epsilon(5e-3));
}

TEST_CASE("what is flat already is a free domain without distortion", "[workshop]") {
  const ConformalMap found = mapped(flat_ring(24), MapDomain::free);
  REQUIRE(found.balance);
  CHECK(found.balance->balanced.after == Approx(1).margin(1e-9)); // 1: an isometry
  CHECK(found.distortion.max_area_error < 1e-3);
  CHECK(found.crossings == 0);
  CHECK(found.verdict() == Verdict::yes);
  CHECK_FALSE(found.slits);
}

TEST_CASE("a rectangle keeps its proportions", "[workshop]") {
  const ConformalMap found = mapped(flat_rectangle(6, 4, 1), MapDomain::rectangle);
  REQUIRE(found.rectangle);
  const double height = found.rectangle->height;
  CHECK(std::min(height, 1 / height) == Approx(0.25).epsilon(1e-7)); // which side is below is chosen
  CHECK(found.rectangle->corners.size() == 4);
  CHECK(found.rectangle->holes.empty());
  CHECK(found.distortion.max_quasi_conformal == Approx(1).margin(1e-6));
  // With the neighbor's corner first it stands upright.
  MapOptions turned;
  turned.domain = MapDomain::rectangle;
  turned.corners = {6, 48, 42, 0};
  CHECK(conformal_map(found.surface, turned).rectangle->height == Approx(4).epsilon(1e-7));
  turned.circles.outer = 1;
  turned.corners.reset();
  CHECK_THROWS_AS(conformal_map(found.surface, turned), PreconditionError);
}

TEST_CASE("surfaces without such a map are refused by name", "[workshop]") {
  CHECK(refusal_of(sample_surface("torus.off"), MapDomain::circular) ==
        "the surface: slit maps need a sphere with a hole at least, but this surface has type torus");
  CHECK(refusal_of(flat_rectangle(2, 1, 1), MapDomain::concentric) ==
        "the surface: slit maps need a sphere with two holes at least, but this surface has type disk");
  CHECK(mapped(flat_rectangle(2, 1, 1), MapDomain::circular).center == 4); // the only vertex inside
  CHECK(refusal_of(flat_rectangle(1, 1, 1), MapDomain::circular).find("interior vertex") !=
        std::string::npos);
  MapOptions options;
  options.basis = 2; // of two loops
  CHECK_THROWS_AS(conformal_map(flat_ring(12), options), PreconditionError);
}

TEST_CASE("a map that folds is undecided, unless that is allowed or mended", "[workshop]") {
  // Ten times as wide as high: the triangles are so obtuse that harmonic functions turn some over.
  MapOptions options;
  options.flips_allowed = true;
  const ConformalMap allowed = conformal_map(flat_ring(24, 10), options);
  CHECK(allowed.flipped() > 0);
  CHECK(allowed.verdict() == Verdict::yes);
  options.flips_allowed = false;
  options.basis = 0; // of which there is one way alone
  const ConformalMap folded = conformal_map(allowed.surface, options);
  CHECK(folded.flipped() == allowed.flipped());
  CHECK(folded.found());
  CHECK(folded.verdict() == Verdict::undecided);
  REQUIRE(folded.remarks().size() == 1);
  CHECK(folded.remarks().front().find("inverted") != std::string::npos);
  options.basis.reset();
  const ConformalMap mended = conformal_map(allowed.surface, options);
  REQUIRE(mended.mended);
  CHECK(mended.mended->flipped_before == allowed.flipped());
  CHECK(mended.flipped() < allowed.flipped());
  CHECK(map_rows(mended).back().first == "mended");
}

TEST_CASE("quads that cannot be are counted, not made", "[workshop]") {
  MapOptions options;
  options.quad_edge = 100;
  const ConformalMap found = conformal_map(flat_ring(24), options);
  CHECK_FALSE(found.quads);
  REQUIRE(found.impossible_quads);
  // Squares of as much area in the mean: the ring has 8 pi, and modulus / (2 pi) squares along to one around.
  const double around = std::sqrt(8 * std::numbers::pi / (std::log(3.0) / (2 * std::numbers::pi))) / 100;
  CHECK(*found.impossible_quads == Approx(around).epsilon(0.05));
  options.quad_edge = 100 * around / 12; // twelve around
  const ConformalMap twelve = conformal_map(flat_ring(24), options);
  REQUIRE(twelve.quads);
  CHECK(twelve.quads->mesh.quads.size() % 12 == 0);
}

TEST_CASE("a map as a document has a place for each corner", "[workshop]") {
  const ConformalMap found = mapped(flat_ring(24), MapDomain::concentric);
  const format::MeshDocument document = document_of(found);
  CHECK(document.soup.triangles == found.surface.mesh().surface.triangles());
  REQUIRE(format::find_field(document, "place"));
  CHECK(format::find_field(document, "log_radius"));
  CHECK(format::find_field(document, "potential_1"));
  CHECK(format::find_field(document, "quasi_conformal"));
}

TEST_CASE("a surface is no distance from itself, turned and scaled", "[workshop]") {
  const HoledSurface ring = sample_surface("ring_two_holes.off");
  surface::TriangleMesh moved = ring.mesh();
  for (auto& [x, y, z] : moved.points) std::tie(x, y, z) = std::tuple(-5 * y, 5 * x, 5 * z + 1);
  FingerprintOptions coarse;
  coarse.most_triangles = 2'000;
  ConformalType own = conformal_type(ring, coarse);
  own.comparison = comparison(own, conformal_type(holed(std::move(moved)), coarse));
  CHECK(own.comparison->distance < 1e-9);
  CHECK(own.comparison->matching == std::vector<int>{0, 1, 2});
  CHECK(own.verdict() == Verdict::yes);
  CHECK_THROWS_AS(comparison(own, conformal_type(flat_ring(12), coarse)), InputError); // one loop less
}

TEST_CASE("openings give a closed surface its loops", "[workshop]") {
  CHECK(text_of(sample_surface("torus.off")) == "no boundary\n");
  Openings openings;
  openings.handles = true;
  const HoledSurface cut = sample_surface("torus.off", openings);
  REQUIRE(cut.loops.size() == 2); // the two banks
  CHECK(cut.loops[0].length == Approx(cut.loops[1].length));
  CHECK(why_not_mapped(cut.mesh().surface, 2).empty());
  // One opening after another is the same as all at once.
  CHECK(text_of(opened(sample_surface("torus.off"), openings)) == text_of(cut));
}

TEST_CASE("domains have names", "[workshop]") {
  for (const MapDomain domain : {MapDomain::cylindric, MapDomain::parallel, MapDomain::concentric,
                                 MapDomain::circular, MapDomain::rectangle, MapDomain::free})
    CHECK(map_domain_named(name_of(domain)) == domain);
  CHECK_FALSE(map_domain_named("round"));
}
