// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A mesh that is being opened: holes punched, slit along paths, handles cut; and the names it came with.
///
///      17         17          The two banks of a cut have a vertex each, and both are vertex 17 to whoever
///    ---.---    .---.         calls it by name. What is left of the mesh keeps its order; the second copies
///       |   =>  |   |         come after it. So a writer can say of every vertex and triangle what it was.
///
/// Punching (mesh/punch.hpp), slicing (mesh/slice.hpp) and opening handles (mesh/open_handles.hpp) each take
/// such a mesh and return one, in any order.

#include "tetrarch/mesh/marked_surface.hpp"
#include "tetrarch/mesh/triangle_mesh.hpp"

#include <vector>

namespace tetrarch::mesh {

struct OpenedMesh {
  TriangleMesh mesh;
  /// Of each vertex, by which callers and messages know it: what the caller says, else its index in the
  /// first mesh. Copies share it; -1 for vertices put in.
  std::vector<long long> number;
  std::vector<int> triangle_of; ///< of each triangle, the one of the first mesh that it is, or is a part of

  OpenedMesh() = default;
  /// Throws `PreconditionError` unless each vertex has a number, or none.
  explicit OpenedMesh(TriangleMesh m, std::vector<long long> numbers = {});
};

/// A vertex of that number, the first if there are copies. Throws InputError if there is none. O(n).
int vertex_numbered(const OpenedMesh& opened, long long number);

/// `opened` along the marked edges of `marked`, which is its surface, split or not. O(n).
OpenedMesh cut_along(const OpenedMesh& opened, const MarkedSurface& marked);

} // namespace tetrarch::mesh
