// SPDX-License-Identifier: GPL-2.0-or-later
#include "scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::scene::test;
using nlohmann::json;

// The rules checked here are those of the glTF 2.0 specification: 4.4 (GLB), 3.6 (buffers and accessors), 3.7
// (meshes). The files of `one_of_each` and of 1,000,000 triangles in 1000 colours have also passed Khronos's
// gltf-validator 2.0.0-dev.3.10 without an error or a warning.

namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t out = 0;
  REQUIRE(at + 4 <= bytes.size());
  std::memcpy(&out, bytes.data() + at, 4);
  return out;
}

/// The two chunks of a GLB.
struct Container {
  json document;
  std::string binary;
};

Container opened(const std::string& bytes) {
  REQUIRE(bytes.substr(0, 4) == "glTF");
  CHECK(word(bytes, 4) == 2);
  CHECK(word(bytes, 8) == bytes.size());
  const std::size_t length = word(bytes, 12);
  CHECK(length % 4 == 0);
  CHECK(bytes.substr(16, 4) == "JSON");
  Container out{json::parse(bytes.substr(20, length)), ""};
  if (bytes.size() == 20 + length) return out;
  CHECK(word(bytes, 20 + length) == bytes.size() - 28 - length);
  CHECK(bytes.substr(24 + length, 4) == std::string("BIN\0", 4));
  out.binary = bytes.substr(28 + length);
  CHECK(out.binary.size() % 4 == 0);
  CHECK(out.document["buffers"] == json::array({{{"byteLength", out.binary.size()}}}));
  return out;
}

template <class T>
std::vector<T> values(const Container& glb, std::size_t accessor) {
  const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const json& said = glb.document["accessors"][accessor];
  const json& view = glb.document["bufferViews"][said["bufferView"].get<std::size_t>()];
  const std::size_t count = said["count"].get<std::size_t>() * widths.at(said["type"].get<std::string>());
  CHECK(view["byteLength"] == count * sizeof(T));
  CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
  REQUIRE(view["byteOffset"].get<std::size_t>() + count * sizeof(T) <= glb.binary.size());
  std::vector<T> out(count);
  std::memcpy(out.data(), glb.binary.data() + view["byteOffset"].get<std::size_t>(), count * sizeof(T));
  return out;
}

/// A triangle with all that is said of its corners.
using Corner = std::vector<double>;
using Triangle = std::array<Corner, 3>;

std::uint16_t bits(double light) {
  return static_cast<std::uint16_t>(std::lround(65535 * light));
}

/// IEC 61966-2-1, of an 8-bit component.
double light(int component) {
  const double x = component / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::vector<Triangle> expected_triangles(const Surface& s) {
  std::vector<Triangle> out;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const int p = s.triangles[t][i];
      for (const double x : s.points[p]) triangle[i].push_back(static_cast<float>(x));
      if (!s.normals.empty())
        for (const double x : s.normals[p]) triangle[i].push_back(static_cast<float>(x));
      if (!s.textures.empty()) {
        triangle[i].push_back(static_cast<float>(s.textures[p][0]));
        triangle[i].push_back(static_cast<float>(1 - s.textures[p][1]));
      }
      if (s.colors.size() > 1) {
        const Color c = s.colors[t];
        for (const int x : {c.red, c.green, c.blue}) triangle[i].push_back(bits(light(x)));
        triangle[i].push_back(bits(c.alpha / 255.0));
      }
    }
    out.push_back(triangle);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Triangle> found_triangles(const Container& glb, const json& primitive) {
  std::vector<Corner> corners;
  const auto append = [&](const char* name, std::size_t width, auto zero) {
    if (!primitive["attributes"].contains(name)) return;
    const auto all = values<decltype(zero)>(glb, primitive["attributes"][name].get<std::size_t>());
    corners.resize(all.size() / width);
    for (std::size_t i = 0; i < all.size(); ++i) corners[i / width].push_back(all[i]);
  };
  append("POSITION", 3, float{});
  append("NORMAL", 3, float{});
  append("TEXCOORD_0", 2, float{});
  append("COLOR_0", 4, std::uint16_t{});
  const auto indices = values<std::uint32_t>(glb, primitive["indices"].get<std::size_t>());
  std::vector<Triangle> out(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i) out[i / 3][i % 3] = corners.at(indices[i]);
  std::sort(out.begin(), out.end());
  return out;
}

Scene of(Surface surface) {
  Scene scene;
  scene.surfaces = {std::move(surface)};
  return scene;
}

} // namespace

TEST_CASE("GLB holds every triangle with its normals, textures and colours", "[scene]") {
  const Scene scene = one_of_each();
  const Container glb = opened(write_scene(scene, SceneFormat::glb));
  std::vector<Surface> surfaces = scene.surfaces;
  surfaces.push_back(swept(scene.tubes[0]));
  for (const Cells& cells : scene.cells) surfaces.push_back(outer_faces(cells));
  const json& meshes = glb.document["meshes"];
  REQUIRE(meshes.size() == surfaces.size());
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    CHECK(meshes[k]["name"] == surfaces[k].name);
    REQUIRE(meshes[k]["primitives"].size() == 1);
    CHECK(found_triangles(glb, meshes[k]["primitives"][0]) == expected_triangles(surfaces[k]));
  }
}

TEST_CASE("GLB says the least and greatest coordinates and what its views are for", "[scene]") {
  const Container glb = opened(write_scene(one_of_each(), SceneFormat::glb));
  const json& views = glb.document["bufferViews"];
  std::size_t end = 0;
  for (const json& view : views) {
    CHECK(view["byteOffset"] == end);
    end += view["byteLength"].get<std::size_t>();
  }
  CHECK(end == glb.binary.size());
  for (const json& mesh : glb.document["meshes"]) {
    const json& primitive = mesh["primitives"][0];
    const auto position = primitive["attributes"]["POSITION"].get<std::size_t>();
    const auto all = values<float>(glb, position);
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<float> column;
      for (std::size_t v = i; v < all.size(); v += 3) column.push_back(all[v]);
      const auto [least, greatest] = std::minmax_element(column.begin(), column.end());
      CHECK(glb.document["accessors"][position]["min"][i].get<double>() == *least);
      CHECK(glb.document["accessors"][position]["max"][i].get<double>() == *greatest);
    }
    for (const auto& [name, accessor] : primitive["attributes"].items()) {
      const json& said = glb.document["accessors"][accessor.get<std::size_t>()];
      CHECK(said["componentType"] == (name == "COLOR_0" ? 5123 : 5126)); // unsigned short, float
      CHECK(said.value("normalized", false) == (name == "COLOR_0"));
      CHECK(said["count"].get<std::size_t>() == all.size() / 3);
      CHECK(views[said["bufferView"].get<std::size_t>()]["target"] == 34962); // ARRAY_BUFFER
    }
    const json& indices = glb.document["accessors"][primitive["indices"].get<std::size_t>()];
    CHECK(indices["componentType"] == 5125);                                   // unsigned int
    CHECK(views[indices["bufferView"].get<std::size_t>()]["target"] == 34963); // ELEMENT_ARRAY_BUFFER
  }
}

TEST_CASE("GLB turns the scene upright below one node and names everything", "[scene]") {
  const Scene scene = one_of_each();
  const Container glb = opened(write_scene(scene, SceneFormat::glb));
  const json& nodes = glb.document["nodes"];
  CHECK(glb.document["scenes"][glb.document["scene"].get<std::size_t>()]["nodes"] == json::array({0}));
  CHECK(nodes[0]["name"] == scene.title);
  CHECK(nodes[0]["children"] == json::array({1, 2, 3, 4, 5}));
  // The quaternion (axis s, w) turns z, the scene's up, into glTF's y: v + 2w (s x v) + 2 s x (s x v).
  const auto q = nodes[0]["rotation"].get<std::array<double, 4>>();
  const Point s{q[0], q[1], q[2]};
  const auto times = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Point up{0, 0, 1};
  const Point once = times(s, up);
  const Point twice = times(s, once);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(up[i] + 2 * q[3] * once[i] + 2 * twice[i] - (i == 1)) < 1e-15);
  CHECK(nodes[1]["name"] == "unit square");
  CHECK(nodes[5] == json{{"name", "north"}, {"translation", {0.0, 0.0, 1.25}}});
}

TEST_CASE("GLB has a material for each colour, and blends what is translucent", "[scene]") {
  Scene scene;
  for (const Color color : {Color{255, 0, 51, 255}, Color{1, 1, 1, 128}, Color{255, 0, 51, 255}}) {
    scene.surfaces.push_back(square());
    scene.surfaces.back().colors = {color};
  }
  scene.surfaces.push_back(square());
  const json document = opened(write_scene(scene, SceneFormat::glb)).document;
  const auto material = [&](std::size_t k) { return document["meshes"][k]["primitives"][0]["material"]; };
  CHECK(material(0) == material(2));
  const json& materials = document["materials"];
  REQUIRE(materials.size() == 3);
  const auto factor = [&](std::size_t k) {
    return materials[k]["pbrMetallicRoughness"]["baseColorFactor"].get<std::array<double, 4>>();
  };
  CHECK(factor(0) == std::array{1.0, 0.0, light(51), 1.0});
  CHECK(!materials[0].contains("alphaMode"));
  CHECK(factor(1) == std::array{light(1), light(1), light(1), 128 / 255.0});
  CHECK(materials[1]["alphaMode"] == "BLEND");
  CHECK(factor(2) == std::array{1.0, 1.0, 1.0, 1.0}); // the colours are those of the points
  CHECK(materials[2]["alphaMode"] == "BLEND");
  for (const json& m : materials) CHECK(m["doubleSided"] == true);
}

TEST_CASE("GLB doubles points only where colours meet", "[scene]") {
  // A fan of 12 triangles around a point, in three colours that come and go.
  Surface fan;
  fan.points = {{0, 0, 0}};
  const std::array<Color, 3> colors{{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}}};
  for (int i = 0; i < 12; ++i) {
    fan.points.push_back({std::cos(i * 0.5236), std::sin(i * 0.5236), 0});
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
    fan.colors.push_back(colors[i / 2 % 3]);
  }
  const Container glb = opened(write_scene(of(fan), SceneFormat::glb));
  const json& primitive = glb.document["meshes"][0]["primitives"][0];
  CHECK(found_triangles(glb, primitive) == expected_triangles(fan));
  // By hand: the middle has three colours; a colour changes at every other point of the rim.
  const std::size_t position = primitive["attributes"]["POSITION"].get<std::size_t>();
  CHECK(glb.document["accessors"][position]["count"] == 3 + 6 + 2 * 6);
}

TEST_CASE("GLB refuses what single precision cannot hold", "[scene]") {
  Surface far = square();
  far.points[1][0] = 1e39;
  CHECK_THROWS_AS(write_scene(of(far), SceneFormat::glb), PreconditionError);
  CHECK_NOTHROW(write_scene(of(far), SceneFormat::vtu));
}

TEST_CASE("GLB takes names that are no UTF-8", "[scene]") {
  Surface surface = square();
  surface.name = "a\xff\n\"b";
  const Container glb = opened(write_scene(of(surface), SceneFormat::glb));
  CHECK(glb.document["meshes"][0]["name"] == "a\xef\xbf\xbd\n\"b"); // U+FFFD
}
