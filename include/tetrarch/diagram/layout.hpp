// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where a diagram is drawn in the plane.
///
/// Each arc gets two points and each region a ring of points along its boundary and one in its middle: a
/// triangulated sphere. Without the middle of its largest region it is a disk, in whose circle packing every
/// node, arc and region has room of its own. The strands are smooth curves through the centers of the circles
/// of nodes and arcs. Parts are drawn side by side.
///
/// Source: circle packings as drawings of knots are those of Thurston and of KnotTheory; the algorithm,
/// Collins and Stephenson, "A circle packing algorithm" (2003).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/diagram.hpp"

#include <array>
#include <vector>

namespace tetrarch::diagram {

using PlanePoint = std::array<double, 2>;

/// A piece of an edge of the graph from one passage below to the next, or to an end.
struct Stroke {
  std::vector<PlanePoint> points;
  int edge = 0; ///< diagram::edges
  bool closed = false;
};

struct Layout {
  std::vector<Stroke> strokes;      ///< with gaps where they pass below
  std::vector<PlanePoint> vertices; ///< those of valence other than 2
  double vertex_radius = 0;         ///< of a dot that fits
  PlanePoint lower{0, 0};
  PlanePoint upper{1, 1};
};

/// O(darts) for each of the sweeps that the packing takes, some hundreds; 100 crossings take a tenth of a
/// second.
Layout layout(const Diagram& diagram, const Progress& progress = {});

} // namespace tetrarch::diagram
