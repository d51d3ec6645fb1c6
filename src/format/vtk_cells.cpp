// SPDX-License-Identifier: GPL-2.0-or-later
#include "vtk_cells.hpp"

#include "mesh_text.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

/// The dimension of the cells of a type; 3 for what is unknown, so that nothing is lost unawares.
int dimension_of(int type) {
  constexpr std::array<int, 8> low{1, 2, 3, 4, 21, 35, 68, 0}; // vertices, lines, curves, empty cells
  constexpr std::array<int, 16> flat{5, 6, 7, 8, 9, 22, 23, 28, 30, 34, 36, 69, 70, 75, 76, 77};
  if (std::find(low.begin(), low.end(), type) != low.end()) return 1;
  return std::find(flat.begin(), flat.end(), type) != flat.end() ? 2 : 3;
}

template <std::size_t corners>
void add(std::vector<std::array<int, corners>>& elements, Labels& labels, std::span<const int> points,
         int number, const Place& place) {
  if (points.size() != corners)
    throw InputError(place, "found " + std::to_string(points.size()) + " points in cell " +
                                std::to_string(number) + ", expected " + std::to_string(corners));
  std::array<int, corners> element{};
  std::copy(points.begin(), points.end(), element.begin());
  elements.push_back(element);
  note(labels, number, place.line);
}

} // namespace

void add_vtk_cell(Soup& soup, int type, std::span<const int> points, int number, const Place& place) {
  if (type == vtk_tetrahedron) return add(soup.tetrahedra, soup.tetrahedron_labels, points, number, place);
  if (type == vtk_triangle) return add(soup.triangles, soup.triangle_labels, points, number, place);
  const int dimension = dimension_of(type);
  if (dimension == 3)
    throw InputError(place, "found a cell of type " + std::to_string(type) +
                                ", expected tetrahedra of four points, type 10, alone");
  if (dimension == 2 && soup.warnings.empty())
    soup.warnings.emplace_back("surface cells other than triangles were passed over");
}

} // namespace tetrarch::format
