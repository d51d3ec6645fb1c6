// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A metric on a triangulation: one signed length per edge class, one type per vertex class; and its
/// curvatures.
///
/// The type of a vertex is read from its link. A sphere (or, on the boundary, a disk) makes it finite, a
/// torus or Klein bottle ideal (a cusp), every other closed surface of negative Euler characteristic
/// hyperideal (the link becomes a geodesic boundary component). A projective plane allows no hyperbolic
/// structure. Angles are the extended ones of tetrahedron.hpp, so that curvature is defined for every metric.
/// Source: Yin, sections 4.3.2 and 4.3.3.

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include <optional>
#include <vector>

namespace tetrarch::hyperbolic {

template <class Scalar>
using Metric = Table<EdgeId, Scalar>;
/// Per tetrahedron, the dihedral angles at its edges 01, 02, 03, 12, 13, 23.
template <class Scalar>
using AngleTable = std::vector<SixNumbers<Scalar>>;

/// Nothing for a link that no hyperbolic vertex has: a projective plane, or a surface with boundary other
/// than a disk.
std::optional<VertexType> vertex_type(const SurfaceType& link);

/// The type of every vertex class. Throws PreconditionError where `vertex_type` gives nothing. O(n).
Table<VertexId, VertexType> vertex_types(const Skeleton& skeleton);
/// The types of the four vertices of tetrahedron `tet`.
VertexTypes types_at(const Skeleton& skeleton, const Table<VertexId, VertexType>& types, int tet);
/// The lengths of the six edges of tetrahedron `tet`.
template <class Scalar>
SixNumbers<Scalar> lengths_at(const Skeleton& skeleton, const Metric<Scalar>& metric, int tet) {
  SixNumbers<Scalar> lengths;
  for (int e = 0; e < 6; ++e) lengths[e] = metric[skeleton.edge({tet, e})];
  return lengths;
}

/// The extended dihedral angles of all tetrahedra. O(n).
template <class Scalar>
AngleTable<Scalar> dihedral_angles(const Skeleton& skeleton, const Metric<Scalar>& metric);

/// K_e = 2 pi minus the dihedral angles around e; pi in place of 2 pi for an edge on the boundary. O(n).
template <class Scalar>
Table<EdgeId, Scalar> edge_curvature(const Skeleton& skeleton, const AngleTable<Scalar>& angles);

/// K_v = 2 pi chi(link of v) minus the solid angles at v: 4 pi for an interior point, 2 pi for a point of the
/// boundary. The solid angle at a corner is the sum of its three dihedral angles minus pi (negative where a
/// truncation triangle takes its place). Law: K_v is the sum of K_e over all ends of edges at v. O(n).
template <class Scalar>
Table<VertexId, Scalar> vertex_curvature(const Skeleton& skeleton, const AngleTable<Scalar>& angles);

/// The total edge curvature of the flow: the sum of K_e^2.
template <class Scalar>
Scalar total_squared_curvature(const Table<EdgeId, Scalar>& curvature);
/// max |K_e|.
template <class Scalar>
Scalar max_curvature(const Table<EdgeId, Scalar>& curvature);

} // namespace tetrarch::hyperbolic
