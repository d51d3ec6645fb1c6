// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One loop on its slit: where the slit ends, between the vertices, and which point of it is which.
///
///     angle     .-.           The map in which this loop is a circle numbers it by angles psi: of all
///       |      /   \          parameters the natural one, in which the angle on the slit is analytic,
///       |     /     \         however jagged the loop is on the surface. The slit ends at the extrema of
///       |____/_______\__ psi  that function: of parabolas through the vertex of greatest (least) angle
///                             and its neighbours. (The greatest angle of a vertex misses the end by the
///                             square of an edge, which square roots make an edge.)

#include "tetrarch/slit/one_forms.hpp"

#include <vector>

namespace tetrarch::slit {

struct SlitCurve {
  /// Angles at which the slit ends, relative to the first vertex of the loop.
  double lowest = 0;
  double highest = 0;
  /// Of each vertex of the loop, in its order, t in [0, 2 pi): the angle is middle + half cos t, and t is
  /// below pi on the bank towards the origin.
  std::vector<double> parameter;
};

/// `angle`: the slit map's, along the sides; its period around the loop is 0. O(length of the loop * loops).
SlitCurve slit_curve(const OneForms& forms, const OneForm& angle, int loop);

} // namespace tetrarch::slit
