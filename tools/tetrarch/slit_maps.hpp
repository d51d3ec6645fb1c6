// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The maps that `slit` makes.

#include "report.hpp"
#include "slit_options.hpp"

#include "tetrarch/core/progress.hpp"
#include "tetrarch/mesh/boundary_loops.hpp"
#include "tetrarch/mesh/opened.hpp"
#include "tetrarch/show/slit.hpp"
#include "tetrarch/slit/quads.hpp"
#include "tetrarch/slit/slit_map.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tetrarch::program {

/// A map with everything that is told of it.
struct MadeSlitMap {
  mesh::TriangleMesh mesh;
  show::Layout layout;
  show::Fields fields;
  Report report;
  std::optional<slit::QuadMesh> quads;
  std::size_t flipped = 0;    ///< triangles
  double quasi_conformal = 0; ///< the mean
  bool found = true;
};

/// The loops that become circles.
slit::LoopPair chosen(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                      const SlitOptions& options);

/// Obtuse triangles make harmonic maps turn some of them over. Either a few vertices are moved, or the map of
/// the intrinsic Delaunay triangulation, which has no such triangles, is drawn with the mesh's own ones and
/// vertices are moved then: whichever leaves fewer inverted, or else distorts less.
MadeSlitMap slit_map(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                     const SlitOptions& options, const Progress& progress);

} // namespace tetrarch::program
