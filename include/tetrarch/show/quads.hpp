// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Quad meshes of slit maps, to look at and as files.

#include "tetrarch/scene/scene.hpp"
#include "tetrarch/slit/quads.hpp"

#include <string>

namespace tetrarch::show {

/// OBJ: a line for each vertex, and one with four vertices for each quad, in their order. O(n).
std::string quads_obj(const slit::QuadMesh& mesh);

/// The surface, each quad as two triangles, under its lines as tubes: horizontal, vertical and boundary, in
/// three colors. O(n log n).
scene::Scene quad_scene(const slit::QuadMesh& mesh);

} // namespace tetrarch::show
