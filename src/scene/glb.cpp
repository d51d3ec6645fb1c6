// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "writers.hpp"

#include "tetrarch/core/error.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

namespace tetrarch::scene {
namespace {

using nlohmann::json;

// The numbers by which glTF calls types of components, and what a view of a buffer is for.
constexpr int unsigned_short = 5123;
constexpr int unsigned_int = 5125;
constexpr int single_float = 5126;
constexpr int for_vertices = 34962;
constexpr int for_indices = 34963;

/// Neither mirror nor chalk.
constexpr double roughness = 0.8;

/// What a mesh takes in the text, about.
constexpr std::size_t json_bytes = 1500;

float narrowed(double x) {
  if (std::abs(x) > std::numeric_limits<float>::max())
    throw PreconditionError("a coordinate that GLB's single precision cannot hold");
  return static_cast<float>(x);
}

/// The intensity of light, up to 1, that screens show for a component of a colour (sRGB, IEC 61966-2-1).
double linear(std::uint8_t component) {
  const double x = component / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::uint16_t linear_bits(std::uint8_t component) {
  static const auto table = [] {
    std::array<std::uint16_t, 256> out{};
    for (std::size_t i = 0; i < 256; ++i)
      out[i] = static_cast<std::uint16_t>(std::lround(65535 * linear(static_cast<std::uint8_t>(i))));
    return out;
  }();
  return table[component];
}

/// Points that have one colour each, and the triangles on them. Where triangles of k colours meet, the point
/// is there k times.
struct Painted {
  std::vector<int> points; ///< of the surface
  std::vector<Color> colors;
  std::vector<std::array<int, 3>> triangles;
};

/// Triangles are taken colour by colour, so that one mark a point tells whether it has been met in this
/// colour.
Painted painted(const Surface& surface) {
  const auto key = [&](std::size_t t) {
    const Color c = surface.colors[t];
    return std::tuple(c.alpha, c.red, c.green, c.blue);
  };
  std::vector<std::uint32_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto s, auto t) { return key(s) < key(t); });
  Painted out;
  out.triangles.reserve(order.size());
  std::vector<int> copy(surface.points.size(), -1); // the last one of each point
  int first_of_color = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i]) != key(order[i - 1])) first_of_color = static_cast<int>(out.points.size());
    std::array<int, 3> triangle = surface.triangles[order[i]];
    for (int& p : triangle) {
      if (copy[p] < first_of_color) {
        copy[p] = static_cast<int>(out.points.size());
        out.points.push_back(p);
        out.colors.push_back(surface.colors[order[i]]);
      }
      p = copy[p];
    }
    out.triangles.push_back(triangle);
  }
  return out;
}

/// A mesh for each surface, a node for each mesh and label, all below one node that turns z upwards into y
/// upwards. The JSON part comes first in the file but is known last, so it is put before the bytes in the
/// end, within what was reserved.
class GlbWriter {
public:
  explicit GlbWriter(std::size_t expected_bytes) { bytes_.reserve(expected_bytes); }

  void add(const Surface& surface) {
    if (surface.triangles.empty()) return;
    json primitive;
    if (surface.colors.size() > 1) {
      const Painted paint = painted(surface);
      primitive = geometry(surface, paint.triangles, paint.points.size(),
                           [&](std::size_t v) { return static_cast<std::size_t>(paint.points[v]); });
      primitive["attributes"]["COLOR_0"] = color_accessor(paint.colors);
      const bool opaque =
          std::all_of(paint.colors.begin(), paint.colors.end(), [](Color c) { return c.alpha == 255; });
      primitive["material"] = material({255, 255, 255, 255}, !opaque);
    } else {
      primitive =
          geometry(surface, surface.triangles, surface.points.size(), [](std::size_t v) { return v; });
      const Color color = color_of(surface.colors, 0);
      primitive["material"] = material(color, color.alpha < 255);
    }
    add_node({{"name", surface.name}, {"mesh", meshes_.size()}});
    meshes_.push_back({{"name", surface.name}, {"primitives", json::array({std::move(primitive)})}});
  }

  void add(const Label& label) {
    add_node({{"name", label.text},
              {"translation", {narrowed(label.at[0]), narrowed(label.at[1]), narrowed(label.at[2])}}});
  }

  std::string write(const std::string& title) && {
    std::string text = document(title).dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t body = bytes_.empty() ? 0 : 8 + bytes_.size();
    const std::size_t total = 12 + 8 + text.size() + body;
    if (total > std::numeric_limits<std::uint32_t>::max())
      throw PreconditionError("the scene does not fit into the four gigabytes of a GLB");
    std::string head = "glTF";
    for (const std::size_t number : {std::size_t{2}, total, text.size()})
      append_little(head, static_cast<std::uint32_t>(number));
    head += "JSON" + text;
    if (body > 0) {
      append_little(head, static_cast<std::uint32_t>(bytes_.size()));
      head += std::string_view("BIN\0", 4);
    }
    bytes_.insert(0, head);
    return std::move(bytes_);
  }

private:
  /// The attributes and indices of one primitive, whose vertex v is point `point(v)` of the surface.
  template <class PointOf>
  json geometry(const Surface& surface, const std::vector<std::array<int, 3>>& triangles,
                std::size_t vertices, PointOf point) {
    json attributes;
    attributes["POSITION"] = position_accessor(surface.points, vertices, point);
    if (!surface.normals.empty())
      attributes["NORMAL"] = accessor("VEC3", single_float, vertices, for_vertices, [&] {
        for (std::size_t v = 0; v < vertices; ++v)
          for (const double x : surface.normals[point(v)]) append_little(bytes_, narrowed(x));
      });
    if (!surface.textures.empty())
      attributes["TEXCOORD_0"] = accessor("VEC2", single_float, vertices, for_vertices, [&] {
        for (std::size_t v = 0; v < vertices; ++v) {
          const auto& [right, up] = surface.textures[point(v)];
          append_little(bytes_, narrowed(right));
          append_little(bytes_, narrowed(1 - up)); // an image begins at its top
        }
      });
    const int indices = accessor("SCALAR", unsigned_int, 3 * triangles.size(), for_indices, [&] {
      for (const auto& corners : triangles)
        for (const int corner : corners) append_little(bytes_, static_cast<std::uint32_t>(corner));
    });
    return {{"attributes", std::move(attributes)}, {"indices", indices}};
  }

  template <class PointOf>
  int position_accessor(const std::vector<Point>& points, std::size_t vertices, PointOf point) {
    std::array<float, 3> least{};
    std::array<float, 3> greatest{};
    least.fill(std::numeric_limits<float>::max());
    greatest.fill(std::numeric_limits<float>::lowest());
    const int number = accessor("VEC3", single_float, vertices, for_vertices, [&] {
      for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t i = 0; i < 3; ++i) {
          const float x = narrowed(points[point(v)][i]);
          least[i] = std::min(least[i], x);
          greatest[i] = std::max(greatest[i], x);
          append_little(bytes_, x);
        }
    });
    accessors_[number]["min"] = least;
    accessors_[number]["max"] = greatest;
    return number;
  }

  int color_accessor(const std::vector<Color>& colors) {
    const int number = accessor("VEC4", unsigned_short, colors.size(), for_vertices, [&] {
      for (const Color c : colors) {
        for (const std::uint8_t x : {c.red, c.green, c.blue}) append_little(bytes_, linear_bits(x));
        append_little(bytes_, static_cast<std::uint16_t>(257 * c.alpha));
      }
    });
    accessors_[number]["normalized"] = true;
    return number;
  }

  /// Its number. All that `append` appends is a view of its own; every kind of element here is a multiple of
  /// four bytes long, which is the alignment that glTF asks for.
  template <class Append>
  int accessor(const char* type, int component, std::size_t count, int target, Append append) {
    const std::size_t begin = bytes_.size();
    append();
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  /// The number of the material, which is made when it is first needed.
  std::size_t material(Color color, bool translucent) {
    const auto key = std::tuple(color.red, color.green, color.blue, color.alpha, translucent);
    const auto [found, is_new] = material_numbers_.try_emplace(key, materials_.size());
    if (!is_new) return found->second;
    const json factor{linear(color.red), linear(color.green), linear(color.blue), color.alpha / 255.0};
    json made{{"doubleSided", true},
              {"pbrMetallicRoughness",
               {{"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
    if (translucent) made["alphaMode"] = "BLEND";
    materials_.push_back(std::move(made));
    return found->second;
  }

  void add_node(json node) {
    nodes_.push_back(std::move(node));
    children_.push_back(nodes_.size()); // the root is node 0
  }

  /// glTF has no empty lists: what there is none of is not mentioned.
  json document(const std::string& title) {
    json root{{"name", title}, {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}};
    if (!children_.empty()) root["children"] = std::move(children_);
    nodes_.insert(nodes_.begin(), std::move(root));
    json out{{"asset", {{"version", "2.0"}, {"generator", "tetrarch"}}},
             {"scene", 0},
             {"scenes", json::array({{{"name", title}, {"nodes", json::array({0})}}})},
             {"nodes", std::move(nodes_)}};
    if (bytes_.empty()) return out;
    out["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    out["bufferViews"] = std::move(views_);
    out["accessors"] = std::move(accessors_);
    out["meshes"] = std::move(meshes_);
    out["materials"] = std::move(materials_);
    return out;
  }

  std::string bytes_;
  json views_ = json::array();
  json accessors_ = json::array();
  json meshes_ = json::array();
  json materials_ = json::array();
  json nodes_ = json::array();
  json children_ = json::array();
  std::map<std::tuple<std::uint8_t, std::uint8_t, std::uint8_t, std::uint8_t, bool>, std::size_t>
      material_numbers_;
};

/// No less than the surface takes: each of its triangles may need points of its own.
std::size_t most_bytes(const Surface& surface) {
  const std::size_t triangles = surface.triangles.size();
  const bool in_colors = surface.colors.size() > 1;
  const std::size_t a_point =
      12 + (surface.normals.empty() ? 0 : 12) + (surface.textures.empty() ? 0 : 8) + (in_colors ? 8 : 0);
  return 12 * triangles + a_point * (in_colors ? 3 * triangles : surface.points.size()) + json_bytes;
}

} // namespace

std::string write_glb(const Scene& scene) {
  const AllSurfaces surfaces(scene);
  std::size_t expected = json_bytes;
  for (const Surface* surface : surfaces.all) expected += most_bytes(*surface);
  GlbWriter writer(expected);
  for (const Surface* surface : surfaces.all) writer.add(*surface);
  for (const Label& label : scene.labels) writer.add(label);
  return std::move(writer).write(scene.title);
}

} // namespace tetrarch::scene
