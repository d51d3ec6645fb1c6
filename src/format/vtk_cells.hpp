// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells by VTK's type numbers, as both of its file formats have them.

#include "mesh_cursor.hpp"

#include <span>

namespace tetrarch::format {

inline constexpr int vtk_triangle = 5;
inline constexpr int vtk_tetrahedron = 10;

/// Adds the cell to `soup`, or passes over it (with a warning if a surface cell is lost). Its points count
/// from `first_point` of the soup. Throws InputError at `place` for a volume cell that is no tetrahedron, an
/// unknown type and a wrong number of points.
void add_vtk_cell(Soup& soup, int type, std::span<const int> points, int number, const Place& place);

} // namespace tetrarch::format
