// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Meshes made of soups that have no fault.
///
///       file -> soup -> mesh       A soup promises nothing. doctor/validate.hpp and
///                 `-> findings     doctor/validate_surface.hpp list the faults that keep it from being a
///                                  mesh; doctor/repair.hpp mends some of them.

#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/solid/tet_mesh.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"

namespace tetrarch::doctor {

/// The mesh of a valid soup, whose arrays it takes. Throws InputError with the first fatal finding of
/// `validate` and the number of the others. O(n log n) for n tetrahedra in the worst case, in practice
/// linear.
solid::TetMesh build(format::Soup soup);
/// The same with the report of `validate(soup, n)` for some n >= 1, for callers that need the report too.
solid::TetMesh build(format::Soup soup, const Report& report);

/// The mesh of a valid soup: triangle t and vertex v are those of the soup, and corners are in its order,
/// unless the surface is not orientable; then triangles may be turned (their last two corners exchanged) so
/// that fewer mates are. Throws InputError with the first fatal finding of `validate_surface` and the number
/// of the others, where several components are fatal too; then with the first repairable one. O(n log n) for
/// n triangles in the worst case, in practice linear.
surface::TriangleMesh build_surface(format::Soup soup);
/// The same with the report of `validate_surface(soup, n)` for some n >= 1, for callers that need the report
/// too.
surface::TriangleMesh build_surface(format::Soup soup, const Report& report);

} // namespace tetrarch::doctor
