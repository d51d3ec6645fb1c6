// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The elements of a scene (its surfaces, tubes and cells), as every writer goes through them.

#include "tetrarch/scene/scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tetrarch::scene {

/// How many triangles, polylines or cells there are.
inline std::size_t part_count(const Surface& surface) {
  return surface.triangles.size();
}
inline std::size_t part_count(const Tubes& tubes) {
  return tubes.starts.size() - 1;
}
inline std::size_t part_count(const Cells& cells) {
  return cells.tetrahedra.size() + cells.hexahedra.size();
}

/// Calls `visit` with each surface, then each tubes, then each cells. This order numbers the elements.
template <class Visit>
void for_each_element(const Scene& scene, Visit visit) {
  for (const Surface& surface : scene.surfaces) visit(surface);
  for (const Tubes& tubes : scene.tubes) visit(tubes);
  for (const Cells& cells : scene.cells) visit(cells);
}

/// Throw PreconditionError for an index out of range, lists of lengths that do not fit, a number that is not
/// finite, a normal that is no unit vector, and names of data that a file could not hold. O(size).
void require_sound(const Surface& surface);
void require_sound(const Tubes& tubes);
void require_sound(const Cells& cells);
void require_sound(const Scene& scene);

/// The colour of part k of an element.
inline Color color_of(const std::vector<Color>& colors, std::size_t k) {
  return colors.empty() ? Color{} : colors[colors.size() == 1 ? 0 : k];
}

/// Normals for a surface that has none: at each point the mean over its triangles, by area; (0, 0, 1) where
/// that is null. O(size).
std::vector<Point> mean_normals(const Surface& surface);

/// What a field has a number for: each triangle or cell, or each point.
enum class FieldOn : std::uint8_t { cells, points };

template <class Element>
const std::vector<Field>& fields_of(const Element& element, FieldOn on) {
  return on == FieldOn::cells ? element.cell_fields : element.point_fields;
}
/// None.
const std::vector<Field>& fields_of(const Tubes& tubes, FieldOn on);

/// The names of all data, or fields, in the scene, each once, in the order in which they appear.
std::vector<std::string> data_names(const Scene& scene);
std::vector<std::string> field_names(const Scene& scene, FieldOn on);

/// What an element has for data and for fields that it lacks.
inline constexpr int no_value = -1;
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// For each name the list of its values, or null where the element has none.
template <class Column>
auto columns_of(const std::vector<Column>& columns, const std::vector<std::string>& names) {
  std::vector<const decltype(Column::values)*> found;
  for (const std::string& name : names) {
    const auto named = [&name](const Column& column) { return column.name == name; };
    const auto it = std::find_if(columns.begin(), columns.end(), named);
    found.push_back(it == columns.end() ? nullptr : &it->values);
  }
  return found;
}

/// The scene as surfaces alone: its own, then the tubes swept, then the outer faces of cells. Those that were
/// made live here, the others in the scene.
struct AllSurfaces {
  explicit AllSurfaces(const Scene& scene);
  std::vector<Surface> made;
  std::vector<const Surface*> all;
};

} // namespace tetrarch::scene
