// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A triangle mesh: a connected surface, and a point in space for each of its vertices.
///
/// The promise: indices are in range, every point is used, the three of a triangle differ, no two triangles
/// name the same three, at most two share an edge, and the triangles around a vertex make one fan.
/// Coordinates are finite. Mates are turned only where the surface is not orientable. The surface may meet
/// itself in space.
///
/// A reader of files returns a soup, which promises nothing. `build_surface` makes a mesh of it,
/// mesh/validate_surface.hpp lists the faults that prevent this, and mesh/repair.hpp mends some of them.

#include "tetrarch/format/soup.hpp"
#include "tetrarch/mesh/surface.hpp"
#include "tetrarch/mesh/validate_surface.hpp"

#include <array>
#include <vector>

namespace tetrarch::mesh {

/// A surface with coordinates.
struct TriangleMesh {
  std::vector<std::array<double, 3>> points;
  Surface surface;
};

/// The mesh of a valid soup: triangle t and vertex v are those of the soup, and corners are in its order,
/// unless the surface is not orientable; then triangles may be turned (their last two corners exchanged) so
/// that fewer mates are. Throws InputError with the first fatal finding of `validate_surface` and the number
/// of the others, where several components are fatal too; then with the first repairable one. O(n log n) for
/// n triangles in the worst case, in practice linear.
TriangleMesh build_surface(format::Soup soup);
/// The same with the report of `validate_surface(soup, n)` for some n >= 1, for callers that need the report
/// too.
TriangleMesh build_surface(format::Soup soup, const Report& report);

} // namespace tetrarch::mesh
