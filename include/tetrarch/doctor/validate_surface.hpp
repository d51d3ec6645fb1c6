// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every fault of a soup of triangles, by the numbers that the file uses.
///
/// | kind                | severity   | what was seen                                                    |
/// | ------------------- | ---------- | ---------------------------------------------------------------- |
/// | no_triangles        | fatal      | the soup holds none, or degenerate ones only                     |
/// | not_finite          | fatal      | a coordinate is infinite or no number                            |
/// | index_out_of_range  | fatal      | a triangle names a point that is not there                       |
/// | degenerate          | repairable | a triangle names a point twice                                   |
/// | duplicate           | repairable | a triangle names the same three points as an earlier one         |
/// | non_manifold_edge   | fatal      | three or more different triangles lie on one edge                |
/// | non_manifold_vertex | fatal      | the triangles around a vertex on no such edge fall apart         |
/// | turned              | repairable | a triangle is turned against most of an orientable component     |
/// | flat                | remark     | the area is zero, decided exactly                                |
/// | thin                | remark     | an angle is below 1e-10, and the area is not zero                |
/// | not_orientable      | remark     | a component is not orientable                                    |
/// | unused_vertex       | repairable | a point is in no triangle                                        |
/// | coincident_vertex   | remark     | a used point has the coordinates of an earlier one               |
/// | inside_out          | remark     | a closed component in no other one encloses a negative volume    |
/// | several_components  | remark     | the triangles are not all connected through edges                |
///
///        .---.---.       Two triangles may run along their edge in the same direction: one of them is turned
///       / \ / \ /|       then, and the edge is none the less a manifold's. Only where three or more
///      .---.---. |       different ones lie on an edge, however turned, nothing is glued there, and no
///           \ \ \|       orientation passes.
///            `-'-'
///
/// Boundary is no fault and is not reported here: surface/boundary_loops.hpp lists it. The checks of edges
/// and vertices leave out triangles with a fault of their own (out of range, degenerate, duplicates).

#include "tetrarch/doctor/validate.hpp"

namespace tetrarch::doctor {

/// Every fault of the triangles of `soup`; the first `listed` findings of each kind in full. The turned
/// triangles are the minority of each component (of two halves, the one without the first triangle); those
/// with a neighbor that is not turned come first. Throws nothing. O(n log n) in the worst case, in practice
/// linear; about 100 bytes a triangle.
Report validate_surface(const format::Soup& soup, int listed = 10);

} // namespace tetrarch::doctor
