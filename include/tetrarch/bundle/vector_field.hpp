// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fields of unit tangent vectors on a surface in space, and their singularities.
///
///          \  |  /          A direction at a vertex is an angle, counted along the
///           \ | /           vertex's fan (surface::fan from the vertex's first corner)
///        -----v-----        from the first edge on. Around an inner vertex
///           / | \           the angles between edges are scaled
///          /  |  \          to 2 pi in all.
///
/// Along each edge the field turns the shorter way against the direction that stays parallel. Around a
/// triangle it has then turned, the curvature taken off, some whole number of times: the index. Law: on a
/// closed surface, of whatever type, the indices add up to chi (Poincare and Hopf). Source: Polthier and
/// Schmies, "Straightest geodesics on polyhedral surfaces" (1998), for the angles; Yin, 1.2, for why one
/// asks.

#include "tetrarch/surface/surface.hpp"

#include <array>
#include <vector>

namespace tetrarch::bundle {

/// The index of each triangle for a direction at each vertex. `points` are those of the vertices; degenerate
/// triangles count as equilateral. Throws `PreconditionError` unless there are a point and a finite angle for
/// each vertex. O(triangles).
std::vector<int> field_indices(const surface::Surface& surface,
                               const std::vector<std::array<double, 3>>& points,
                               const std::vector<double>& direction);

/// The direction at each vertex in which a constant vector points once it is projected to the tangent plane
/// there; 0 where it is normal to it. The plane is normal to the sum of the triangles' vector areas; within a
/// triangle's share of it the angle is divided in proportion. Throws as above. O(triangles).
std::vector<double> projected_field(const surface::Surface& surface,
                                    const std::vector<std::array<double, 3>>& points,
                                    const std::array<double, 3>& vector);

} // namespace tetrarch::bundle
