// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Holes punched into a surface: disks of triangles taken out.
///
///     .--------------.      A round hole takes the triangles whose corners all lie within a ball around its
///    /   .-.    .-.   \     vertex, as far as they are connected with that vertex through edges. Then
///   |   ( x )  ( x )   |
///   |       .---.      |      - where it touches itself at a vertex, all triangles there go;
///    \     (  x  )    /       - what it surrounds goes: of the parts that it leaves, all but the one of most
///     \     '---'    /          triangles.
///      '------------'
///                           So a hole may be larger than its ball: around a finger it takes the tip too.
///
/// Distance is straight through space, not along the surface: it is what a ruler measures, it depends on
/// nothing but the vertex, and within the hole the two hardly differ where the surface is smooth at the scale
/// of the radius. Being connected keeps the other side of a thin sheet from being hit.

#include "tetrarch/mesh/opened.hpp"

#include <vector>

namespace tetrarch::mesh {

struct RoundHole {
  long long vertex = 0; ///< by number
  double radius = 0;    ///< in units of the points
};

/// Punches all holes. The order of what is left is kept. Throws InputError, naming the vertex, where there is
/// none of that number; where the radius does not reach all neighbours of the vertex (the message says what
/// would); and where a hole is no disk (it closes around a handle), has a vertex with the boundary or another
/// hole in common, or leaves nothing. O(n) for each hole.
OpenedMesh punch(const OpenedMesh& opened, const std::vector<RoundHole>& holes);

/// The same for sets of triangles, given by their numbers in the first mesh (of its parts there, if it was
/// split, all are meant). Throws InputError likewise, naming the first triangle of the set, and where it is
/// not connected.
OpenedMesh punch_triangles(const OpenedMesh& opened, const std::vector<std::vector<int>>& holes);

} // namespace tetrarch::mesh
