// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The boundary of a solid, as a surface of its own.

#include "tetrarch/format/soup.hpp"

namespace tetrarch::doctor {

/// The faces that one tetrahedron alone has, counterclockwise seen from outside if its volume is positive, in
/// the order of the tetrahedra; the points are those in use, with their numbers in the file. A face that the
/// soup lists as a triangle has its tag. Tetrahedra with an index out of range or a vertex twice are left
/// out. O(n), O(n log t) for t listed triangles.
format::Soup boundary_surface(const format::Soup& solid);

} // namespace tetrarch::doctor
