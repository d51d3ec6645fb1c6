// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/quads.hpp"

#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/scene/files.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::show;

slit::QuadMesh two_quads() {
  slit::QuadMesh mesh;
  mesh.points = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 1, 0}, {0, 1, 0}, {2, 0, -1e-7}, {2, 1, 0}};
  mesh.quads = {{0, 1, 2, 3}, {1, 4, 5, 2}};
  mesh.angles = {0, 1, 2};
  return mesh;
}

/// By hand: vertices count from 1 there.
TEST_CASE("Quads are written as OBJ with four vertices each") {
  CHECK(quads_obj(two_quads()) == "v 0 0 0\nv 0.1 0 0\nv 0.1 1 0\nv 0 1 0\nv 2 0 -1e-07\nv 2 1 0\n"
                                  "f 1 2 3 4\nf 2 5 6 3\n");
}

TEST_CASE("The picture of quads has two triangles for each, and a tube for each edge by its kind") {
  const Scene scene = quad_scene(two_quads());
  REQUIRE(scene.surfaces.size() == 1);
  CHECK(scene.surfaces[0].triangles.size() == 4);
  REQUIRE(scene.tubes.size() == 1);
  // The middle one of seven edges is inside; it is vertical.
  std::vector<int> kinds = scene.tubes[0].data.at(0).values;
  CHECK(kinds.size() == 7);
  CHECK(std::count(kinds.begin(), kinds.end(), static_cast<int>(slit::Line::vertical)) == 1);
  CHECK(std::count(kinds.begin(), kinds.end(), static_cast<int>(slit::Line::boundary)) == 6);
  for (const SceneFormat format : {SceneFormat::ply, SceneFormat::obj, SceneFormat::glb, SceneFormat::vtu})
    CHECK_FALSE(write_scene(scene, format).empty());
}

} // namespace
