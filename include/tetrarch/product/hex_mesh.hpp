// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A mesh of hexahedra, and their quality.
///
///        7-------6        Corners 0 to 3 go round the bottom, counterclockwise seen from inside of the
///       /|      /|        hexahedron, 4 to 7 lie above them; VTK and MEDIT have the same order. At each
///      4-------5 |        corner the scaled Jacobian is the determinant of the unit vectors along the
///      | 3-----|-2        three edges: 1 for right angles, 0 or less where the corner is flat or turned
///      |/      |/         inside out. That of the hexahedron is the least of the eight and of the one in
///      0-------1          the middle, where the vectors join the centers of opposite faces; and 0, if
///                         these are positive but the Jacobian determinant is not everywhere inside.
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

/// Of each corner its three neighbors, so that they make a right-handed corner of a cube.
inline constexpr std::array<std::array<int, 3>, 8> corner_neighbors{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
/// Seen from outside each is counterclockwise.
inline constexpr std::array<std::array<int, 4>, 6> outward_sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Squares of the surface, by their points, seen from outside: those of one hexahedron only. O(n log n).
std::vector<std::array<int, 4>> surface_squares(const HexMesh& mesh);

/// In [-1, 1]; 0 where an edge has no length.
double scaled_jacobian(const std::array<Point, 8>& corners);

/// What the trilinear cell encloses, exact up to rounding: what is turned inside out counts as negative, and
/// so does an inverted cell. Each side is a bilinear patch, which encloses with any point the mean of what
/// its two cuts into triangles do.
double volume(const std::array<Point, 8>& corners);
/// The sum over all cells: what is covered twice counts twice. O(n).
double volume(const HexMesh& mesh);

struct BadHexahedron {
  int hexahedron = 0;
  double scaled_jacobian = 0;
  Point center{}; ///< the mean of its corners
};

/// So many of the worst are named.
constexpr std::size_t worst_named = 10;

struct HexQuality {
  std::vector<double> scaled_jacobian; ///< of each hexahedron
  double minimum = 1;
  double mean = 1;
  /// How many lie in [-1, -0.9), ... [0.9, 1].
  std::array<int, 20> histogram{};
  std::vector<BadHexahedron> bad; ///< those with 0 or less: inverted or flat somewhere
  /// The `worst_named` of least scaled Jacobian, or all if they are fewer; the worst first, of equal ones the
  /// one of lesser number.
  std::vector<BadHexahedron> worst;
};

/// O(n).
HexQuality quality(const HexMesh& mesh);

/// Whether the first is the better mesh: fewer bad cells, or as many and a greater least scaled Jacobian, or
/// as great and a greater mean.
bool is_better(const HexQuality& a, const HexQuality& b);

} // namespace tetrarch::product
