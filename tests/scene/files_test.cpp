// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/scene/files.hpp"

#include "scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <locale>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::scene::test;
using Catch::Matchers::Contains;

namespace {

const std::vector<SceneFormat> all_formats{SceneFormat::ply, SceneFormat::obj, SceneFormat::glb,
                                           SceneFormat::vtu};

/// What the surface formats are to hold of `one_of_each`.
std::vector<Surface> all_surfaces(const Scene& scene) {
  std::vector<Surface> out = scene.surfaces;
  for (const Tubes& t : scene.tubes) out.push_back(swept(t));
  for (const Cells& c : scene.cells) out.push_back(outer_faces(c));
  return out;
}

/// The numbers of type T from `at` on.
template <class T>
std::vector<T> numbers(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<T> out(count);
  REQUIRE(at + count * sizeof(T) <= bytes.size());
  std::memcpy(out.data(), bytes.data() + at, count * sizeof(T));
  return out;
}

/// The raw numbers of a DataArray of a VTU text.
template <class T>
std::vector<T> vtu_array(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\"");
  REQUIRE(at != std::string::npos);
  const std::size_t offset = std::stoul(text.substr(text.find("offset=\"", at) + 8));
  const std::size_t raw = text.find('_', text.find("<AppendedData")) + 1 + offset;
  const std::uint64_t bytes = numbers<std::uint64_t>(text, raw, 1)[0];
  return numbers<T>(text, raw + 8, bytes / sizeof(T));
}

} // namespace

TEST_CASE("extensions name formats of scenes in any case", "[scene]") {
  CHECK(scene_format_for_extension("a/b.ply") == SceneFormat::ply);
  CHECK(scene_format_for_extension("b.c.OBJ") == SceneFormat::obj);
  CHECK(scene_format_for_extension(".Glb") == SceneFormat::glb);
  CHECK(scene_format_for_extension("x.vtu") == SceneFormat::vtu);
  CHECK(!scene_format_for_extension("x.svg"));
  CHECK(!scene_format_for_extension("ply"));
  CHECK(!scene_format_for_extension(""));
}

TEST_CASE("PLY and OBJ are read back as the same triangles", "[scene]") {
  const Scene scene = one_of_each();
  const std::vector<Surface> surfaces = all_surfaces(scene);
  for (const SceneFormat format : {SceneFormat::ply, SceneFormat::obj}) {
    const format::Soup soup = format::read_soup(write_scene(scene, format), "scene");
    std::vector<Point> points;
    std::vector<std::array<int, 3>> triangles;
    for (const Surface& s : surfaces) {
      const int first = static_cast<int>(points.size());
      points.insert(points.end(), s.points.begin(), s.points.end());
      for (const auto& [a, b, c] : s.triangles) triangles.push_back({a + first, b + first, c + first});
    }
    CHECK(soup.points == points);
    CHECK(soup.triangles == triangles);
  }
}

TEST_CASE("PLY has colours and data on its faces and normals at its points", "[scene]") {
  const Scene scene = one_of_each();
  const std::string text = write_scene(scene, SceneFormat::ply);
  const std::string head = text.substr(0, text.find("end_header\n") + 11);
  CHECK_THAT(head, Contains("property int element\nproperty int tetrahedron\nproperty int face\n"
                            "property int edge\nproperty int cell\nend_header"));
  // By hand: 4 points, tubes of 3 * 8 + 2 and 2 * 8 + 2, two cubes of 8; 24 bytes of position, 12 of normal.
  const std::size_t faces_at = head.size() + (4 + 26 + 18 + 16) * 36;
  // 2 triangles, 2 * 8 * (3 + 2) on tubes, 12 on each cube; 13 bytes of corners, 4 of colour, 5 integers.
  constexpr std::size_t face_bytes = 13 + 4 + 20;
  REQUIRE(text.size() == faces_at + (2 + 80 + 24) * face_bytes);
  const auto row = [&](std::size_t face) { return faces_at + face * face_bytes; };
  CHECK(numbers<std::uint8_t>(text, row(1), 1) == std::vector<std::uint8_t>{3});
  CHECK(numbers<std::uint8_t>(text, row(1) + 13, 4) == std::vector<std::uint8_t>{0, 0, 128, 64});
  CHECK(numbers<int>(text, row(1) + 17, 5) == std::vector<int>{0, 5, 2, -1, -1});
  CHECK(numbers<int>(text, row(2 + 79) + 17, 5) == std::vector<int>{1, -1, -1, 8, -1});
  CHECK(numbers<int>(text, row(2 + 80 + 12) + 17, 5) == std::vector<int>{3, -1, -1, -1, 0});
  CHECK(numbers<float>(text, head.size() + 24, 3) == std::vector<float>{0, 0, 1});
  // A corner of a cube has the mean of the normals of its faces: a diagonal, up to the cut of the squares.
  const auto normal = numbers<float>(text, head.size() + std::size_t{36} * 48 + 24, 3);
  for (const float x : normal) CHECK(x < -0.3);
}

TEST_CASE("OBJ has groups, and indices for what there is", "[scene]") {
  const std::string text = write_scene(one_of_each(), SceneFormat::obj);
  CHECK_THAT(text, Contains("o unit_square\nv 0 0 0.5\n") && Contains("\nvt 1 0.25\n") &&
                       Contains("f 1/1/1 2/2/2 3/3/3\n"));
  // After 4 points with normals and textures: the tubes have no textures, and so one place for all corners.
  CHECK_THAT(text,
             Contains("\no edges\n") && Contains("\nvt 0 0\n") && Contains("\nf 5/5/5 6/5/6 14/5/14\n"));
  // 4 + 44 points before the first cube, whose first face is the bottom 0 3 2 1; its normals are means.
  CHECK_THAT(text, Contains("\no cubes\n") && Contains("\nf 49/6/49 50/7/50 51/8/51\n"));
  // Corners name the same things all over the file, for VTK's reader drops the faces otherwise: the first
  // surface has one place in the texture, and mean normals.
  Scene scene;
  scene.surfaces = {square(), square()};
  scene.surfaces[0].textures.clear();
  scene.surfaces[0].normals.clear();
  CHECK_THAT(write_scene(scene, SceneFormat::obj),
             Contains("\nf 1/1/1 2/1/2 3/1/3\n") && Contains("\nf 5/2/5 6/3/6 7/4/7\n"));
}

TEST_CASE("VTU holds triangles, polylines and cells with their data", "[scene]") {
  const std::string text = write_scene(one_of_each(), SceneFormat::vtu);
  // 2 triangles, 2 polylines, a hexahedron, 6 tetrahedra; VTK's type numbers.
  const std::vector<std::uint8_t> types{5, 5, 4, 4, 12, 10, 10, 10, 10, 10, 10};
  CHECK(vtu_array<std::uint8_t>(text, "types") == types);
  const std::vector<std::int64_t> ends{3, 6, 9, 11, 19, 23, 27, 31, 35, 39, 43};
  CHECK(vtu_array<std::int64_t>(text, "offsets") == ends);
  CHECK(vtu_array<int>(text, "element") == std::vector<int>{0, 0, 1, 1, 2, 3, 3, 3, 3, 3, 3});
  CHECK(vtu_array<int>(text, "tetrahedron") == std::vector<int>{4, 5, -1, -1, -1, -1, -1, -1, -1, -1, -1});
  CHECK(vtu_array<int>(text, "edge") == std::vector<int>{-1, -1, 7, 8, -1, -1, -1, -1, -1, -1, -1});
  const std::vector<int> corners = vtu_array<int>(text, "connectivity");
  CHECK(std::vector<int>(corners.begin(), corners.begin() + 11) ==
        std::vector<int>{0, 1, 2, 0, 2, 3, 4, 5, 6, 7, 8});
  const std::vector<double> radii = vtu_array<double>(text, "radius");
  REQUIRE(radii.size() == 4 + 5 + 8 + 8);
  CHECK(std::vector<double>(radii.begin() + 3, radii.begin() + 10) ==
        std::vector<double>{0, 0.1, 0.1, 0.05, 0.1, 0.2, 0});
  const std::vector<double> textures = vtu_array<double>(text, "texture");
  CHECK(std::vector<double>(textures.begin() + 6, textures.begin() + 9) == std::vector<double>{1, 0.25, 0});
  // The last corner of the cut cube is (1, 1, 1).
  CHECK(std::vector<double>(textures.end() - 3, textures.end()) == std::vector<double>(3, 0.125));
  CHECK(text.substr(text.size() - 28) == "\n</AppendedData>\n</VTKFile>\n");
}

TEST_CASE("VTU is read back as the same triangles and tetrahedra", "[scene]") {
  Scene scene = one_of_each();
  scene.cells.erase(scene.cells.begin()); // the reader knows no hexahedra
  const format::Soup soup = format::read_soup(write_scene(scene, SceneFormat::vtu), "scene");
  CHECK(soup.triangles == scene.surfaces[0].triangles);
  std::vector<Point> points = scene.surfaces[0].points;
  points.insert(points.end(), scene.tubes[0].points.begin(), scene.tubes[0].points.end());
  points.insert(points.end(), scene.cells[0].points.begin(), scene.cells[0].points.end());
  CHECK(soup.points == points);
  std::vector<std::array<int, 4>> tetrahedra = scene.cells[0].tetrahedra;
  for (auto& tet : tetrahedra)
    for (int& p : tet) p += 4 + 5;
  CHECK(soup.tetrahedra == tetrahedra);
}

TEST_CASE("PLY and VTU hold fields of real numbers, and NaN where there are none", "[scene]") {
  Scene scene = one_of_each();
  scene.surfaces.insert(scene.surfaces.begin(), square());
  scene.surfaces[1].cell_fields = {{"error", {1.5, 1e-300}}};
  scene.surfaces[1].point_fields = {{"angle", {0.1, -2, 3, 4}}, {"height", {5, 6, 7, 8}}};
  const auto is_nan = [](double x) { return std::isnan(x); };

  // By hand: two squares of 2 triangles and 4 points each come first.
  const std::string vtu = write_scene(scene, SceneFormat::vtu);
  const std::vector<double> errors = vtu_array<double>(vtu, "error");
  REQUIRE(errors.size() == vtu_array<std::uint8_t>(vtu, "types").size());
  CHECK(std::vector<double>(errors.begin() + 2, errors.begin() + 4) == std::vector<double>{1.5, 1e-300});
  CHECK(std::count_if(errors.begin(), errors.end(), is_nan) == static_cast<int>(errors.size()) - 2);
  const std::vector<double> angles = vtu_array<double>(vtu, "angle");
  REQUIRE(angles.size() == vtu_array<double>(vtu, "points").size() / 3);
  CHECK(std::vector<double>(angles.begin() + 4, angles.begin() + 8) == std::vector<double>{0.1, -2, 3, 4});
  CHECK(std::count_if(angles.begin(), angles.end(), is_nan) == static_cast<int>(angles.size()) - 4);
  CHECK(vtu.find("Name=\"height\"") < vtu.find("<CellData>"));
  CHECK(vtu.find("Name=\"error\"") > vtu.find("<CellData>"));

  const std::string ply = write_scene(scene, SceneFormat::ply);
  CHECK_THAT(ply, Contains("nz\nproperty double angle\nproperty double height\nelement face"));
  CHECK_THAT(ply, Contains("property int cell\nproperty double error\nend_header"));
  // 4 + 4 + 26 + 18 + 16 points of 24 bytes of position, 12 of normal, 2 doubles.
  const std::size_t points_at = ply.find("end_header\n") + 11;
  CHECK(numbers<double>(ply, points_at + 4 * 52 + 36, 2) == std::vector<double>{0.1, 5});
  CHECK(is_nan(numbers<double>(ply, points_at + 36, 1)[0]));
  // 13 bytes of corners, 4 of colour, 5 integers, then the field.
  const std::size_t faces_at = points_at + (4 + 4 + 26 + 18 + 16) * 52;
  CHECK(numbers<double>(ply, faces_at + 3 * 45 + 37, 1) == std::vector<double>{1e-300});
  CHECK(is_nan(numbers<double>(ply, faces_at + 37, 1)[0]));
  CHECK(format::read_soup(ply, "scene").triangles.size() == 2 + 2 + 80 + 24);
}

TEST_CASE("fields of cells go to VTU, and with the outer faces to PLY", "[scene]") {
  Scene scene;
  scene.cells = {cubes(2)};
  std::vector<double> quality(8);
  for (std::size_t k = 0; k < 8; ++k) quality[k] = 0.1 * static_cast<double>(k);
  std::vector<double> height;
  for (const Point& p : scene.cells[0].points) height.push_back(10 * p[2]);
  scene.cells[0].cell_fields = {{"quality", quality}};
  scene.cells[0].point_fields = {{"height", height}};
  const std::string vtu = write_scene(scene, SceneFormat::vtu);
  CHECK(vtu_array<double>(vtu, "quality") == quality);
  CHECK(vtu_array<double>(vtu, "height") == height);

  // By hand: each of the 8 cubes has 3 outer squares of 2 triangles; the middle of the 27 points is inside.
  const Surface outer = outer_faces(scene.cells[0]);
  REQUIRE(outer.points.size() == 26);
  REQUIRE(outer.point_fields.at(0).values.size() == 26);
  for (std::size_t p = 0; p < 26; ++p) CHECK(outer.point_fields[0].values[p] == 10 * outer.points[p][2]);
  REQUIRE(outer.cell_fields.at(0).values.size() == 48);
  for (std::size_t t = 0; t < 48; ++t)
    CHECK(outer.cell_fields[0].values[t] == quality[static_cast<std::size_t>(outer.data[0].values[t])]);
  const std::string ply = write_scene(scene, SceneFormat::ply);
  CHECK_THAT(ply, Contains("element vertex 26\n") && Contains("z\nproperty double height\nelement face 48") &&
                      Contains("property int cell\nproperty double quality\nend_header"));
}

TEST_CASE("an empty scene is a file all the same", "[scene]") {
  Scene nothing;
  Scene hollow;
  hollow.surfaces.resize(1);
  hollow.tubes.resize(1);
  hollow.cells.resize(1);
  for (const Scene& scene : {nothing, hollow}) {
    CHECK(write_scene(scene, SceneFormat::glb).substr(0, 4) == "glTF");
    for (const SceneFormat format : {SceneFormat::ply, SceneFormat::vtu}) {
      const format::Soup soup = format::read_soup(write_scene(scene, format), "scene");
      CHECK(soup.points.empty());
      CHECK(soup.triangles.empty());
    }
  }
  CHECK(write_scene(nothing, SceneFormat::obj).empty());
}

TEST_CASE("scenes are written alike every time and in every locale", "[scene]") {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };
  for (const SceneFormat format : all_formats) {
    const std::string before = write_scene(one_of_each(), format);
    const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string after = write_scene(one_of_each(), format);
    std::locale::global(old);
    CHECK(before == after);
  }
}

TEST_CASE("scenes that break their rules are refused", "[scene]") {
  using Spoil = std::function<void(Scene&)>;
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, Spoil>> spoils{
      {"names point 4 of 4", [](Scene& s) { s.surfaces[0].triangles[1][2] = 4; }},
      {"names point -1 of 4", [](Scene& s) { s.surfaces[0].triangles[0][0] = -1; }},
      {"3 normals, expected 4", [](Scene& s) { s.surfaces[0].normals.pop_back(); }},
      {"no unit vector",
       [](Scene& s) {
         s.surfaces[0].normals[2] = {0, 0, 0};
       }},
      {"no unit vector", [](Scene& s) { s.surfaces[0].normals[2][1] = nan; }},
      {"3 texture coordinates", [](Scene& s) { s.surfaces[0].textures.pop_back(); }},
      {"not finite", [](Scene& s) { s.surfaces[0].textures[1][1] = inf; }},
      {"not finite", [](Scene& s) { s.surfaces[0].points[1][1] = nan; }},
      {"3 colours, expected 2", [](Scene& s) { s.surfaces[0].colors.resize(3); }},
      {"1 data, expected 2", [](Scene& s) { s.surfaces[0].data[1].values.pop_back(); }},
      {"may not be called 'a b'", [](Scene& s) { s.surfaces[0].data[1].name = "a b"; }},
      {"may not be called ''", [](Scene& s) { s.surfaces[0].data[1].name = ""; }},
      {"may not be called 'element'", [](Scene& s) { s.surfaces[0].data[1].name = "element"; }},
      {"two data called 'tetrahedron'", [](Scene& s) { s.surfaces[0].data[1].name = "tetrahedron"; }},
      {"1 fields, expected 2",
       [](Scene& s) {
         s.surfaces[0].cell_fields = {{"f", {1}}};
       }},
      {"2 fields at points, expected 4",
       [](Scene& s) {
         s.surfaces[0].point_fields = {{"f", {1, 2}}};
       }},
      {"'f' has numbers that are not finite",
       [](Scene& s) {
         s.surfaces[0].cell_fields = {{"f", {1, nan}}};
       }},
      {"may not be called 'radius'",
       [](Scene& s) {
         s.surfaces[0].point_fields = {{"radius", {1, 2, 3, 4}}};
       }},
      {"may not be called 'a b'",
       [](Scene& s) {
         s.surfaces[0].cell_fields = {{"a b", {1, 2}}};
       }},
      {"two fields called 'f'",
       [](Scene& s) {
         s.surfaces[0].cell_fields = {{"f", {1, 2}}, {"f", {1, 2}}};
       }},
      {"both called 'edge'",
       [](Scene& s) {
         s.surfaces[0].cell_fields = {{"edge", {1, 2}}};
       }},
      {"4 radii, expected 5", [](Scene& s) { s.tubes[0].radii.pop_back(); }},
      {"no length", [](Scene& s) { s.tubes[0].radii[0] = -1; }},
      {"no length", [](Scene& s) { s.tubes[0].radii[0] = inf; }},
      {"fewer than two points",
       [](Scene& s) {
         s.tubes[0].starts = {0, 4, 5};
       }},
      {"fewer than two points",
       [](Scene& s) {
         s.tubes[0].starts = {0, 7, 5};
       }},
      {"begin with the first",
       [](Scene& s) {
         s.tubes[0].starts = {1, 3, 5};
       }},
      {"begin with the first",
       [](Scene& s) {
         s.tubes[0].starts = {0, 3};
       }},
      {"begin with the first", [](Scene& s) { s.tubes[0].starts.clear(); }},
      {"3 colours, expected 2", [](Scene& s) { s.tubes[0].colors.resize(3); }},
      {"names point 8 of 8", [](Scene& s) { s.cells[0].hexahedra[0][7] = 8; }},
      {"6 fields, expected 1",
       [](Scene& s) {
         s.cells[0].cell_fields = {{"f", std::vector<double>(6)}};
       }},
      {"may not be called 'texture'",
       [](Scene& s) {
         s.cells[1].point_fields = {{"texture", std::vector<double>(8)}};
       }},
      {"names point 9 of 8", [](Scene& s) { s.cells[1].tetrahedra[5][0] = 9; }},
      {"7 texture coordinates", [](Scene& s) { s.cells[0].textures.pop_back(); }},
      {"6 data, expected 7",
       [](Scene& s) {
         s.cells[1].hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7});
       }},
      {"labels that are not finite", [](Scene& s) { s.labels[0].at[0] = inf; }},
  };
  for (const auto& [message, spoil] : spoils) {
    Scene scene = one_of_each();
    spoil(scene);
    for (const SceneFormat format : all_formats) {
      INFO(message);
      CHECK_THROWS_AS(write_scene(scene, format), PreconditionError);
      CHECK_THROWS_WITH(write_scene(scene, format), Contains(message));
    }
  }
}
