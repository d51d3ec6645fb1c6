// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/scene/page.hpp"

#include "scenes.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::scene::test;

namespace {

/// The unit square with its own coordinates as textures, stretched by 3 upwards in space; one tube.
Scene stretched() {
  Scene scene;
  scene.surfaces = {square()};
  scene.surfaces[0].points = {{0, 0, 7}, {1, 0, 7}, {1, 3, 7}, {0, 3, 7}};
  scene.surfaces[0].textures = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.tubes = {tubes()};
  return scene;
}

nlohmann::json data_of(const Scene& surface, const Scene& domain) {
  return nlohmann::json::parse(page_data(TexturePage{"</script>", {}, surface, domain}));
}

} // namespace

TEST_CASE("a page of textures holds two scenes, and what they share once", "[scene]") {
  const Scene domain = stretched();
  Scene surface = domain;
  surface.surfaces[0].points[3] = {0, 3, 0};
  const auto data = data_of(surface, domain);
  CHECK(data["format"] == "tetrarch texture");
  CHECK(data["title"] == "</script>");
  REQUIRE(data["panes"].size() == 2);
  CHECK(data["panes"][0]["name"] == "unit square");
  CHECK(data["panes"][0]["flat"] == false);
  CHECK(data["panes"][1]["flat"] == true);
  for (const char* shared : {"triangles", "textures"}) {
    CHECK(data["panes"][0].contains(shared));
    CHECK(!data["panes"][1].contains(shared));
  }
  // Base 64: four digits for every three bytes, padded. 4 points and 5 of the tubes, of 3 floats.
  CHECK(data["panes"][1]["points"].get<std::string>().size() == 4 * 12 / 3 * 4);
  const auto& lines = data["panes"][1]["lines"][0];
  CHECK(lines["points"].get<std::string>().size() == 5 * 12 / 3 * 4);
  CHECK(lines["starts"] == nlohmann::json({0, 3, 5}));
  CHECK(lines["numbers"] == nlohmann::json({0, 1}));
  CHECK(lines["colours"][1] == nlohmann::json({1, 2, 3}));

  Scene other = domain;
  other.surfaces[0].textures[0] = {0.5, 0};
  other.tubes[0].data = {{"loop", {4, 4}}};
  const auto differing = data_of(surface, other)["panes"][1];
  CHECK(differing.contains("textures"));
  CHECK(!differing.contains("triangles"));
  CHECK(differing["lines"][0]["numbers"] == nlohmann::json({4, 4}));
}

TEST_CASE("a page of textures holds fields, patches and fibres", "[scene]") {
  Scene surface = stretched();
  const auto bare = data_of(surface, surface);
  CHECK(bare["panes"][0]["field"].is_null());
  CHECK(bare["panes"][0]["patches"].is_null());
  CHECK(bare["lines"] == "Loops");
  surface.surfaces[0].point_fields = {{"w", {0, 0.5, 1, 2}}, {"error", {0, 0, 0, 0}}};
  surface.surfaces[0].data = {{"patch", {2, 0}}};
  surface.tubes[0].data = {{"fiber", {0, 1}}};
  Scene domain = surface;
  domain.surfaces[0].point_fields.clear();
  const auto data = nlohmann::json::parse(page_data(TexturePage{"", {}, surface, domain, "Fibres", 1.0}));
  CHECK(data["lines"] == "Fibres");
  CHECK(data["v_by_u"] == 1); // and not 3, which the domain says
  const auto& pane = data["panes"][0];
  CHECK(pane["field"]["name"] == "w");
  // By hand: little-endian floats 0, 0.5, 1, 2 end in 3f, 3f80, 40; 32-bit integers 2, 0.
  CHECK(pane["field"]["values"] == "AAAAAAAAAD8AAIA/AAAAQA==");
  CHECK(pane["patches"]["of"] == "AgAAAAAAAAA=");
  CHECK(pane["patches"]["list"] == nlohmann::json::parse(R"([
    {"number": 0, "name": "floor", "colour": [0, 0, 128]}, {"number": 2, "name": "wall 0", "colour": [255, 0, 0]}
  ])"));
  CHECK(pane["lines"][0]["numbers"] == nlohmann::json::array());
  // The domain has the same patches, and no field.
  CHECK(data["panes"][1]["field"].is_null());
  CHECK(data["panes"][1].contains("field"));
  CHECK(!data["panes"][1].contains("patches"));
  surface.surfaces[0].data[0].values[0] = -1;
  CHECK_THROWS_AS(page_data(TexturePage{"", {}, surface, domain}), PreconditionError);
}

TEST_CASE("patterns on a page of textures are square in the domain", "[scene]") {
  CHECK(data_of(stretched(), stretched())["v_by_u"].get<double>() == Approx(3));
  // Texture coordinates that are turned: v goes along x.
  Scene turned = stretched();
  for (auto& uv : turned.surfaces[0].textures) std::swap(uv[0], uv[1]);
  CHECK(data_of(turned, turned)["v_by_u"].get<double>() == Approx(1 / 3.0));
  // A domain without area has no squares.
  Scene line = stretched();
  for (Point& p : line.surfaces[0].points) p = {1, 2, 3};
  CHECK(data_of(line, line)["v_by_u"] == 1);
}

TEST_CASE("a page of textures needs textures, and scenes that are sound", "[scene]") {
  const Scene good = stretched();
  Scene bare = good;
  bare.surfaces[0].textures.clear();
  Scene spoilt = good;
  spoilt.surfaces[0].points[0][0] = std::numeric_limits<double>::quiet_NaN();
  for (const Scene& bad : {Scene{}, bare, spoilt}) {
    CHECK_THROWS_AS(page_data(TexturePage{"", {}, good, bad}), PreconditionError);
    CHECK_THROWS_AS(page_data(TexturePage{"", {}, bad, good}), PreconditionError);
  }
}
