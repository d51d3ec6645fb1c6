// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Quad remeshing: the lines of constant height and of constant angle, drawn on the surface.
///
///      ._________________.     On the cylinder of a slit map, a rectangular grid. One horizontal line runs
///      |__|__|_|_|__|__|_|     at the height of every slit, vertical ones through both of its ends, one more
///      |__|__S=+=E__|__|_|     at least between them; other lines fill what is left as evenly as that
///      |__|__|_|_|__|__|_|     allows. Where they cross is a vertex; strictly between the ends of a slit
///      0               2 pi    there are two, one on each bank. So the boundary of the surface is made of
///                              lines.
///
/// As the map is conformal, quads are squares nearly, on smooth surfaces the more so the finer the triangles
/// and the quads; not so at the ends of slits, where four right angles make half a turn on the surface.
/// Source: Yin, section 2.4.3 and figure 2.9.

#include "tetrarch/slit/slit_map.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tetrarch::slit {

struct QuadMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> places; ///< of each point: (angle, height) on the cylinder
  /// Corners counterclockwise as the surface is oriented: lower left, lower right, upper right, upper left.
  std::vector<std::array<int, 4>> quads;
  std::vector<double> angles;  ///< of the vertical lines, ascending, less than a full turn in all
  std::vector<double> heights; ///< of the horizontal ones, from 0 to the modulus
  double thinnest = 1;         ///< least distance between neighboring lines, as a part of the distance wanted
  /// How far points lie beyond a side of the triangle that they were found in, on the cylinder: by rounding
  /// only, whether triangles are flipped or not, if the map is constant on loops.
  double outside = 0;
};

/// `around` is the wanted number of quads around the ring; fewer than 3 throw PreconditionError. Lines less
/// than 1e-9 apart become one; other lines stay, however near. Throws InputError if slits are too short or
/// too near one another for this, and for more than 5e7 quads. For n triangles: O(n), and O(1) for every
/// crossing point in the bounding box of every triangle.
QuadMesh quads(const OneForms& forms, const SlitMap& map, int around);

/// The number around for which quads have as much area in the mean as squares with this edge. O(n).
double quads_around(const surface::TriangleMesh& mesh, const SlitMap& map, double edge);

enum class Line : std::uint8_t { horizontal, vertical, boundary };
struct QuadEdge {
  int from = 0;
  int to = 0;
  Line line = Line::horizontal;
};
/// Each edge once. O(n log n).
std::vector<QuadEdge> edges(const QuadMesh& mesh);

struct QuadQuality {
  double mean_angle_error = 0; ///< of corners from right angles, in radians
  double max_angle_error = 0;
  double mean_warp = 0; ///< distance between the diagonals over their mean length; 0 for flat quads
  double max_warp = 0;
  double mean_edge = 0; ///< over the sides of quads
  double min_edge = 0;
  double max_edge = 0;
};
/// In space. O(n).
QuadQuality quality(const QuadMesh& mesh);

} // namespace tetrarch::slit
