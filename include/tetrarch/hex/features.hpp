// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What must not be rounded off: the patches of a solid's surface, the ridges between them, their corners.
///
///        corner           An edge is sharp where the normals of its triangles differ by more than an angle.
///           o-------.     Sharp edges that do not separate two patches, and patches too small to matter,
///          /  patch |     are left out. A vertex is a corner where other than two sharp edges meet, or
///         /--ridge--'     where two make a sharp turn.

#include "tetrarch/product/solid.hpp"

#include <vector>

namespace tetrarch::hex {

using product::Point;

/// Sharp edges in a row: from corner to corner, or closed.
struct Ridge {
  std::vector<int> vertices; ///< of the solid's mesh; of a closed one the first is the last, too
  bool is_closed = false;    ///< and has no corner on it
};

struct Features {
  std::vector<int> patch; ///< of each triangle of the boundary
  int patches = 0;
  std::vector<Ridge> ridges;
  std::vector<int> corners; ///< vertices of the solid's mesh, increasing
};

struct FeatureOptions {
  double sharp = 40; ///< degrees between normals
  double turn = 60;  ///< degrees between two sharp edges in a row, for a corner
  /// Of a patch: the diagonal of its box. A smaller one joins the neighbor with which it has the longest
  /// ridge.
  double least_extent = 0;
};

/// O(n log n), times the patches that are too small.
Features features(const product::Solid& solid, const FeatureOptions& options = {});

} // namespace tetrarch::hex
