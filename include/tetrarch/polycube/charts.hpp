// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Charts of a labeled boundary, and what makes it no surface of a polycube.
///
///      .-------.-----.     A chart is a piece with one label, a line a row of edges between two
///      |  +z   | +x  |     charts, a corner a vertex where more than two meet. The lines of the third
///      o=======o     |     axis run between corners without turning back. Around a corner are the
///      |  -y   |     |     labels of one that cubes can make: 8 octants, some of them filled, and one
///      '-------'-----'     surface between.
///
/// These conditions are necessary for polycubes whose corners are those of cubes; whether there is a map
/// without folds is seen when it is made. Source: Eppstein and Mumford, "Steinitz theorems for orthogonal
/// polyhedra" (2010), for corners of three charts; all 256 sets of octants for the others.

#include "tetrarch/polycube/labels.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::polycube {

/// A row of edges between two charts, from corner to corner, or closed without a corner on it.
struct Line {
  std::vector<int> vertices; ///< of the boundary; of a closed line the first is the last, too
  int left = 0;              ///< chart
  int right = 0;
  bool is_closed = false;
};

struct Charts {
  std::vector<int> of; ///< of each triangle of the boundary
  std::vector<Label> label;
  std::vector<double> area;
  std::vector<Line> lines;
  /// Of each vertex of the boundary the charts around it, counterclockwise seen from outside, one for each
  /// sector; one where it lies inside a chart.
  std::vector<std::vector<int>> around;
  /// Of each sector around a vertex that is not inside of a chart, the next vertex on the line at which the
  /// sector begins.
  std::vector<std::vector<int>> begins;
  std::vector<int> corners; ///< vertices of the boundary with more than two sectors, increasing
  /// Of each chart, corners on each of its boundary curves.
  std::vector<std::vector<int>> corners_of_curve;

  int count() const { return static_cast<int>(label.size()); }
  /// The axis along which a line runs. The charts' axes must differ.
  std::size_t axis(const Line& line) const {
    return 3 - axis_of(label[line.left]) - axis_of(label[line.right]);
  }
};

/// O(n log n).
Charts charts(const product::Solid& solid, const Facets& facets, const std::vector<Label>& label);

/// Whether eight octants, some of them filled, can have these labels around their corner, counterclockwise
/// seen from outside. O(1).
bool is_corner_of_cubes(const std::vector<Label>& around);

/// What lies between two lines at a corner.
struct Sector {
  Label label = 0;
  Label begins = 0; ///< the axis along which the line goes away at which it begins, counterclockwise
  friend auto operator<=>(const Sector&, const Sector&) = default;
};
/// The same with the ways of the lines.
bool is_corner_of_cubes(const std::vector<Sector>& around);

struct Fault {
  enum class Kind : std::uint8_t {
    opposite,     ///< a line between opposite labels
    corner,       ///< labels around a corner that no cubes have
    few_corners,  ///< a boundary curve of a chart with less than four corners
    turning_point ///< where a line turns back along its axis
  } kind = Kind::opposite;
  int vertex = 0; ///< of the boundary
  Point at{};
};

/// In the order of kinds. A line turns back where it loses more than a tenth of its length along its axis.
/// O(n).
std::vector<Fault> faults(const product::Solid& solid, const Charts& charts);

/// How many are of the kind.
int count(const std::vector<Fault>& faults, Fault::Kind kind);

} // namespace tetrarch::polycube
