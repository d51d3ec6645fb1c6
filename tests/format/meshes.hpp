// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Soups that the tests of the mesh formats write and read back.

#include "tetrarch/format/mesh_files.hpp"

#include <string>
#include <vector>

namespace tetrarch::format::test {

/// The mesh of record_meshio.py: two tetrahedra on a common face, and a triangle.
inline Soup two_tetrahedra() {
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}, {0.1, 0.2, -1e-3}};
  soup.triangles = {{1, 2, 3}};
  soup.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  return soup;
}

/// The boundary of the first of them.
inline Soup one_boundary() {
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

inline std::string mesh_data(const std::string& name) {
  return std::string(TETRARCH_SOURCE_DIR) + "/tests/data/mesh/" + name;
}

/// Formats that are one text.
inline const std::vector<MeshFormat> solid_formats{MeshFormat::medit, MeshFormat::gmsh, MeshFormat::vtk,
                                                   MeshFormat::vtu};
inline const std::vector<MeshFormat> surface_formats{MeshFormat::obj, MeshFormat::off, MeshFormat::stl,
                                                     MeshFormat::ply};

} // namespace tetrarch::format::test
