// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// VTK's mesh files: the legacy form (`.vtk`, text or binary) and the XML form of unstructured grids
/// (`.vtu`) and surfaces (`.vtp`).
///
///     # vtk DataFile Version 3.0          <VTKFile type="UnstructuredGrid" byte_order="LittleEndian">
///     a title                             <UnstructuredGrid>
///     ASCII                               <Piece NumberOfPoints="4" NumberOfCells="1">
///     DATASET UNSTRUCTURED_GRID           <Points><DataArray type="Float64" NumberOfComponents="3"
///     POINTS 4 double                        format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
///     0 0 0  1 0 0  0 1 0  0 0 1          <Cells><DataArray type="Int32" Name="connectivity"
///     CELLS 1 5                              format="ascii">0 1 2 3</DataArray>
///     4 0 1 2 3                              <DataArray Name="offsets" ...>4</DataArray>
///     CELL_TYPES 1                           <DataArray Name="types" ...>10</DataArray></Cells>
///     10                                  </Piece></UnstructuredGrid></VTKFile>
///
/// Legacy: binary numbers are big-endian; version 5 has OFFSETS and CONNECTIVITY below CELLS; DATASET
/// POLYDATA with POLYGONS and TRIANGLE_STRIPS is a surface. XML: arrays are text, base64, or appended (raw or
/// base64), not compressed or by zlib, LZ4 or LZMA; PolyData (`.vtp`) is a surface; several pieces follow
/// each other, each with its own points. Points and cells are counted from 0; in XML, lines are not known.
/// Polygons, strips and volume cells of other shapes are cut, cells of higher order read by their corners;
/// polyhedra are refused. Tags are the numbers of an array of cells called "label", or as meshio, Gmsh and
/// others call it ("gmsh:physical", "medit:ref", "CellEntityIds", "region"). The ledger counts all the rest.
/// Source: "VTK File Formats", the VTK user's guide (Kitware).

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throw InputError. O(length).
Soup read_vtk(std::string_view text, const std::string& source);
Soup read_vtu(std::string_view text, const std::string& source);

/// Version 3.0, text. Tags become an array "label" of the cells. O(size).
std::string write_vtk(const Soup& soup);
/// All arrays as text. O(size).
std::string write_vtu(const Soup& soup);

} // namespace tetrarch::format
