// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/mesh_json.hpp"

#include "json_members.hpp"
#include "json_text.hpp"
#include "json_tree.hpp"
#include "mesh_text.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace tetrarch::format {
namespace {

using On = MeshField::On;

struct OnName {
  On on;
  const char* name;
};
constexpr std::array<OnName, 6> on_names{{{On::vertices, "vertices"},
                                          {On::triangles, "triangles"},
                                          {On::tetrahedra, "tetrahedra"},
                                          {On::hexahedra, "hexahedra"},
                                          {On::triangle_corners, "triangle corners"},
                                          {On::tetrahedron_corners, "tetrahedron corners"}}};

constexpr int most_components = 3;

std::string name_of(On on) {
  for (const OnName& row : on_names)
    if (row.on == on) return row.name;
  throw PreconditionError("a field on nothing");
}

On read_on(const Json& value, const JsonPath& path) {
  std::string all;
  for (const OnName& row : on_names) {
    if (value == row.name) return row.on;
    all += (all.empty() ? "\"" : ", \"") + std::string(row.name) + "\"";
  }
  fail_found(path, value, "one of " + all);
}

/// One entry of a field, at the end of its values; the first entry says how many components there are.
void read_entry(const Json& entry, const JsonPath& path, bool is_first, MeshField& field) {
  const auto number = [&field](const Json& value, const JsonPath& at) {
    field.values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                           : read_double(value, at));
  };
  const std::size_t components = entry.is_array() ? entry.size() : 1;
  if (components < 1 || components > most_components)
    fail(path, "found an array of " + std::to_string(components) + ", expected one to three numbers");
  if (!is_first && static_cast<int>(components) != field.components)
    fail(path, "found " + std::to_string(components) + ", expected " + std::to_string(field.components) +
                   " components as in the entries before");
  field.components = static_cast<int>(components);
  if (!entry.is_array()) return number(entry, path);
  for (std::size_t c = 0; c < components; ++c) number(entry[c], below(path, c));
}

MeshField read_field(Json& object, const JsonPath& path, const MeshDocument& mesh) {
  if (!object.is_object()) fail_found(path, object, "an object");
  MeshField field;
  required(object, "name", path);
  field.name = read_text(object, "name", path);
  field.on = read_on(required(object, "on", path), below(path, "on"));
  Json& list = required(object, "values", path);
  const JsonPath at = below(path, "values");
  require_array(list, at, entries(mesh, field.on), "entries, one for each of the " + name_of(field.on));
  for (std::size_t k = 0; k < list.size(); ++k) read_entry(list[k], below(at, k), k == 0, field);
  list = nullptr;
  field.members = std::move(object);
  return field;
}

/// The elements that a member lists; none without it.
template <std::size_t corners>
std::vector<std::array<int, corners>> read_json_corners(Json& root, const char* key, int vertices) {
  Json* const list = member(root, key);
  if (list == nullptr) return {};
  const std::string wish =
      vertices == 0 ? "no vertex, as there are none" : "a vertex, 0 to " + std::to_string(vertices - 1);
  const auto corner = [vertices, &wish](const Json& value, const JsonPath& path) {
    return read_integer(value, path, 0, vertices - 1, wish);
  };
  return take_list(*list, {JsonStep(key)}, std::nullopt, "elements",
                   [&corner](const Json& element, const JsonPath& path) {
                     return read_array<corners>(element, path, "vertices", corner);
                   });
}

/// The labels that a member lists, one for each element; none without it.
std::vector<int> read_tags(Json& root, const char* key, std::size_t elements, const std::string& element) {
  Json* const tags = member(root, key);
  if (tags == nullptr) return {};
  return take_list(*tags, {JsonStep(key)}, elements, "entries, one per " + element,
                   [](const Json& value, const JsonPath& path) {
                     constexpr int most = std::numeric_limits<int>::max();
                     return read_integer(value, path, std::numeric_limits<int>::min(), most, "an integer");
                   });
}

MeshDocument to_mesh(JsonTree tree) {
  MeshDocument mesh;
  Json& root = tree.root;
  mesh.soup.points = take_list(required(root, "vertices"), {JsonStep("vertices")}, std::nullopt, "points",
                               [](const Json& point, const JsonPath& path) {
                                 return read_array<3>(point, path, "coordinates", read_double);
                               });
  if (mesh.soup.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    fail({JsonStep("vertices")}, "more vertices than can be counted");
  const int vertices = static_cast<int>(mesh.soup.points.size());
  mesh.soup.triangles = read_json_corners<3>(root, "triangles", vertices);
  mesh.soup.tetrahedra = read_json_corners<4>(root, "tetrahedra", vertices);
  mesh.hexahedra = read_json_corners<8>(root, "hexahedra", vertices);
  mesh.soup.triangle_tags = read_tags(root, "triangle_tags", mesh.soup.triangles.size(), "triangle");
  mesh.soup.tetrahedron_tags =
      read_tags(root, "tetrahedron_tags", mesh.soup.tetrahedra.size(), "tetrahedron");
  drop_empty_tags(mesh.soup);
  if (Json* const fields = member(root, "fields"))
    mesh.fields =
        take_list(*fields, {JsonStep("fields")}, std::nullopt, "fields",
                  [&mesh](Json& field, const JsonPath& path) { return read_field(field, path, mesh); });
  mesh.name = read_text(root, "name");
  mesh.provenance = take_object(root, "provenance");
  mesh.members = std::move(root);
  return mesh;
}

template <class Elements>
void require_vertices(const Elements& elements, std::size_t vertices, const char* what) {
  for (const auto& element : elements)
    for (const int index : element)
      if (index < 0 || static_cast<std::size_t>(index) >= vertices)
        throw InputError(std::string(what) + " name vertex " + std::to_string(index) +
                         ", counted from 0, which is none of the " + std::to_string(vertices) + " there are");
}

std::string field_text(const MeshField& field, const MeshDocument& mesh) {
  if (field.components < 1 || field.components > most_components ||
      field.values.size() != entries(mesh, field.on) * static_cast<std::size_t>(field.components))
    throw PreconditionError("the field '" + field.name + "' does not fit the " + name_of(field.on));
  const auto components = static_cast<std::size_t>(field.components);
  const std::size_t rows = field.values.size() / components;
  const auto row = [&](std::size_t k) {
    const auto first = field.values.begin() + static_cast<std::ptrdiff_t>(k * components);
    return components == 1 ? double_text(*first) : row_text(std::span(first, components), double_text);
  };
  return object_text(field.members,
                     {{"name", dumped(Json(field.name), 0)},
                      {"on", dumped(Json(name_of(field.on)), 0)},
                      {"values", array_text(rows, 3, row)}},
                     2);
}

template <class Entries>
MeshField flat_field(std::string name, On on, const Entries& list) {
  MeshField field{
      std::move(name), on, static_cast<int>(std::tuple_size_v<typename Entries::value_type>), {}, {}};
  field.values.reserve(list.size() * static_cast<std::size_t>(field.components));
  for (const auto& entry : list) field.values.insert(field.values.end(), entry.begin(), entry.end());
  return field;
}

} // namespace

MeshDocument mesh_document_of(Soup soup) {
  MeshDocument mesh;
  mesh.soup = std::move(soup);
  return mesh;
}

std::size_t entries(const MeshDocument& mesh, On on) {
  switch (on) {
  case On::vertices:
    return mesh.soup.points.size();
  case On::triangles:
    return mesh.soup.triangles.size();
  case On::tetrahedra:
    return mesh.soup.tetrahedra.size();
  case On::hexahedra:
    return mesh.hexahedra.size();
  case On::triangle_corners:
    return 3 * mesh.soup.triangles.size();
  case On::tetrahedron_corners:
    return 4 * mesh.soup.tetrahedra.size();
  }
  throw PreconditionError("a field on nothing");
}

MeshField field_of(std::string name, On on, const std::vector<double>& values) {
  return {std::move(name), on, 1, values, {}};
}
MeshField field_of(std::string name, On on, const std::vector<std::array<double, 2>>& values) {
  return flat_field(std::move(name), on, values);
}
MeshField field_of(std::string name, On on, const std::vector<std::array<double, 3>>& values) {
  return flat_field(std::move(name), on, values);
}

const MeshField* find_field(const MeshDocument& mesh, std::string_view name) {
  const auto found = std::find_if(mesh.fields.begin(), mesh.fields.end(),
                                  [name](const MeshField& field) { return field.name == name; });
  return found == mesh.fields.end() ? nullptr : &*found;
}

MeshDocument read_mesh_json(std::string_view text, const std::string& source) {
  MeshDocument mesh = read_tree(text, source, {mesh_json_format_tag, mesh_json_format_version}, to_mesh);
  mesh.soup.source = source;
  return mesh;
}

std::string write_mesh_json(const MeshDocument& mesh) {
  const Soup& soup = mesh.soup;
  require_finite(soup);
  require_vertices(soup.triangles, soup.points.size(), "triangles");
  require_vertices(soup.tetrahedra, soup.points.size(), "tetrahedra");
  require_vertices(mesh.hexahedra, soup.points.size(), "hexahedra");
  if (!soup.triangle_tags.empty() && soup.triangle_tags.size() != soup.triangles.size())
    throw PreconditionError("tags of other triangles than there are");
  if (!soup.tetrahedron_tags.empty() && soup.tetrahedron_tags.size() != soup.tetrahedra.size())
    throw PreconditionError("tags of other tetrahedra than there are");
  std::vector<JsonMember> members = first_members(mesh_json_format_tag, mesh_json_format_version, mesh.name);
  const auto point_text = [](const std::array<double, 3>& point) { return row_text(point, double_text); };
  members.push_back({"vertices", list_text(soup.points, 1, point_text).value_or("[]")});
  members.push_back({"triangles", integer_rows_text(soup.triangles, 1)});
  const auto tag_text = [](int tag) { return std::to_string(tag); };
  members.push_back({"triangle_tags", list_text(soup.triangle_tags, 1, tag_text)});
  members.push_back({"tetrahedra", integer_rows_text(soup.tetrahedra, 1)});
  members.push_back({"tetrahedron_tags", list_text(soup.tetrahedron_tags, 1, tag_text)});
  members.push_back({"hexahedra", integer_rows_text(mesh.hexahedra, 1)});
  members.push_back({"fields", list_text(mesh.fields, 1, [&mesh](const MeshField& field) {
                       return field_text(field, mesh);
                     })});
  members.push_back(provenance_member(mesh.provenance));
  return object_text(mesh.members, std::move(members), 0) + "\n";
}

bool looks_like_mesh_json(std::string_view text) {
  return json_format_of(text) == mesh_json_format_tag;
}

} // namespace tetrarch::format
