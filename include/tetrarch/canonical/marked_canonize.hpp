// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Canonical cells of a manifold with marked edges.
///
/// What decides whether two marked manifolds are the same is the graph of marked edges with its orders, not
/// the cone angles: by Mostow's and Prasad's rigidity a homeomorphism of orbifolds is homotopic to an
/// isometry. So the cells are not those of the structure with cone angles, of whose cone axes a cell may have
/// none among its edges, but of the structure in which every marked edge has a parabolic meridian. There a
/// null edge joins two planes that touch: the sum of its vertex vectors is lightlike, so that it lies on the
/// boundary of the convex hull and is an edge of a cell. Each keeps its order as a color. Two marked
/// manifolds that have this structure are homeomorphic, marks included, exactly if their colored cells are.
///
/// It exists for a graph whose exterior has no essential annuli with meridians or curves on the boundary;
/// where a closed curve is marked (a knot with a cone angle) its null edge would end in cusps and has no
/// place, which `why_not` says. Signs are decided in double precision: a tilt within `sign_margin` of 0
/// counts as flat, and nothing of the cells is proved. Source: section 4 of Heard's documentation of Orb,
/// 2007, for the colors; Kojima 1990 for the cells.

#include "tetrarch/canonical/canonize.hpp"

namespace tetrarch::canonical {

struct MarkedCanonizeOptions {
  double sign_margin = 1e-8;
  int attempts = 40; ///< triangulations from which flips start
  std::uint64_t seed = 1;
};

struct MarkedCanonical {
  Canonical canonical; ///< with marks; `isometry_signature` tells them (core: marked_signature)
  double volume = 0;   ///< of the structure with parabolic meridians
  std::string why_not; ///< empty: the cells were found
};

/// `tri` is closed and connected. Throws PreconditionError for marks with a fault, or without any.
/// Milliseconds for ten tetrahedra, where a structure is found at once.
[[nodiscard]] MarkedCanonical canonize_marked(const Triangulation& tri, const Marks& marks,
                                              const MarkedCanonizeOptions& options = {},
                                              const Progress& progress = {});

} // namespace tetrarch::canonical
