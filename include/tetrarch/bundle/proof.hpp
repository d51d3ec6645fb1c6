// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The proof that a triangulation is the circle bundle that it is meant to be.
///
/// That a result is a closed manifold is not enough: where the shifts do not cancel around a vertex there is
/// still a manifold, with an exceptional fibre in place of a fibre. From the gluings of the total space and
/// the projection alone it is checked that
///   - every gluing lies over a gluing of the surface or inside one triangle: the projection is simplicial;
///   - over each triangle the tetrahedra form one ring, which passes each corner N times;
///   - over each vertex lies one circle of N edges and N vertices;
///   - the links of vertices are spheres, on the boundary disks.
/// So the preimage of any point is a circle, and the bundle is trivial over the star of each vertex. How the
/// tetrahedra of a triangle's ring lie over each other gives heights, which differ between two triangles that
/// share an edge; what they differ by in all is the Euler number, counted here with no use of shifts.
/// Source: Yin, 6.4 and 7.4; Steenrod, "The Topology of Fibre Bundles", section 35 (the obstruction cocycle).

#include "tetrarch/bundle/circle_bundle.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <string>

namespace tetrarch::bundle {

/// The fibres as seen from the gluings.
struct Fibers {
  /// Of each vertex of the total space: its number on its fibre, 0 to N-1, counted along the fibre's
  /// direction.
  Table<VertexId, int> place;
  /// Of each edge of the total space: 0 if it lies over an edge of the surface, else +1 or -1: whether the
  /// fibre's direction is that of the class.
  Table<EdgeId, signed char> direction;
  /// Of each corner 3 t + c: whether upwards in the ring of triangle t (by which the bundle is oriented) is
  /// along the direction of the fibre below, +1, or against it, -1.
  std::vector<signed char> up;
  /// Of each side: how far the edge of least number over it rises, in the ring of its triangle, from the
  /// start of the side to its end; and where on the two fibres it starts and ends.
  struct Reference {
    int rise = 0;
    int start = 0;
    int stop = 0;
  };
  std::vector<Reference> reference;
};

/// That a triangulation is a circle bundle, or what speaks against it.
struct Proof {
  std::string failure; ///< what is wrong, a sentence; empty: this is a circle bundle with fibres of N edges
  Fibers fibers;       ///< only without a failure
  bool has_euler_number = false; ///< the surface is closed
  /// With the total space oriented by the first triangle, counterclockwise, and levels that rise: chi for the
  /// unit tangent bundle.
  int euler_number = 0;
};

/// O(tetrahedra). The skeleton must be that of `bundle.total`.
Proof prove(const CircleBundle& bundle, const Skeleton& skeleton, const Progress& progress = {});

} // namespace tetrarch::bundle
