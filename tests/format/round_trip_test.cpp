// SPDX-License-Identifier: GPL-2.0-or-later
// Every format that is written, over everything that the tests make: what was written, read and written again
// is the same text, byte by byte.
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/tetgen.hpp"

#include "expect.hpp"
#include "meshes.hpp"
#include "support/enumeration.hpp"
#include "support/random.hpp"
#include "support/surfaces.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/check.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

/// Of everything a document can say, something.
Document annotated(Document document, support::Random& random) {
  const int n = document.triangulation.size();
  document.metric.emplace();
  document.canonical.emplace();
  document.bundle.emplace();
  FiberCoordinates& bundle = *document.bundle;
  bundle.fiber = 3;
  bundle.base_vertices = {{0, 0, 0}, {1, 0.1, -0.0}, {0, 1, 1e-300}};
  bundle.base_triangles = {{0, 1, 2}};
  for (int t = 0; t < n; ++t) {
    auto& lengths = document.metric->edge_lengths.emplace_back();
    auto& angles = document.metric->dihedral_angles.emplace_back();
    for (int e = 0; e < 6; ++e) {
      if (random.below(5) > 0) lengths[e] = Number(10 * random.uniform());
      angles[e] = random.below(5) > 0 ? Number(3 * random.uniform()) : Number("0.10000000000000000000001");
    }
    document.canonical->cells.emplace_back("tetrahedron");
    document.canonical->cell_of.push_back(random.below(n));
    document.canonical->flat_faces.emplace_back();
    bundle.triangle_of.push_back(0);
    bundle.vertices.push_back({0, 1, 2, random.below(3)});
    bundle.levels.push_back({0, 3, 1, random.below(4)});
  }
  document.metric->volume = Number(100 * random.uniform());
  document.provenance = Json{{"seed", 1}, {"list", Json::array({1, 2.5, nullptr, "x"})}};
  document.members = Json{{"later", {{"versions", true}}}};
  return document;
}

/// Whether the format has a way to hold the triangulation.
bool survives(const Document& document, FileFormat format) {
  std::string text;
  try {
    text = write_any(document, format).text;
  } catch (const InputError&) {
    return false;
  }
  const Document back = read_any(text, "f." + name_of(format));
  CHECK(write_any(back, format).text == text);
  return true;
}

/// All formats; how many could hold it.
int survive(const Document& document, support::Random& random) {
  int held = 0;
  for (const FileFormat format :
       {FileFormat::json, FileFormat::snappea, FileFormat::signature, FileFormat::fmp}) {
    INFO(name_of(format));
    held += survives(document, format) ? 1 : 0;
    survives(annotated(document, random), format);
  }
  return held;
}

void survive_as_mesh(const Soup& soup) {
  for (const MeshFormat format :
       {MeshFormat::medit, MeshFormat::meshb, MeshFormat::gmsh, MeshFormat::vtk, MeshFormat::vtu,
        MeshFormat::json, MeshFormat::obj, MeshFormat::off, MeshFormat::stl, MeshFormat::ply}) {
    const bool holds_surfaces =
        std::find(surface_formats.begin(), surface_formats.end(), format) != surface_formats.end();
    if (holds_surfaces && soup.triangles.empty()) continue;
    INFO(name_of(format));
    const std::string text = write_soup(soup, format);
    CHECK(write_soup(read_soup(text, "f." + name_of(format)), format) == text);
  }
  const TetgenFiles files = write_tetgen(soup);
  const TetgenFiles again = write_tetgen(read_tetgen({files.node, files.ele, "f.node", "f.ele"}));
  CHECK((again.node == files.node && again.ele == files.ele));
}

void survive_as_group(const algebra::Presentation& group) {
  const std::string text = write_group_json({group.generators, group.relators, "", nullptr, nullptr});
  const GroupDocument back = read_group_json(text, "f");
  CHECK(write_group_json(back) == text);
  CHECK(algebra::Presentation{back.generators, back.relators} == group);
}

} // namespace

TEST_CASE("the zoo and the census survive every format", "[roundtrip]") {
  support::Random random(1);
  for (const support::ZooEntry& entry : support::zoo()) {
    INFO(entry.name);
    CHECK(survive(document_of(entry.triangulation(), entry.name), random) >= 2);
  }
  for (const catalogue::TableKey n : catalogue::stored_tables())
    for (const catalogue::Manifold& manifold : catalogue::stored_table(n)) {
      INFO(manifold.name);
      CHECK(survive(document_of(from_signature(manifold.signature), manifold.name), random) == 4);
    }
}

TEST_CASE("all gluings of a tetrahedron and random ones survive every format", "[roundtrip]") {
  support::Random random(2);
  support::for_each_gluing(1, [&random](const Triangulation& tri) { survive(document_of(tri), random); });
  for (int k = 0; k < 200; ++k) {
    support::RandomGluing how;
    how.tets = 1 + random.below(12);
    how.boundary_faces = random.below(how.tets);
    how.orientable = random.below(2) == 0;
    survive(document_of(support::random_gluing(how, random), "random"), random);
  }
}

TEST_CASE("all sample meshes survive every format", "[roundtrip]") {
  int meshes = 0;
  for (const std::string& path : files_below(std::string(TETRARCH_SOURCE_DIR) + "/tests/data")) {
    if (!mesh_format_for_extension(path) || path.find("knotted") != std::string::npos) continue; // its size
    INFO(path);
    survive_as_mesh(read_soup_file(path));
    ++meshes;
  }
  CHECK(meshes >= 30);
  support::Random random(3);
  for (const support::TriangleList& list :
       {support::tetrahedron_surface(), support::cube_surface(), support::icosphere(2),
        support::torus_grid(4, 5), support::genus_surface(3), support::crosscaps(3),
        support::with_holes(support::icosphere(2), 4)}) {
    Soup soup;
    soup.triangles = list.triangles;
    for (int v = 0; v < list.vertices; ++v)
      soup.points.push_back({random.uniform(), -random.uniform(), 1e-9 * random.uniform()});
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) soup.triangle_tags.push_back(random.below(5) - 2);
    survive_as_mesh(soup);
  }
}

TEST_CASE("all groups of the zoo survive", "[roundtrip]") {
  for (const support::ZooEntry& entry : support::zoo()) {
    INFO(entry.name);
    const Triangulation tri = entry.triangulation();
    const Skeleton skeleton(tri);
    const algebra::Presentation group = algebra::dual_presentation(tri, skeleton).presentation;
    survive_as_group(group);
    survive_as_group(simplified(group));
  }
}
