// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// VTK's mesh files: the legacy form (`.vtk`, text or binary) and the XML form of unstructured grids
/// (`.vtu`).
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
/// POLYDATA with POLYGONS is a surface. XML: arrays are text, base64, or appended (raw or base64), not
/// compressed or by zlib (other compressors are refused). Points and cells are counted from 0; in XML, lines
/// are not known. Cells of dimension 0 and 1 are passed over, other surface cells than triangles with a
/// warning; volume cells other than tetrahedra of four points are refused, since the rest would be another
/// solid. Source: "VTK File Formats", the VTK user's guide (Kitware).

#include "tetrarch/format/soup.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throw InputError. O(length).
Soup read_vtk(std::string_view text, const std::string& source);
Soup read_vtu(std::string_view text, const std::string& source);

/// Version 3.0, text. O(size).
std::string write_vtk(const Soup& soup);
/// All arrays as text. O(size).
std::string write_vtu(const Soup& soup);

} // namespace tetrarch::format
