// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A mesh while it is opened (holes punched, paths slit, handles cut), with the original names of its parts.
///
///      17         17          Each bank of a cut has a vertex of its own, and users call both vertex 17.
///    ---.---    .---.         The rest of the mesh keeps its order, and the second copies follow. So a
///       |   =>  |   |         writer can name the origin of every vertex and triangle.
///
/// Punching (surface/punch.hpp), slicing (surface/slice.hpp) and opening handles (surface/open_handles.hpp)
/// each take such a mesh and return one, in any order.

#include "tetrarch/surface/marked_surface.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"

#include <vector>

namespace tetrarch::surface {

struct OpenedMesh {
  TriangleMesh mesh;
  /// For each vertex the number that callers and messages use: the caller's number, or else the index in the
  /// first mesh. Copies share it; new vertices have -1.
  std::vector<long long> number;
  std::vector<int> triangle_of; ///< of each triangle, the one of the first mesh that it is, or is a part of

  OpenedMesh() = default;
  /// Throws `PreconditionError` unless each vertex has a number, or none.
  explicit OpenedMesh(TriangleMesh m, std::vector<long long> numbers = {});
};

/// The vertex of this number, or the first of its copies. Throws InputError if there is none. O(n).
int vertex_numbered(const OpenedMesh& opened, long long number);

/// `opened` along the marked edges of `marked`, which is its surface, split or not. O(n).
OpenedMesh cut_along(const OpenedMesh& opened, const MarkedSurface& marked);

} // namespace tetrarch::surface
