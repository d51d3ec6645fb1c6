// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From a diagram to the manifold: the 3-sphere minus an open neighborhood of the graph.
///
/// The sphere of the picture is cut into triangles, one for each dart: node, next node, center of the region
/// to the left. Over it stands the product with an interval, three tetrahedra for each triangle, a cone above
/// and one below; that is the 3-sphere. An arc runs on the upper level where it passes over and on the lower
/// one elsewhere; where it changes, it takes the diagonal of its wall. Then the arcs are drilled (moves:
/// drilling), by crushing: so every component of the graph becomes one ideal vertex, a cusp of a knot, a
/// surface of genus n of a component with n independent cycles.
///
/// Crushing wants every region to have a corner at a crossing, and no cycle of the graph to stay on one
/// level; kinks provide for that, and parts are pushed over one another. So the exterior of a diagram of c
/// crossings has about 10 c tetrahedra before it is simplified.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/diagram/diagram.hpp"
#include "tetrarch/moves/monodromy.hpp"

#include <cstdint>
#include <optional>

namespace tetrarch::diagram {

/// The 3-sphere, with the graph in its edges.
struct Sphere {
  Triangulation tri;
  std::vector<TetEdge> arcs;       ///< one for each arc that the diagram with its kinks has
  std::vector<TetVertex> vertices; ///< one for each vertex of valence 3 and more
  int hand = 1; ///< of tetrahedron 0: +1 if it is right-handed in space, where the picture is seen from above
};
/// The diagram is made connected, and gets kinks where crushing wants them. O(darts) for one part.
/// Throws PreconditionError for a diagram without arcs.
Sphere sphere_with(const Diagram& diagram);

struct ExteriorOptions {
  std::uint64_t seed = 1;
};

/// Two copies of the exterior, glued along the spheres round the vertices of valence 3 and more, in which the
/// edges end as punctures: the edges become closed, and a cusp each. Where it is hyperbolic, the reflection
/// that exchanges the copies is an isometry, the punctured spheres are totally geodesic, and half of it is
/// the structure on the exterior whose meridians are parabolic. So this has twice the volume of that. A
/// component without such a vertex is there twice. Throws PreconditionError if there is no such vertex at
/// all.
Triangulation doubled_exterior(const Diagram& diagram, const ExteriorOptions& options = {},
                               const Progress& progress = {});

/// The exterior with few tetrahedra: all vertices ideal, a finite one only where the graph is a tree (or a
/// component of it is and no other is left). Near-linear: 50 microseconds a crossing.
Triangulation exterior(const Diagram& diagram, const ExteriorOptions& options = {},
                       const Progress& progress = {});

/// The exterior with as few tetrahedra as `exterior` has, and the homomorphism from the groups of its
/// boundary to that of the graph (which is the handlebody's group, or that of a solid torus): its kernel is
/// what the meridians generate. The exterior forgets the graph, this does not.
struct PairExterior {
  Triangulation tri;
  moves::Monodromy monodromy;
};
/// Nothing where the words cannot be carried along the way that the simplification took (where a tree among
/// the components needs to be coned), or grow beyond a million letters; another seed may help. As fast as
/// `exterior`, three times.
std::optional<PairExterior> pair_exterior(const Diagram& diagram, const ExteriorOptions& options = {},
                                          const Progress& progress = {});

} // namespace tetrarch::diagram
