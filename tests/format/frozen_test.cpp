// SPDX-License-Identifier: GPL-2.0-or-later
// The files of tests/data/frozen are read, and come out with the same bytes, in this version and in all later
// ones. Their witness is the program that wrote them (see the README there).
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/tetgen.hpp"

#include "expect.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

/// The file read by whatever reader it is for, and written again; of TetGen's the .node file.
std::string rewritten(const std::string& path) {
  const std::string text = read_file(path);
  if (looks_like_group_json(text)) return write_group_json(read_group_json(text, path));
  if (looks_like_mesh_json(text)) return write_mesh_json(read_mesh_json(text, path));
  const auto mesh = recognise_mesh(text, path);
  if (mesh == MeshFormat::tetgen) {
    const TetgenFiles files = write_tetgen(read_soup_file(path));
    return has_extension(path, ".ele") ? files.ele : files.node;
  }
  if (mesh) return write_soup(read_soup(text, path), *mesh);
  return write_any(read_any(text, path), *recognise(text, path)).text;
}

std::vector<std::string> frozen() {
  return files_below(std::string(TETRARCH_SOURCE_DIR) + "/tests/data/frozen");
}

} // namespace

TEST_CASE("frozen files are read and written as they were", "[frozen]") {
  int count = 0;
  for (const std::string& path : frozen()) {
    if (has_extension(path, ".md")) continue;
    INFO(path);
    ++count;
    // Gmsh cannot open what was written then, for its elements are on entities that are not announced. It is
    // read as ever, and its bytes are not written again.
    if (has_extension(path, ".msh")) {
      const Soup soup = read_soup_file(path);
      const Soup same = read_soup_file(with(path, ".msh", ".mesh"));
      CHECK((soup.points == same.points && soup.triangles == same.triangles &&
             soup.tetrahedra == same.tetrahedra && soup.triangles.size() > 0));
      continue;
    }
    CHECK(rewritten(path) == read_file(path));
  }
  CHECK(count >= 34); // as many as there were when the corpus began
}

// The witness of the names is Frigerio, Martelli, Petronio 2004, as in tests/canonical; the faces are those
// of the file, looked at.
TEST_CASE("canonical cells come back as values", "[frozen]") {
  const Document document =
      read_document(std::string(TETRARCH_SOURCE_DIR) + "/tests/data/frozen/1/octahedron.json");
  REQUIRE(document.canonical.has_value());
  CHECK(document.canonical->cells == std::vector<std::string>{"octahedron"});
  CHECK(document.canonical->cell_of == std::vector<int>(4, 0));
  CHECK(document.canonical->flat_faces[0] == std::array<bool, 4>{false, true, true, false});
}

// A cube has 12 triangles and a sphere's unit tangent bundle the Euler number 2.
TEST_CASE("fibre coordinates come back as values", "[frozen]") {
  const Document document =
      read_document(std::string(TETRARCH_SOURCE_DIR) + "/tests/data/frozen/1/bundle.json");
  REQUIRE(document.bundle.has_value());
  const FiberCoordinates& bundle = *document.bundle;
  CHECK(bundle.fiber == 1);
  CHECK(bundle.euler_number == 2);
  CHECK(document.triangulation.size() == 3 * static_cast<int>(bundle.base_triangles.size()));
  // Over one triangle, three tetrahedra, and within each: vertices of that triangle.
  for (std::size_t t = 0; t < bundle.triangle_of.size(); ++t) {
    const auto& corners = bundle.base_triangles[bundle.triangle_of[t]];
    for (const int v : bundle.vertices[t]) CHECK(std::count(corners.begin(), corners.end(), v) == 1);
  }
}

// Each vertex of the box over the floor z = 0: w is its height over the floor times a constant, by symmetry.
TEST_CASE("coordinates of a product come back as values", "[frozen]") {
  const std::string path = std::string(TETRARCH_SOURCE_DIR) + "/tests/data/frozen/1/product.json";
  const MeshDocument mesh = read_mesh_json(read_file(path), path);
  const MeshField* const uvw = find_field(mesh, "uvw");
  REQUIRE(uvw != nullptr);
  REQUIRE(uvw->components == 3);
  const double height = uvw->values.back() / 2;
  for (std::size_t v = 0; v < mesh.soup.points.size(); ++v)
    CHECK(uvw->values[3 * v + 2] == Approx(mesh.soup.points[v][2] * height).margin(1e-12));
}
