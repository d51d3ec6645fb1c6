// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra between floor and ceiling: a grid on the floor, carried up along the fibers.
///
///      ___________       Node (i, j) of the grid follows its fiber and leaves a point at each of the
///     /__/__/__/ /|      levels k/layers of the height. Cell times layer is a hexahedron.
///    /__/__/__/ /|/
///    |__|__|__|/|/       Of an exact product with right angles all are cuboids. Where floor or ceiling
///    |__|__|__|/         meet a wall without a ridge, a hexahedron has two faces in one tangent plane,
///                        and its scaled Jacobian tends to 0 on finer meshes, whatever is done inside.
///
/// Source: Yin, section 3.5.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/fibers.hpp"
#include "tetrarch/product/grid.hpp"
#include "tetrarch/product/hex_mesh.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// A fiber that ended below the requested level.
struct StuckNode {
  int node = 0;  ///< of the grid, or of the polycube's hexahedra
  int level = 0; ///< the first that it did not reach; of a polycube, 0: stuck in the cubes, 1: in the solid
  FiberEnd end = FiberEnd::stuck;
  Point at{};
};

/// A mesh of hexahedra in a solid.
struct SolidHexahedra {
  HexMesh mesh;
  std::vector<char> on_boundary; ///< of each point: whether it lies on the boundary of the solid
  std::vector<StuckNode> stuck;
  int left_out = 0; ///< hexahedra that lack a corner for that reason
};

struct HexOptions {
  int layers = 8;
  int threads = 1;
};

/// Fibers start from `start`, one point of the floor for each node of the grid. Points are numbered by
/// levels, from below, then by nodes; hexahedra by layers, then by cells. A stuck fiber leaves out the
/// hexahedra beside it from its level on; all others stay. The same whatever the number of threads. Throws
/// PreconditionError if there are no layers, or not one start for each node. O(n^1.33) for n tetrahedra and
/// as many nodes.
SolidHexahedra hexahedra(const FiberField& field, const FloorGrid& grid, const std::vector<FloorPoint>& start,
                         const HexOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::product
