// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Which planes of a polycube must stay apart.
///
///      .-----+z-----.      Those at the two ends of a line; those of triangles that face each other
///      |  | step |  |      straight through the solid, across a wall; and those that bound a chart on
///   -x |<-+------+->| +x   two sides, straight across it, as a step on a wall does. Gaps outside of
///      '------------'      the solid are none: there the polycube may overlap itself.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/polycube/map.hpp"
#include "tetrarch/polycube/planes.hpp"
#include "tetrarch/polycube/rounding.hpp"

#include <vector>

namespace tetrarch::polycube {

/// Each pair of planes once, with its width in the image; pairs without a width there are left out. Weights
/// are areas behind the gaps, 1 on average. Throws Stopped. O(n) walks.
std::vector<Gap> gaps(const LabeledSolid& labeled, const Charts& charts, const Planes& planes,
                      const Image& image, const Progress& progress = {});

} // namespace tetrarch::polycube
