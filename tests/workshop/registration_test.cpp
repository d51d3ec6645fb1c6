// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/registration.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/surface.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <tuple>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

const char* const ring_file = TETRARCH_SOURCE_DIR "/tests/data/mesh/ring_two_holes.off";

HoledSurface plain_ring() {
  return opened(surface_of(open_mesh(ring_file)));
}

/// Turned by a right angle, scaled and shifted.
HoledSurface moved_ring(double scale) {
  NumberedSurface surface = surface_of(open_mesh(ring_file));
  for (auto& [x, y, z] : surface.mesh.points)
    std::tie(x, y, z) = std::tuple(-scale * y, scale * x, scale * z + 1);
  return opened(surface);
}

} // namespace

TEST_CASE("a surface is registered with itself, moved", "[workshop]") {
  const SurfaceRegistration found = registration(plain_ring(), moved_ring(1));
  CHECK(found.verdict() == Verdict::yes);
  CHECK(found.matching == std::vector<int>{0, 1, 2});
  REQUIRE(found.search);
  CHECK(found.search->distance < 1e-9);
  CHECK(found.points.max_distance < 1e-6);
  RegisterOptions as_placed;
  as_placed.as_placed = true;
  CHECK(registration(plain_ring(), moved_ring(1), as_placed).points.mean_distance >
        1); // shifted by 1 at least
  CHECK(tree_of(found)["mean_quasiconformal"].number() == Approx(1).margin(1e-6));
  CHECK(tree_of(found)["flipped"].integer() == 0);
}

TEST_CASE("halfway to a surface of twice the size is one and a half", "[workshop]") {
  RegisterOptions given;
  given.matching = {0, 1, 2};
  const SurfaceRegistration found = registration(plain_ring(), moved_ring(2), given);
  CHECK_FALSE(found.search);
  CHECK(tree_of(found)["search"].is_null());
  CHECK(rows_of(found)[1].second == "given");
  const auto& points = found.first.mesh().points;
  // From any point to any other.
  const double own = points[0][0] - points[9][0];
  CHECK(found.points.average[0][0] - found.points.average[9][0] == Approx(1.5 * own).epsilon(1e-4));
  // The second surface's shape is where that is, a quarter turn away.
  CHECK(found.points.resampled[0][1] - found.points.resampled[9][1] == Approx(2 * own).epsilon(1e-4));
  const format::MeshDocument document = document_of(found, found.points.resampled);
  CHECK(document.soup.points == found.points.resampled);
  CHECK(format::find_field(document, "first"));
}

TEST_CASE("surfaces with other numbers of holes are refused by name", "[workshop]") {
  HoledSurface torus = opened(surface_of(open_mesh(TETRARCH_SOURCE_DIR "/tests/data/mesh/torus.off")));
  CHECK_THROWS_WITH(registration(plain_ring(), torus),
                    "the second surface: has 0 boundary loops, but the first surface has 3");
  RegisterOptions short_list;
  short_list.matching = {0, 1};
  CHECK_THROWS_AS(registration(plain_ring(), plain_ring(), short_list), PreconditionError);
}
