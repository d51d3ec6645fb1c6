// SPDX-License-Identifier: GPL-2.0-or-later
#include "cusps.hpp"

#include "tetrarch/embed/placed.hpp"
#include "tetrarch/hyperbolic/cusp.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>

namespace tetrarch::embed {
namespace {

using hyperbolic::Metric;

/// By Heron's formula in the squares of the sides.
template <class Scalar>
Scalar horosphere_triangle_area(const Matrix4<Scalar>& w, int i) {
  using std::sqrt;
  const auto& o = face_vertex[i];
  const Scalar a = hyperbolic::squared_horosphere_side(w, i, o[0], o[1]);
  const Scalar b = hyperbolic::squared_horosphere_side(w, i, o[1], o[2]);
  const Scalar c = hyperbolic::squared_horosphere_side(w, i, o[2], o[0]);
  return sqrt(Scalar(4 * a * b - (a + b - c) * (a + b - c))) / 4;
}

/// Adds to the length of every edge what its ends move out.
template <class Scalar>
void move_out(const Skeleton& skeleton, const Table<VertexId, Scalar>& by, Metric<Scalar>& lengths) {
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const auto [p, q] = skeleton.ends(e);
    lengths[e] += by[p] + by[q];
  }
}

} // namespace

template <class Scalar>
Metric<Scalar> with_cusp_area(const Skeleton& skeleton, const Metric<Scalar>& lengths,
                              const Table<VertexId, VertexType>& types, double area) {
  using std::log;
  constexpr double least_length = 0.2;
  Table<VertexId, Scalar> found(skeleton.vertex_count(), Scalar(0));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t) {
    const VertexTypes at = hyperbolic::types_at(skeleton, types, t);
    const Matrix4<Scalar> w = hyperbolic::gram_matrix(hyperbolic::lengths_at(skeleton, lengths, t), at);
    for (int i = 0; i < 4; ++i)
      if (at[i] == VertexType::ideal) found[skeleton.vertex({t, i})] += horosphere_triangle_area(w, i);
  }
  Metric<Scalar> moved = lengths;
  Table<VertexId, Scalar> by(skeleton.vertex_count(), Scalar(0));
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (types[v] == VertexType::ideal) by[v] = log(Scalar(found[v] / area)) / 2;
  move_out(skeleton, by, moved);

  Scalar missing = 0;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const auto [p, q] = skeleton.ends(e);
    if (types[p] != VertexType::ideal && types[q] != VertexType::ideal) continue;
    missing = std::max(missing, Scalar(least_length - moved[e]));
  }
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    by[v] = types[v] == VertexType::ideal ? missing : Scalar(0);
  move_out(skeleton, by, moved);
  return moved;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Metric<Scalar> with_cusp_area(const Skeleton&, const Metric<Scalar>&,                             \
                                         const Table<VertexId, VertexType>&, double);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
