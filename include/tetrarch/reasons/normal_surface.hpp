// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Closed normal surfaces: surfaces that meet each tetrahedron in triangles and quadrilaterals.
///
/// A triangle of type v cuts corner v off; a quadrilateral parts the edges 01|23, 02|13 or 03|12. Parallel
/// copies are counted:
///
///     coordinates[7 t + v]      triangles at corner v of tetrahedron t
///     coordinates[7 t + 4 + k]  quadrilaterals of kind k: 0 parts 01 from 23, 1 parts 02 from 13, 2 parts 03
///     from 12
///
/// Such numbers are a surface if arcs match across each face and no tetrahedron has two kinds of
/// quadrilaterals. All surfaces are sums of the vertex surfaces, the extreme rays of the cone of solutions,
/// and among these is an essential sphere or torus, if there is one, or a surface that bounds a neighborhood
/// of one-sided ones. Sources: Haken (1961); Jaco and Tollefson (1995); Fukuda and Prodon, "Double
/// description method revisited" (1996).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <optional>
#include <vector>

namespace tetrarch::reasons {

using Coordinates = std::vector<int>;

/// Extreme rays by the double description method, as smallest whole numbers, in the order of these; links of
/// vertices are left out. Nothing if more than `most_steps` pairs would have to be combined, or a number
/// exceeds 10^6. For at most 18 tetrahedra; throws PreconditionError beyond that, or if there are boundary
/// faces.
std::optional<std::vector<Coordinates>> vertex_surfaces(const Triangulation& tri, long long most_steps,
                                                        const Progress& progress = {});

/// The arcs match, nothing is negative, and no tetrahedron has two kinds of quadrilaterals. O(n).
bool is_normal_surface(const Triangulation& tri, const Coordinates& coordinates);

} // namespace tetrarch::reasons
