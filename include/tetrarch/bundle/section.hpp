// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Sections of a circle bundle over the edges of the surface, and where they break.
///
/// Choose a point on each fibre over a vertex. Over each edge stands an annulus, in which the section goes
/// the shorter way. Around a triangle it then closes up after turning round the ring some whole number of
/// times: the index of the triangle. Where that is not 0, no section over the triangle has this boundary: a
/// singularity. Law: on a closed surface the indices add up to the Euler number; in the unit tangent bundle a
/// section is a field of directions, and this is the theorem of Poincare and Hopf. Source: Yin, 1.2 (the
/// motivation); Steenrod, "The Topology of Fibre Bundles", section 35.

#include "tetrarch/bundle/proof.hpp"

#include <vector>

namespace tetrarch::bundle {

/// The index of each triangle for the section that meets the fibre over vertex v at place[v] (any real
/// number, counted mod N from the fibre's place 0). `fibers` is what `prove` found. Throws
/// `PreconditionError` unless there is a finite place for each vertex. O(triangles).
std::vector<int> indices(const CircleBundle& bundle, const Fibers& fibers, const std::vector<double>& place);

/// A direction at each vertex of a surface in space, as an angle from the first edge of the vertex's fan,
/// where the angles between edges are scaled to 2 pi in all around an inner vertex; and the index of each
/// triangle for it, where along each edge it turns the shorter way against the parallel one. `points` are
/// those of the vertices; triangles of angles that cannot be told are taken as equilateral. Law: on a closed
/// surface, of whatever type, the indices add up to chi. O(triangles).
std::vector<int> field_indices(const mesh::Surface& surface, const std::vector<std::array<double, 3>>& points,
                               const std::vector<double>& direction);

} // namespace tetrarch::bundle
