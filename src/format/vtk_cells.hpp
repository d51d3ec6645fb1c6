// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells by VTK's type numbers, as its file formats have them, and their labels.

#include "cells.hpp"

#include <span>
#include <string_view>

namespace tetrarch::format {

inline constexpr int vtk_polygon = 7;
inline constexpr int vtk_strip = 6;

/// Adds the cell to `cells`. Throws InputError at `place` for cells that have no place in a soup (polyhedra,
/// which list their faces elsewhere, and parametric ones) and for a wrong number of points.
void add_vtk_cell(Cells& cells, Ledger& passed_over, int type, std::span<const int> points,
                  const CellName& name, const Place& place);

/// How good a name of an array is for labels of cells; 0: it is something else. The first is what we write;
/// others are what meshio, Gmsh and their like write.
int label_rank(std::string_view name);
inline constexpr const char* label_name = "label";

} // namespace tetrarch::format
