// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a surface is expected (OBJ, OFF, PLY, STL, or the triangles of another mesh format),
/// and values for its boundary edges.

#include "command.hpp"
#include "doctor.hpp"

#include "tetrarch/bundle/cutting_pattern.hpp"
#include "tetrarch/mesh/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

struct SurfaceInput {
  mesh::TriangleMesh mesh;
  format::Soup labels; ///< how the file calls triangles and vertices; its own lists may be empty
  std::vector<std::string> warnings;
};

/// Throws InputError that names what is wrong and where; `doctor` mends what can be mended first.
SurfaceInput read_surface(const std::string& argument, const Context& context, const Doctor& doctor);

/// One value for each of `bundle::boundary_sides`, from a text of lines "u v value": the boundary edge on
/// vertices u and v, by the numbers of the surface's file, has value +1 or -1 in the direction from u to v.
/// What follows # on a line is passed over. Throws InputError for what is no boundary edge, a value missing,
/// given twice, or neither +1 nor -1.
bundle::BoundaryValues read_boundary_values(const std::string& path, const SurfaceInput& surface);

} // namespace tetrarch::program
