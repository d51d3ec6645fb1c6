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

} // namespace tetrarch::bundle
