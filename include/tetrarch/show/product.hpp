// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Solids with coordinates (u, v, w), and hexahedral meshes, to look at and as files.
///
///        solid                  domain             Tetrahedra for programs (.vtu), the boundary for the eye:
///       .-------.              .--------.          its texture coordinates are (u, v), so that patterns run
///      /  ,-.  / \            /  ,-.   /|          up the walls along the fibers; its colors are those of
///     |  '-'  |  |           /--------/ |          the patches, floor, ceiling, walls; field w at points.
///      \_____/|_/            |________|/
///
/// `uvw` has a finite entry for each vertex of the solid in every function here; other lengths throw
/// PreconditionError. Everything is O(n), but for `outer_edges`: O(n log n).

#include "tetrarch/product/partition.hpp"
#include "tetrarch/scene/scene.hpp"

#include <array>
#include <vector>

namespace tetrarch::show {

/// The tetrahedra in space, textures (u, v, w), field w at points.
scene::Cells product_cells(const product::Solid& solid, const std::vector<scene::Point>& uvw);
/// The same tetrahedra at (u, v, w).
scene::Cells domain_cells(const product::Solid& solid, const std::vector<scene::Point>& uvw);

/// The boundary with its patches, as colors and as data `patch`: 0 floor, 1 ceiling, 2.. walls. Triangles
/// and points are those of the solid's boundary.
scene::Surface boundary_surface(const product::Solid& solid, const product::Partition& partition,
                                const std::vector<scene::Point>& uvw);
/// The same surface at (u, v, w).
scene::Surface domain_surface(const product::Solid& solid, const product::Partition& partition,
                              const std::vector<scene::Point>& uvw);

/// Fibers, in space or in the domain: each a polygon of at least two points. Data `fiber`, their number.
scene::Tubes fibers(const std::vector<std::vector<scene::Point>>& paths);

struct HexahedraData {
  std::vector<double> quality; ///< scaled Jacobian of each cell: field `quality`
  std::vector<int> layer;      ///< of each cell, from the floor: data `layer`
};

/// Hexahedra as they are, with vertices bottom counterclockwise from above, then top likewise.
scene::Cells hexahedra(const std::vector<scene::Point>& points, const std::vector<std::array<int, 8>>& cells,
                       const HexahedraData& data);

/// The edges of the outer faces of hexahedra, each once, as polylines of two points.
scene::Tubes outer_edges(const scene::Cells& hexahedra);

} // namespace tetrarch::show
