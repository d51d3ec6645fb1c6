// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From a triangulated solid to a handful of truncated tetrahedra: the conversion of section 4.2.2.
///
///     solid, n tetrahedra  --[1] merge the interior vertices away
///                          --[2] cone every boundary component to one new vertex
///                          --[3] merge all old vertices away
///                          --[4] truncate: the new vertices are ideal, slice them off
///
/// and then simplify to a local minimum. A boundary sphere is coned to a finite vertex, that is, a ball is
/// filled in; this vertex too is merged away where another one remains, unless spheres are to be kept. The
/// input may have ideal vertices besides real boundary. Steps [1] and [3] also make 3-2, 2-0 and 2-1 moves:
/// merges alone would stop at hubs of large valence, which block them. No step recomputes the whole complex.
/// Source: Yin, section 4.2.2.

#include "tetrarch/core/surface.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <string>

namespace tetrarch::moves {

struct TruncateOptions {
  /// Leave a vertex for each boundary sphere, and truncate it too.
  bool keep_spheres = false;
  SimplifyOptions simplify;
};

/// The fate of a boundary component of the input. Components are numbered as by `boundary_components`: real
/// ones by first face, then ideal vertices.
struct BoundaryImage {
  SurfaceType type;
  int triangles = 0;       ///< of a real component; 0 of an ideal vertex
  TetVertex vertex{-1, 0}; ///< a corner of the result that is truncated along it; tet -1: filled in
};

/// Sizes after each step of the conversion.
struct TruncateStep {
  std::string name;
  int tetrahedra = 0;
  int vertices = 0;
  int edges = 0;
};

struct Truncation {
  Triangulation tri; ///< closed: all its vertices are to be truncated, except finite ones
  std::vector<BoundaryImage> boundary;
  std::vector<TruncateStep> steps;
  MoveCounts counts;
  /// Finite vertices left: one for each component without other vertices.
  int finite_vertices = 0;
};

/// Throws PreconditionError if the triangulation is invalid (the message names the defect). Near-linear;
/// about 2 microseconds per tetrahedron. Deterministic for `options.simplify.seed`.
[[nodiscard]] Truncation truncate(const Triangulation& tri, const TruncateOptions& options = {},
                                  const Progress& progress = {});

} // namespace tetrarch::moves
