// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Layers of hexahedra put into a mesh of hexahedra.
///
///      .----.----.            .----.----.      Some of the hexahedra shrink, and the gap between them and
///      |    |    |            |'--'|'--'|      the rest is filled: each square through which the gap runs
///      .----.----.   ---->    ||__|||__||      becomes a hexahedron. Around all of the mesh this gives
///      |    |    |            |.--.|.--.|      each square of the surface a hexahedron of its own. Around
///      '----'----'            '----'----'      those below a patch it gives each edge of the patch's rim
///                                              a square of its own.
///
/// Points that were on the surface stay there with their numbers; new points come last. Source: Mitchell and
/// Tautges, "Pillowing doublets" (1995).

#include "tetrarch/hex/grid.hpp"

#include <vector>

namespace tetrarch::hex {

/// A square of the surface: side `side` of a hexahedron, as `product::outward_sides` counts.
struct SurfaceSquare {
  int hexahedron = 0;
  int side = 0;
};

/// Those sides that no other hexahedron has, in the order of hexahedra. O(n log n).
std::vector<SurfaceSquare> surface_of(const product::HexMesh& mesh);

/// `shrinks` says of each hexahedron whether it does; `stays` of each side of each hexahedron, at
/// 6 h + side, whether the gap ends there although the surface runs there. `thickness` is the wanted one
/// of the new layer. Returns for each new point the old one that it came from.
std::vector<int> add_layer(SizedHexahedra& hexahedra, const std::vector<char>& shrinks,
                           const std::vector<char>& stays, double thickness);

} // namespace tetrarch::hex
