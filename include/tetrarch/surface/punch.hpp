// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Punching holes into a surface: disks of triangles are removed.
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
/// of the radius. The connection keeps the hole off the other side of a thin sheet.

#include "tetrarch/surface/opened.hpp"

#include <vector>

namespace tetrarch::surface {

struct RoundHole {
  long long vertex = 0; ///< by number
  double radius = 0;    ///< in units of the points
};

/// Punches all holes. The remaining triangles keep their order. Throws InputError with the vertex if it does
/// not exist, if the radius does not reach all its neighbors (the message gives a radius that does), or if
/// the hole is no disk (it closes around a handle), shares a vertex with the boundary or another hole, or
/// removes the whole surface. O(n) for each hole.
OpenedMesh punch(const OpenedMesh& opened, const std::vector<RoundHole>& holes);

/// The same for sets of triangles, given by their numbers in the first mesh; a number stands for all parts of
/// a split triangle. Throws InputError for the same reasons, with the first triangle of the set, and if the
/// set is not connected.
OpenedMesh punch_triangles(const OpenedMesh& opened, const std::vector<std::vector<int>>& holes);

} // namespace tetrarch::surface
