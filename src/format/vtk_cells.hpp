// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells by VTK's type numbers, as its file formats have them, and their labels.

#include "cells.hpp"

#include <span>
#include <string_view>

namespace tetrarch::format {

inline constexpr int vtk_polygon = 7;
inline constexpr int vtk_strip = 6;
inline constexpr int vtk_polyhedron = 42;

/// Adds the cell to `cells`. Throws InputError at `place` for cells that have no place in a soup (parametric
/// ones; polyhedra are not given by their points) and for a wrong number of points.
void add_vtk_cell(Cells& cells, Ledger& passed_over, int type, std::span<const int> points,
                  const CellName& name, const Place& place);

/// Adds a polyhedron by its stream of numbers: how many faces, then for each how many corners and these.
/// `points`: how many there are; `first_point` is added to all. Throws InputError at `place`.
void add_vtk_polyhedron(Cells& cells, std::span<const int> stream, int first_point, std::size_t points,
                        const CellName& name, const Place& place);

/// How good a name of an array is for labels of cells; 0: it is something else. The first is what we write;
/// others are what meshio, Gmsh and their like write.
int label_rank(std::string_view name);
inline constexpr const char* label_name = "label";

} // namespace tetrarch::format
