// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/scene/files.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace tetrarch::scene {
namespace {

/// How far from 1 the length of a normal may be.
constexpr double normal_slack = 1e-3;

/// What files with a column for each have names for already.
constexpr std::array<std::string_view, 6> taken_names{"element", "vertex_indices", "red",
                                                      "green",   "blue",           "alpha"};

/// And points.
constexpr std::array<std::string_view, 8> taken_at_points{"x",  "y",  "z",      "nx",
                                                          "ny", "nz", "radius", "texture"};

template <class List>
bool contains(const List& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

template <class Column>
void add_names(std::vector<std::string>& names, const std::vector<Column>& columns) {
  for (const Column& column : columns)
    if (!contains(names, column.name)) names.push_back(column.name);
}

/// Checks one element; every complaint begins with its name.
class Check {
public:
  Check(const char* kind, const std::string& name) : kind_(kind), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw PreconditionError(std::string(kind_) + ' ' + in_quotes(name_) + ": " + what);
  }

  void length(const char* list, std::size_t found, std::size_t expected) const {
    if (found != expected)
      fail(std::to_string(found) + ' ' + list + ", expected " + std::to_string(expected));
  }

  template <class T>
  void length_if_any(const char* list, const std::vector<T>& found, std::size_t expected) const {
    if (!found.empty()) length(list, found.size(), expected);
  }

  template <std::size_t corners>
  void indices(const char* part, const std::vector<std::array<int, corners>>& parts,
               std::size_t points) const {
    for (const auto& part_corners : parts)
      for (const int p : part_corners)
        if (p < 0 || static_cast<std::size_t>(p) >= points)
          fail(std::string("a ") + part + " names point " + std::to_string(p) + " of " +
               std::to_string(points));
  }

  template <std::size_t dimension>
  void finite(const char* list, const std::vector<std::array<double, dimension>>& vectors) const {
    for (const auto& vector : vectors)
      for (const double x : vector)
        if (!std::isfinite(x)) fail(std::string(list) + " that are not finite");
  }

  void unit(const std::vector<Point>& normals) const {
    for (const Point& n : normals)
      if (!(std::abs(std::hypot(n[0], n[1], n[2]) - 1) <= normal_slack)) fail("a normal is no unit vector");
  }

  void colors(const std::vector<Color>& found, std::size_t parts) const {
    if (found.size() != 1) length_if_any("colours", found, parts);
  }

  /// Data or fields, one number for each part.
  template <class Column>
  void columns(const char* list, const std::vector<Column>& columns, std::size_t parts) const {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string& name = columns[i].name;
      const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
      });
      if (!plain || contains(taken_names, name))
        fail(std::string(list) + " may not be called " + in_quotes(name));
      for (std::size_t j = 0; j < i; ++j)
        if (columns[j].name == name)
          fail(std::string("there are two ") + list + " called " + in_quotes(name));
      length(list, columns[i].values.size(), parts);
    }
  }

  template <class Element>
  void fields_of(const Element& element, std::size_t parts) const {
    fields("fields", element.cell_fields, parts);
    fields("fields at points", element.point_fields, element.points.size());
    for (const Field& field : element.point_fields)
      if (contains(taken_at_points, field.name))
        fail("fields at points may not be called " + in_quotes(field.name));
  }

private:
  void fields(const char* list, const std::vector<Field>& fields, std::size_t parts) const {
    columns(list, fields, parts);
    for (const Field& field : fields)
      for (const double x : field.values)
        if (!std::isfinite(x)) fail(in_quotes(field.name) + " has numbers that are not finite");
  }

  const char* kind_;
  const std::string& name_;
};

} // namespace

void require_sound(const Surface& surface) {
  const Check check("surface", surface.name);
  check.finite("points", surface.points);
  check.length_if_any("normals", surface.normals, surface.points.size());
  check.unit(surface.normals);
  check.length_if_any("texture coordinates", surface.textures, surface.points.size());
  check.finite("texture coordinates", surface.textures);
  check.indices("triangle", surface.triangles, surface.points.size());
  check.colors(surface.colors, surface.triangles.size());
  check.columns("data", surface.data, surface.triangles.size());
  check.fields_of(surface, surface.triangles.size());
}

void require_sound(const Tubes& tubes) {
  const Check check("tubes", tubes.name);
  check.finite("points", tubes.points);
  check.length("radii", tubes.radii.size(), tubes.points.size());
  for (const double radius : tubes.radii)
    if (!(radius >= 0) || std::isinf(radius)) check.fail("a radius that is no length");
  const std::vector<int>& starts = tubes.starts;
  if (starts.empty() || starts.front() != 0 || std::cmp_not_equal(starts.back(), tubes.points.size()))
    check.fail("the polylines do not begin with the first point and end with the last");
  for (std::size_t k = 0; k + 1 < starts.size(); ++k)
    if (starts[k + 1] - starts[k] < 2) check.fail("a polyline of fewer than two points");
  check.colors(tubes.colors, part_count(tubes));
  check.columns("data", tubes.data, part_count(tubes));
}

void require_sound(const Cells& cells) {
  const Check check("cells", cells.name);
  check.finite("points", cells.points);
  check.length_if_any("texture coordinates", cells.textures, cells.points.size());
  check.finite("texture coordinates", cells.textures);
  check.indices("tetrahedron", cells.tetrahedra, cells.points.size());
  check.indices("hexahedron", cells.hexahedra, cells.points.size());
  check.columns("data", cells.data, part_count(cells));
  check.fields_of(cells, part_count(cells));
}

void require_sound(const Scene& scene) {
  for_each_element(scene, [](const auto& element) { require_sound(element); });
  const Check check("scene", scene.title);
  const std::vector<std::string> data = data_names(scene);
  for (const std::string& name : field_names(scene, FieldOn::cells))
    if (contains(data, name)) check.fail("data and a field are both called " + in_quotes(name));
  for (const Label& label : scene.labels) check.finite("labels", std::vector<Point>{label.at});
}

std::vector<std::string> data_names(const Scene& scene) {
  std::vector<std::string> names;
  for_each_element(scene, [&](const auto& element) { add_names(names, element.data); });
  return names;
}

const std::vector<Field>& fields_of(const Tubes&, FieldOn) {
  static const std::vector<Field> none;
  return none;
}

std::vector<std::string> field_names(const Scene& scene, FieldOn on) {
  std::vector<std::string> names;
  for_each_element(scene, [&](const auto& element) { add_names(names, fields_of(element, on)); });
  return names;
}

AllSurfaces::AllSurfaces(const Scene& scene) {
  for (const Surface& surface : scene.surfaces) all.push_back(&surface);
  made.reserve(scene.tubes.size() + scene.cells.size());
  for (const Tubes& tubes : scene.tubes) made.push_back(swept(tubes));
  for (const Cells& cells : scene.cells) made.push_back(outer_faces(cells));
  for (const Surface& surface : made) all.push_back(&surface);
}

std::vector<Point> mean_normals(const Surface& surface) {
  using namespace numeric;
  std::vector<Point> normals(surface.points.size(), Point{});
  for (const auto& [a, b, c] : surface.triangles) {
    const Point area = cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
    for (const int v : {a, b, c}) normals[v] = normals[v] + area;
  }
  for (Point& normal : normals) normal = direction(normal).value_or(Point{0, 0, 1});
  return normals;
}

} // namespace tetrarch::scene
