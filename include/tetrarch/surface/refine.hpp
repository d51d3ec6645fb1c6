// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/surface/triangle_mesh.hpp"

namespace tetrarch::surface {

/// Divides each triangle t into four, 4t .. 4t+3 (three at its corners, then the middle one), by the
/// midpoints of its sides. Vertices keep their numbers; the midpoints follow in the order of the sides. O(n).
TriangleMesh refined(const TriangleMesh& mesh);

} // namespace tetrarch::surface
