// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/truncated.hpp"

#include "tetrarch/core/error.hpp"

#include <utility>

namespace tetrarch {

TruncatedTriangulation::TruncatedTriangulation(Triangulation tri) : tri_(std::move(tri)), skeleton_(tri_) {
  for (const FaceId f : all<FaceId>(skeleton_.face_count())) {
    if (!skeleton_.is_boundary(f)) continue;
    const TetFace where = skeleton_.preimages(f)[0];
    throw PreconditionError("face " + std::to_string(where.face) + " of tetrahedron " +
                            std::to_string(where.tet) + " is not glued: every hexagon needs a partner");
  }
}

int TruncatedTriangulation::boundary_euler() const {
  int sum = 0;
  for (const VertexId v : all<VertexId>(skeleton_.vertex_count())) sum += skeleton_.link(v).euler;
  return sum;
}

} // namespace tetrarch
