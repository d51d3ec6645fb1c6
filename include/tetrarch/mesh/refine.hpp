// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/mesh/triangle_mesh.hpp"

namespace tetrarch::mesh {

/// Each triangle t in four, 4t .. 4t+3 (those at its corners, then the middle one), by the middles of its
/// sides: the same surface. Vertices keep their numbers, the middles come after them in the order of the
/// sides. O(n).
TriangleMesh refined(const TriangleMesh& mesh);

} // namespace tetrarch::mesh
