// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/metric.hpp"

#include "kernel.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::hyperbolic {

std::optional<VertexType> vertex_type(const SurfaceType& link) {
  if (link.is_sphere() || link.is_disk()) return VertexType::finite;
  if (!link.is_closed() || link.euler > 0) return std::nullopt;
  return link.euler == 0 ? VertexType::ideal : VertexType::hyperideal;
}

Table<VertexId, VertexType> vertex_types(const Skeleton& skeleton) {
  Table<VertexId, VertexType> types(skeleton.vertex_count());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const std::optional<VertexType> type = vertex_type(skeleton.link(v));
    if (!type)
      throw PreconditionError("vertex " + std::to_string(v.value) + " has the link '" +
                              skeleton.link(v).str() + "', which no hyperbolic vertex has");
    types[v] = *type;
  }
  return types;
}

VertexTypes types_at(const Skeleton& skeleton, const Table<VertexId, VertexType>& types, int tet) {
  VertexTypes four{};
  for (int v = 0; v < 4; ++v) four[v] = types[skeleton.vertex({tet, v})];
  return four;
}

template <class Scalar>
AngleTable<Scalar> dihedral_angles(const Skeleton& skeleton, const Metric<Scalar>& metric) {
  if (metric.size() != skeleton.edge_count())
    throw PreconditionError("dihedral_angles: a metric needs one length per edge class");
  const Table<VertexId, VertexType> types = vertex_types(skeleton);
  AngleTable<Scalar> angles(static_cast<std::size_t>(skeleton.tetrahedron_count()));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t)
    angles[t] = extended_dihedral_angles(lengths_at(skeleton, metric, t), types_at(skeleton, types, t));
  return angles;
}

template <class Scalar>
Table<EdgeId, Scalar> edge_curvature(const Skeleton& skeleton, const AngleTable<Scalar>& angles) {
  Table<EdgeId, Scalar> curvature(skeleton.edge_count());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    Scalar k = skeleton.is_boundary(e) ? numeric::pi<Scalar>() : Scalar(2 * numeric::pi<Scalar>());
    for (const Walk& w : skeleton.around(e)) k -= angles[w.tet][w.edge().edge];
    curvature[e] = k;
  }
  return curvature;
}

template <class Scalar>
Table<VertexId, Scalar> vertex_curvature(const Skeleton& skeleton, const AngleTable<Scalar>& angles) {
  Table<VertexId, Scalar> curvature(skeleton.vertex_count());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    Scalar k = 2 * skeleton.link(v).euler * numeric::pi<Scalar>();
    for (const TetVertex corner : skeleton.preimages(v)) {
      k += numeric::pi<Scalar>();
      for (int w = 0; w < 4; ++w)
        if (w != corner.vertex) k -= angles[corner.tet][edge_number[corner.vertex][w]];
    }
    curvature[v] = k;
  }
  return curvature;
}

template <class Scalar>
Scalar total_squared_curvature(const Table<EdgeId, Scalar>& curvature) {
  Scalar sum = 0;
  for (const Scalar& k : curvature) sum += k * k;
  return sum;
}

template <class Scalar>
Scalar max_curvature(const Table<EdgeId, Scalar>& curvature) {
  return kernel::largest_magnitude(curvature);
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template AngleTable<Scalar> dihedral_angles(const Skeleton&, const Metric<Scalar>&);                       \
  template Table<EdgeId, Scalar> edge_curvature(const Skeleton&, const AngleTable<Scalar>&);                 \
  template Table<VertexId, Scalar> vertex_curvature(const Skeleton&, const AngleTable<Scalar>&);             \
  template Scalar total_squared_curvature(const Table<EdgeId, Scalar>&);                                     \
  template Scalar max_curvature(const Table<EdgeId, Scalar>&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
