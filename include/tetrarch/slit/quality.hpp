// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The quality of a slit map: its effect on each triangle, and the residuals of its equations.
///
///        /\            __      A linear map takes circles to ellipses. The ratio of their axes, 1 for
///       /  \    -->   /  \__   conformal maps, is the quasi-conformal error. Where it turns a triangle over,
///      /____\        /______\  the triangle is flipped.
///
/// A triangle with all corners on one loop is an *ear*. Slits and circles of cylinders have no room for it,
/// so every map flattens it, and a round hole would have room for it on the wrong side only; ears are counted
/// separately and enter no measure.

#include "tetrarch/slit/circular_map.hpp"

#include <vector>

namespace tetrarch::slit {

/// The effect of a map on the triangles.
struct Distortion {
  /// Of each triangle: the ratio of the axes, at least 1; 0 for flipped triangles and ears.
  std::vector<double> quasi_conformal;
  /// Of each triangle: half the log of how much its area grows; 0 where quasi_conformal is.
  std::vector<double> log_factor;
  double mean_quasi_conformal = 0; ///< weighted by the area of the triangles
  double max_quasi_conformal = 0;
  double mean_angle_error = 0; ///< over all corners, in radians
  double max_angle_error = 0;
  /// Of the log of area on the map over area in space, the distance from what it is for the whole, by area:
  /// 0 where all areas keep their share.
  double mean_area_error = 0;
  double max_area_error = 0;
  std::vector<int> flipped; ///< triangles turned over or flattened, ears apart
  int ears = 0;
};

/// Of each triangle whether it is an ear. O(n).
std::vector<char> ears(const OneForms& forms);

/// On the cylinder, and so on the rectangle.
Distortion distortion_on_cylinder(const OneForms& forms, const SlitMap& map);
/// On the ring, where edges are drawn straight. A triangle whose heights differ much can be inverted here
/// although it was not on the cylinder. O(n), as all of these.
Distortion distortion_on_ring(const OneForms& forms, const SlitMap& map);
/// Of a mesh whose vertices are laid into the plane. There are no ears.
Distortion distortion_in_plane(const surface::TriangleMesh& mesh,
                               const std::vector<std::complex<double>>& position);

/// In a disk with round holes. Ears are those of the holes.
Distortion distortion_in_disk(const surface::TriangleMesh& mesh, const CircularMap& map);
std::vector<char> ears_in_disk(const surface::TriangleMesh& mesh, const CircularMap& map);

/// Residuals, which should be 0.
struct Residuals {
  double period = 0;   ///< greatest deviation of the periods of the angle from 2 pi, -2 pi or 0
  double flux = 0;     ///< the same of the fluxes of log_radius, by cotangents, through the loops
  double harmonic = 0; ///< greatest |L log_radius| at the vertices inside
  double radius = 0;   ///< greatest deviation of |concentric(v)| along a loop from its radius
};
Residuals residuals(const OneForms& forms, const SlitMap& map);

} // namespace tetrarch::slit
