// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where points of the cylinder of a slit map lie on the surface.
///
/// Points off the loops: every triangle looks which crossing points it contains, as a screen is painted. The
/// map of the surface to the cylinder takes each loop to a horizontal line, so off these its degree is 1: a
/// triangle that is not turned over contains the point, even where others are flipped. Where several do, the
/// one is taken in which the point lies deepest. No index of triangles is needed.
///
/// Points on a loop: one walks along it until the angle is reached first. That keeps the order of the points
/// even where angles go astray between them.

#include "tetrarch/slit/slit_map.hpp"

#include <array>
#include <vector>

namespace tetrarch::slit {

using SpacePoint = std::array<double, 3>;

struct CrossingPoints {
  std::vector<SpacePoint> points; ///< line by line from below, the first and the last line left out
  double outside = 0;             ///< as `QuadMesh` has it
};
/// `angles` ascending, less than a full turn in all; `heights` ascending.
CrossingPoints crossing_points(const surface::TriangleMesh& mesh, const SlitMap& map,
                               const std::vector<double>& angles, const std::vector<double>& heights);

/// On the outer or the inner loop, at angles as above.
std::vector<SpacePoint> rim_points(const OneForms& forms, const SlitMap& map, int loop,
                                   const std::vector<double>& angles);

struct SlitPoints {
  SpacePoint start;
  SpacePoint end;
  std::vector<SpacePoint> above; ///< on the bank towards the inner loop
  std::vector<SpacePoint> below;
};
/// `angles` ascending, between the start and the end of the slit.
SlitPoints slit_points(const OneForms& forms, const SlitMap& map, const Slit& slit,
                       const std::vector<double>& angles);

} // namespace tetrarch::slit
