// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/product.hpp"

#include "product/solids.hpp"
#include "scene/scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/scene/files.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::show;
using namespace tetrarch::scene::test;

namespace {

/// A bent plate with two holes; (x, y, t) of the plan are as good as any coordinates. What the partition has
/// for walls does not matter here: each is 2.
struct Bent {
  support::Extrusion from = support::bent(2, 4, 2);
  product::Solid solid = product::solid_of(from.mesh);
  product::Partition partition;

  Bent() {
    partition.patch = bases(solid, from);
    for (int& patch : partition.patch)
      if (patch < 0) patch = product::first_wall;
  }
};

} // namespace

TEST_CASE("a product is its tetrahedra with coordinates, in space and in the domain", "[scene]") {
  const Bent bent;
  const Cells cells = product_cells(bent.solid, bent.from.at);
  CHECK(cells.points == bent.solid.mesh.points);
  CHECK(cells.tetrahedra == bent.solid.mesh.tetrahedra);
  CHECK(cells.textures == bent.from.at);
  for (std::size_t v = 0; v < cells.points.size(); ++v)
    CHECK(cells.point_fields.at(0).values[v] == bent.from.at[v][2]);
  const Cells domain = domain_cells(bent.solid, bent.from.at);
  CHECK(domain.points == bent.from.at);
  CHECK(domain.textures == cells.textures);
  // A rectangle of 2 x 1 without two disks of diameter 1/2, by 16-gons: 16 sin(pi/8)/2 r^2 each.
  const double disks = 2 * 8 * std::sin(std::numbers::pi / 8) / 16;
  CHECK(enclosed_volume(outer_faces(domain)) == Approx(2 - disks));

  auto too_short = bent.from.at;
  too_short.pop_back();
  CHECK_THROWS_AS(product_cells(bent.solid, too_short), PreconditionError);
  CHECK_THROWS_AS(boundary_surface(bent.solid, bent.partition, too_short), PreconditionError);
}

TEST_CASE("the boundary of a product shows its patches, its textures and its field", "[scene]") {
  const Bent bent;
  const Surface surface = boundary_surface(bent.solid, bent.partition, bent.from.at);
  const Surface domain = domain_surface(bent.solid, bent.partition, bent.from.at);
  CHECK(is_closed(surface));
  CHECK(euler_characteristic(surface) == 2 - 2 * 2);
  CHECK(enclosed_volume(domain) ==
        Approx(enclosed_volume(outer_faces(domain_cells(bent.solid, bent.from.at)))));
  CHECK(surface.triangles == domain.triangles);
  CHECK(surface.textures == domain.textures);
  REQUIRE(surface.colors.size() == surface.triangles.size());
  for (std::size_t p = 0; p < domain.points.size(); ++p) {
    CHECK(domain.textures[p][0] == domain.points[p][0]);
    CHECK(domain.textures[p][1] == domain.points[p][1]);
    CHECK(domain.point_fields.at(0).values[p] == domain.points[p][2]);
  }
  // In the domain the floor is what lies at w = 0 and the ceiling what lies at w = 1.
  std::set<std::array<int, 4>> colors;
  for (std::size_t t = 0; t < domain.triangles.size(); ++t) {
    const int patch = domain.data.at(0).values[t];
    for (const int p : domain.triangles[t])
      if (patch < 2) CHECK(domain.points[static_cast<std::size_t>(p)][2] == patch);
    colors.insert({domain.colors[t].red, domain.colors[t].green, domain.colors[t].blue, patch});
  }
  CHECK(colors.size() == 3);
}

TEST_CASE("a product is written as VTU and read back", "[scene]") {
  const Bent bent;
  Scene scene;
  scene.cells = {product_cells(bent.solid, bent.from.at)};
  scene.surfaces = {boundary_surface(bent.solid, bent.partition, bent.from.at)};
  const format::Soup soup = format::read_soup(write_scene(scene, SceneFormat::vtu), "scene");
  CHECK(soup.tetrahedra.size() == bent.solid.mesh.tetrahedra.size());
  CHECK(soup.triangles.size() == static_cast<std::size_t>(bent.solid.boundary.triangle_count()));
}

TEST_CASE("fibres are polylines one after the other", "[scene]") {
  const Tubes tubes = fibers({{{0, 0, 0}, {0, 0, 1}, {0, 1, 2}}, {{1, 0, 0}, {1, 0, 6}}});
  CHECK(tubes.starts == std::vector<int>{0, 3, 5});
  CHECK(tubes.points[4] == Point{1, 0, 6});
  CHECK(tubes.data.at(0).values == std::vector<int>{0, 1});
  CHECK(tubes.radii == std::vector<double>(5, 0.01));
  CHECK(fibers({}).starts == std::vector<int>{0});
  CHECK(is_closed(swept(tubes)));
}

TEST_CASE("hexahedra keep their order, their layers and their quality", "[scene]") {
  const Cells grid = cubes(3);
  HexahedraData data;
  for (std::size_t k = 0; k < grid.hexahedra.size(); ++k) {
    data.layer.push_back(static_cast<int>(k / 9));
    data.quality.push_back(1.0 / static_cast<double>(k + 1));
  }
  const Cells cells = hexahedra(grid.points, grid.hexahedra, data);
  CHECK(cells.hexahedra == grid.hexahedra);
  CHECK(cells.data.at(0).values == data.layer);
  CHECK(cells.cell_fields.at(0).values == data.quality);
  CHECK(write_scene(Scene{"", {}, {}, {cells}, {}}, SceneFormat::vtu).find("quality") != std::string::npos);
  // Outside of a cube of 3 x 3 x 3 there are 54 squares, so half of 4 * 54 edges, each of length 1.
  const Tubes edges = outer_edges(cells);
  REQUIRE(edges.starts.size() == 1 + 108);
  for (std::size_t k = 0; k < 108; ++k)
    CHECK(norm(minus(edges.points[2 * k], edges.points[2 * k + 1])) == Approx(1));
}
