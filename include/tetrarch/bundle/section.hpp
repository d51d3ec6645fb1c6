// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Sections of a circle bundle over the edges of the surface, and where they break.
///
/// Choose a point on each fiber over a vertex. Over each edge stands an annulus, in which the section goes
/// from one to the other, the shorter way or with some whole turns more. Around a triangle it then closes up
/// after turning round the ring some whole number of times: the index of the triangle. Where that is not 0,
/// no section over the triangle has this boundary: a singularity. Law: on a closed surface the indices add up
/// to the Euler number; in the unit tangent bundle a section is a field of directions, and this is the
/// theorem of Poincare and Hopf. The converse holds too: any numbers that add up to the Euler number are the
/// indices of a section, and they determine it up to turns along loops of the surface. Source: Yin, 1.2 (the
/// motivation); Steenrod, "The Topology of Fibre Bundles", section 35.

#include "tetrarch/bundle/proof.hpp"

#include <vector>

namespace tetrarch::bundle {

/// A section over vertices and edges: its place on each fiber, and its way from one fiber to the next.
struct Section {
  /// Where it meets the fiber over each vertex: any real number, counted mod N from the fiber's place 0.
  std::vector<double> place;
  /// Of each side, the whole turns taken off the way along the edge of least number over it, seen from the
  /// side's triangle; of mates they are opposite.
  std::vector<int> turns;
};

// `fibers` is what `prove` found. All throw `PreconditionError` unless there is a finite place for each
// vertex, and cost O(triangles).

/// The section through these places that goes the shorter way along each edge, as the side of less number
/// sees it.
Section short_section(const CircleBundle& bundle, const Fibers& fibers, std::vector<double> place);

/// A section through these places with these indices, one for each triangle: of a field of tangent vectors,
/// the field. Throws also if the surface is closed and they do not add up to the Euler number.
Section section_with_indices(const CircleBundle& bundle, const Fibers& fibers, std::vector<double> place,
                             const std::vector<int>& index);

/// The index of each triangle.
std::vector<int> indices(const CircleBundle& bundle, const Fibers& fibers, const Section& section);

} // namespace tetrarch::bundle
