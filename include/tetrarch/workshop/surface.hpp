// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface to compute on, which remembers how its file calls triangles and vertices; and values for its
/// boundary edges.

#include "tetrarch/bundle/cutting_pattern.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"
#include "tetrarch/workshop/doctor.hpp"

#include <string>
#include <vector>

namespace tetrarch::workshop {

struct NumberedSurface {
  surface::TriangleMesh mesh;
  format::Soup labels;               ///< without points and elements: numbers alone
  std::vector<std::string> warnings; ///< what was mended

  long long triangle_number(int triangle) const;
  long long vertex_number(int vertex) const;
};

/// The triangles of a mesh, mended first. Throws InputError that names what is wrong and where. O(n log n).
NumberedSurface surface_of(format::Soup soup, const Doctor& doctor = {});

/// One value for each of `bundle::boundary_sides`, from a text of lines "u v value": the boundary edge on
/// vertices u and v, by the numbers of the surface's file, has value +1 or -1 in the direction from u to v.
/// What follows # on a line is passed over. Throws InputError for what is no boundary edge, a value missing,
/// given twice, or neither +1 nor -1. O(n log n).
bundle::BoundaryValues read_boundary_values(const std::string& path, const NumberedSurface& surface);

} // namespace tetrarch::workshop
