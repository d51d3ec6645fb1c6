// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The volume of a structure: half of F at its minimum.
///
/// With theta and V those of the lengths l, F(l) = 2 sum V + sum l theta - 2 pi sum l = 2 sum V - sum l K, up
/// to a constant that is 0 in this form. F is stationary at the structure in l; and for given l the sum V +
/// 1/2 sum l theta is stationary in the angles, however they come out of rounding. So lengths that err by d
/// and angles that err by d change the result by d^2, where a sum of volumes alone would change by d: with
/// flat tetrahedra angles err by 1e-16 over their size.

#include "problem.hpp"
#include "tetrarch/hyperbolic/volume.hpp"

namespace tetrarch::hyperbolic {

/// At a state with curvature near 0 where every tetrahedron exists. `last_step` is the largest component of
/// the Newton step from there. The bound covers rounding, and the way to the structure, taken to be no longer
/// than two such steps (F is convex, so F(l) - F there is at most K times the way).
template <class Scalar>
Estimate<Scalar> structure_volume(const Problem& problem, const State<Scalar>& state,
                                  const Scalar& last_step);

} // namespace tetrarch::hyperbolic
