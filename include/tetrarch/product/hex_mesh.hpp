// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A mesh of hexahedra, and their quality.
///
///        7-------6        Corners 0 to 3 go round the bottom, counterclockwise seen from inside of the
///       /|      /|        hexahedron, 4 to 7 lie above them; VTK and MEDIT have the same order. At each
///      4-------5 |        corner the scaled Jacobian is the determinant of the unit vectors along the
///      | 3-----|-2        three edges: 1 for right angles, 0 or less where the corner is flat or turned
///      |/      |/         inside out. That of the hexahedron is the least of the eight and of the one in
///      0-------1          the middle, where the vectors join the centers of opposite faces.
///
/// Source: the Verdict library, which uses the middle too (Stimpson et al., Sandia report SAND2007-1751).

#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tetrarch::product {

using numeric::Point;
using Hexahedron = std::array<int, 8>;

/// Hexahedra with coordinates.
struct HexMesh {
  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;

  std::array<Point, 8> corners(std::size_t hexahedron) const;
};

/// In [-1, 1]; 0 where an edge has no length.
double scaled_jacobian(const std::array<Point, 8>& corners);

struct BadHexahedron {
  int hexahedron = 0;
  double scaled_jacobian = 0;
  Point center{}; ///< the mean of its corners
};

struct HexQuality {
  std::vector<double> scaled_jacobian; ///< of each hexahedron
  double minimum = 1;
  double mean = 1;
  /// How many lie in [-1, -0.9), ... [0.9, 1].
  std::array<int, 20> histogram{};
  std::vector<BadHexahedron> bad; ///< those with 0 or less
};

/// O(n).
HexQuality quality(const HexMesh& mesh);

} // namespace tetrarch::product
