// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cells of a grid that fill a solid.
///
///      +--+--+--+--+        A grid is three rows of planes, at any distances. Of each cell it is known how
///      |  | .'''.  |        much of it the solid fills, by 27 points. Those that are half full are taken;
///      |  |'  |  '.|        then cells are added or removed, the most doubtful first, until the surface of
///      |  '.  |  .'|        what is taken is a manifold, in one piece and of the solid's genus.
///      +--+-'-+'-+-+
///
/// The solid may have been deformed: then its vertices are where `image` says.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/product/solid.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetrarch::hex {

using product::Point;

struct Grid {
  std::array<std::vector<double>, 3> plane; ///< increasing, at least two along each axis

  int cells(int axis) const { return static_cast<int>(plane[static_cast<std::size_t>(axis)].size()) - 1; }
  std::int64_t size() const { return std::int64_t{cells(0)} * cells(1) * cells(2); }
  /// Of the cell with these least planes.
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * cells(1) + y) * cells(0) + x;
  }
  std::array<int, 3> cell(std::size_t index) const;
};

/// Planes at a distance of about `edge` around some points, with one cell free on all sides. `fixed[axis]`
/// are places where there is to be a plane; one that is nearer to the plane before it than `apart`, in terms
/// of the edge, is left out.
Grid grid_around(const std::vector<Point>& points, double edge,
                 const std::array<std::vector<double>, 3>& fixed = {}, double apart = 0.4);

/// Bytes that `filled` and what follows take for so many cells of a grid.
std::int64_t bytes_for(std::int64_t cells);

/// How much of each cell lies in the solid, from 0 to 1. O(n + p) for n tetrahedra and p points in their
/// bounding boxes.
std::vector<float> filled(const product::Solid& solid, const std::vector<Point>& image, const Grid& grid,
                          const Progress& progress = {});

/// Cells whose surface is a connected manifold of this genus, 1 each; nothing where none were found. `full`
/// is how full a cell must be to be taken at first.
[[nodiscard]] std::optional<std::vector<char>>
chosen_cells(const Grid& grid, const std::vector<float>& filled, int genus, double full = 0.5);

struct ThinnedCells {
  std::vector<char> chosen; ///< 1 each
  int changes = 0;          ///< holes and bridges, made or closed, for the genus
};
/// The same for walls and gaps thinner than the cells, with `full` so small, or so near to 1, that walls or
/// gaps hang together. Then cells are left again that are less than half as full as a neighbor that is taken,
/// and taken that are less than half as empty as one that is left, where the surface stays what it is. So a
/// wall keeps a row of cells. If the genus is another, what is one cell thick is pierced or closed, the most
/// doubtful first.
[[nodiscard]] std::optional<ThinnedCells> thinned_cells(const Grid& grid, const std::vector<float>& filled,
                                                        int genus, double full);

/// A hexahedron's lengths along its edges from corner 0 to 1, 3 and 4.
using Lengths = std::array<double, 3>;

/// Hexahedra that know how large they would like to be.
struct SizedHexahedra {
  product::HexMesh mesh;
  std::vector<Lengths> lengths;
};

/// The chosen cells. O(n).
SizedHexahedra cells_of(const Grid& grid, const std::vector<char>& chosen);

} // namespace tetrarch::hex
