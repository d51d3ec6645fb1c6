// SPDX-License-Identifier: GPL-2.0-or-later
#include "vtk_cells.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

/// The corners come first in all types; `nodes` is 0 where there may be any number of further ones.
struct VtkType {
  int type;
  Shape shape;
  int nodes;
};

constexpr std::array<VtkType, 36> vtk_types{{{5, Shape::triangle, 3},
                                             {8, Shape::quadrilateral, 4},
                                             {9, Shape::quadrilateral, 4},
                                             {10, Shape::tetrahedron, 4},
                                             {11, Shape::hexahedron, 8},
                                             {12, Shape::hexahedron, 8},
                                             {13, Shape::prism, 6},
                                             {14, Shape::pyramid, 5},
                                             {15, Shape::pentagonal_prism, 10},
                                             {16, Shape::hexagonal_prism, 12},
                                             {22, Shape::triangle, 6},
                                             {23, Shape::quadrilateral, 8},
                                             {24, Shape::tetrahedron, 10},
                                             {25, Shape::hexahedron, 20},
                                             {26, Shape::prism, 15},
                                             {27, Shape::pyramid, 13},
                                             {28, Shape::quadrilateral, 9},
                                             {29, Shape::hexahedron, 27},
                                             {30, Shape::quadrilateral, 6},
                                             {31, Shape::prism, 12},
                                             {32, Shape::prism, 18},
                                             {33, Shape::hexahedron, 24},
                                             {34, Shape::triangle, 7},
                                             {37, Shape::pyramid, 19},
                                             {69, Shape::triangle, 0},
                                             {70, Shape::quadrilateral, 0},
                                             {71, Shape::tetrahedron, 0},
                                             {72, Shape::hexahedron, 0},
                                             {73, Shape::prism, 0},
                                             {74, Shape::pyramid, 0},
                                             {76, Shape::triangle, 0},
                                             {77, Shape::quadrilateral, 0},
                                             {78, Shape::tetrahedron, 0},
                                             {79, Shape::hexahedron, 0},
                                             {80, Shape::prism, 0},
                                             {81, Shape::pyramid, 0}}};

constexpr int pixel = 8;
constexpr int voxel = 11;

[[noreturn]] void refuse_count(std::size_t found, std::size_t expected, const CellName& name,
                               const Place& place) {
  throw InputError(place, "found " + std::to_string(found) + " points in cell " +
                              std::to_string(name.number) + ", expected " + std::to_string(expected));
}

bool is_type_among(int type, std::initializer_list<int> list) {
  return std::find(list.begin(), list.end(), type) != list.end();
}

/// VTK's documentation looks at the base of a wedge from the other side than we do, and its pixels and
/// voxels run along the axes.
bool has_other_order(int type, Shape shape) {
  return type == pixel || type == voxel || shape == Shape::prism;
}

std::vector<int> in_our_order(int type, Shape shape, std::span<const int> points) {
  std::vector<int> nodes(points.begin(), points.end());
  if (type == pixel || type == voxel) std::swap(nodes[2], nodes[3]);
  if (type == voxel) std::swap(nodes[6], nodes[7]);
  if (shape == Shape::prism) {
    std::swap(nodes[1], nodes[2]);
    std::swap(nodes[4], nodes[5]);
  }
  return nodes;
}

} // namespace

void add_vtk_cell(Cells& cells, Ledger& passed_over, int type, std::span<const int> points,
                  const CellName& name, const Place& place) {
  if (type == 0) return; // the empty cell
  if (is_type_among(type, {1, 2})) return passed_over.note("point element");
  if (is_type_among(type, {3, 4, 21, 35, 68, 75})) return passed_over.note("line element");
  if (type == vtk_strip) return cells.add_strip(points, name);
  if (type == vtk_polygon) return cells.add_polygon(points, name);
  constexpr int quadratic_polygon = 36;
  if (type == quadratic_polygon) {
    passed_over.note("midside node of a polygon", static_cast<std::int64_t>(points.size() / 2));
    return cells.add_polygon(points.first(points.size() / 2), name);
  }
  const auto known = std::find_if(vtk_types.begin(), vtk_types.end(),
                                  [type](const VtkType& row) { return row.type == type; });
  if (known == vtk_types.end())
    throw InputError(place, "found a cell of type " + std::to_string(type) +
                                ", expected triangles, quadrilaterals, polygons, tetrahedra, pyramids, "
                                "prisms, hexahedra or polyhedra");
  const auto expected =
      static_cast<std::size_t>(known->nodes > 0 ? known->nodes : corner_count(known->shape));
  if (known->nodes > 0 ? points.size() != expected : points.size() < expected)
    refuse_count(points.size(), expected, name, place);
  if (has_other_order(type, known->shape)) // a copy costs more than all else
    return cells.add(known->shape, in_our_order(type, known->shape, points), name);
  cells.add(known->shape, points, name);
}

void add_vtk_polyhedron(Cells& cells, std::span<const int> stream, int first_point, std::size_t points,
                        const CellName& name, const Place& place) {
  std::size_t at = 0;
  const auto next = [&](const char* what, std::int64_t least, std::int64_t end) {
    if (at == stream.size())
      throw InputError(place, "the faces of cell " + std::to_string(name.number) + " end before " + what);
    const int value = stream[at++];
    if (value < least || value >= end)
      throw InputError(place, "found " + std::to_string(value) + " in the faces of cell " +
                                  std::to_string(name.number) + ", expected " + what + ", " +
                                  std::to_string(least) + " to " + std::to_string(end - 1));
    return value;
  };
  const auto rest = static_cast<std::int64_t>(stream.size()) + 1;
  std::vector<std::vector<int>> faces(static_cast<std::size_t>(next("the number of its faces", 4, rest)));
  for (std::vector<int>& face : faces) {
    face.resize(static_cast<std::size_t>(next("the number of a face's corners", 3, rest)));
    for (int& v : face)
      v = first_point + next("the number of a point", 0, static_cast<std::int64_t>(points) - first_point);
  }
  if (at != stream.size())
    throw InputError(place, "the faces of cell " + std::to_string(name.number) + " go on after the last one");
  cells.add_polyhedron(faces, name);
}

int label_rank(std::string_view name) {
  constexpr std::array<std::string_view, 12> names{
      "material",     "region",    "attribute",  "regions",   "CellEntityIds", "gmsh:geometrical",
      "cell_markers", "cell_tags", "tetgen:ref", "medit:ref", "gmsh:physical", label_name};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

} // namespace tetrarch::format
