// SPDX-License-Identifier: GPL-2.0-or-later
#include "gmsh_numbers.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

/// Source: Gmsh reference manual, "MSH file format", and its header GmshDefines.h for the orders above two.
constexpr std::array<GmshType, 37> gmsh_types{{{1, Shape::line, 2},
                                               {2, Shape::triangle, 3},
                                               {3, Shape::quadrilateral, 4},
                                               {4, Shape::tetrahedron, 4},
                                               {5, Shape::hexahedron, 8},
                                               {6, Shape::prism, 6},
                                               {7, Shape::pyramid, 5},
                                               {8, Shape::line, 3},
                                               {9, Shape::triangle, 6},
                                               {10, Shape::quadrilateral, 9},
                                               {11, Shape::tetrahedron, 10},
                                               {12, Shape::hexahedron, 27},
                                               {13, Shape::prism, 18},
                                               {14, Shape::pyramid, 14},
                                               {15, Shape::vertex, 1},
                                               {16, Shape::quadrilateral, 8},
                                               {17, Shape::hexahedron, 20},
                                               {18, Shape::prism, 15},
                                               {19, Shape::pyramid, 13},
                                               {20, Shape::triangle, 9},
                                               {21, Shape::triangle, 10},
                                               {22, Shape::triangle, 12},
                                               {23, Shape::triangle, 15},
                                               {24, Shape::triangle, 15},
                                               {25, Shape::triangle, 21},
                                               {26, Shape::line, 4},
                                               {27, Shape::line, 5},
                                               {28, Shape::line, 6},
                                               {29, Shape::tetrahedron, 20},
                                               {30, Shape::tetrahedron, 35},
                                               {31, Shape::tetrahedron, 56},
                                               {36, Shape::quadrilateral, 16},
                                               {37, Shape::quadrilateral, 25},
                                               {38, Shape::quadrilateral, 36},
                                               {90, Shape::prism, 40},
                                               {92, Shape::hexahedron, 64},
                                               {93, Shape::hexahedron, 125}}};

} // namespace

std::optional<GmshType> gmsh_type(std::int64_t type) {
  const auto found = std::find_if(gmsh_types.begin(), gmsh_types.end(),
                                  [type](const GmshType& row) { return row.type == type; });
  return found == gmsh_types.end() ? std::nullopt : std::optional(*found);
}

} // namespace tetrarch::format
