// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The proof that a triangulation is the intended circle bundle.
///
/// A closed manifold is not enough: if the shifts do not cancel around a vertex, the result is still a
/// manifold, with an exceptional fiber instead of a fiber. The proof uses the gluings of the total space and
/// the projection alone, and checks that
///   - every gluing lies over a gluing of the surface or inside one triangle: the projection is simplicial;
///   - over each triangle the tetrahedra form one ring, which passes each corner N times;
///   - over each vertex lies one circle of N edges and N vertices;
///   - the links of vertices are spheres, on the boundary disks.
/// So the preimage of any point is a circle, and the bundle is trivial over the star of each vertex. How the
/// tetrahedra of a triangle's ring lie over each other gives heights, which differ between two triangles that
/// share an edge; the differences add up to the Euler number, which is counted here without the shifts.
/// Source: Yin, 6.4 and 7.4; Steenrod, "The Topology of Fibre Bundles", section 35 (the obstruction cocycle).

#include "tetrarch/bundle/circle_bundle.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <string>

namespace tetrarch::bundle {

/// The fibers as seen from the gluings.
struct Fibers {
  /// Of each vertex of the total space: its number on its fiber, 0 to N-1, counted along the fiber's
  /// direction.
  Table<VertexId, int> place;
  /// Of each edge of the total space: 0 if it lies over an edge of the surface, else +1 or -1: whether the
  /// fiber's direction is that of the class.
  Table<EdgeId, signed char> direction;
  /// Of each corner 3 t + c: whether upwards in the ring of triangle t (by which the bundle is oriented) is
  /// along the direction of the fiber below, +1, or against it, -1.
  std::vector<signed char> up;
  /// Of each side: how far the edge of least number over it rises, in the ring of its triangle, from the
  /// start of the side to its end; and where on the two fibers it starts and ends.
  struct Reference {
    int rise = 0;
    int start = 0;
    int stop = 0;
  };
  std::vector<Reference> reference;
};

/// The proof that a triangulation is a circle bundle, or the reason why it is none.
struct Proof {
  std::string failure; ///< what is wrong, a sentence; empty: this is a circle bundle with fibers of N edges
  Fibers fibers;       ///< only without a failure
  bool has_euler_number = false; ///< the surface is closed
  /// With the total space oriented by the first triangle, counterclockwise, and levels that rise: chi for the
  /// unit tangent bundle.
  int euler_number = 0;
};

/// O(tetrahedra). The skeleton must be that of `bundle.total`.
Proof prove(const CircleBundle& bundle, const Skeleton& skeleton, const Progress& progress = {});

} // namespace tetrarch::bundle
