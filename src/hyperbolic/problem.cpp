// SPDX-License-Identifier: GPL-2.0-or-later
#include "problem.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>

namespace tetrarch::hyperbolic {

Problem::Problem(const Skeleton& skeleton)
    : Problem(skeleton, vertex_types(skeleton), EdgeOrders(skeleton.edge_count(), 1.0)) {}

Problem::Problem(const Skeleton& skeleton, const Table<VertexId, VertexType>& types, const EdgeOrders& orders)
    : order(orders.values()) {
  tets.resize(static_cast<std::size_t>(skeleton.tetrahedron_count()));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t) {
    for (int e = 0; e < 6; ++e) tets[t].edge[e] = skeleton.edge({t, e}).value;
    for (int v = 0; v < 4; ++v) tets[t].vertex[v] = skeleton.vertex({t, v}).value;
    tets[t].types = types_at(skeleton, types, t);
  }
  std::vector<int> cusp_number(static_cast<std::size_t>(skeleton.vertex_count()), -1);
  int cusps = 0;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (types[v] == VertexType::ideal) cusp_number[v.value] = cusps++;
  ends_at_cusp.assign(static_cast<std::size_t>(cusps),
                      std::vector<int>(static_cast<std::size_t>(skeleton.edge_count()), 0));
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const auto [a, b] = skeleton.ends(e);
    ends.push_back({types[a], types[b]});
    for (const VertexId v : {a, b})
      if (cusp_number[v.value] >= 0) ++ends_at_cusp[cusp_number[v.value]][e.value];
  }
}

kernel::NullEdges Problem::null_edges(const Tet& tet) const {
  kernel::NullEdges null{};
  for (int e = 0; e < 6; ++e) null[e] = is_null(tet.edge[e]);
  return null;
}

namespace {

/// As the angle of a tetrahedron that has passed through a flat one, where it was 0 or pi.
template <class Scalar>
Scalar turned_over(const Scalar& angle) {
  return 2 * angle > numeric::pi<Scalar>() ? Scalar(2 * numeric::pi<Scalar>() - angle) : Scalar(-angle);
}

} // namespace

template <class Scalar>
State<Scalar>::State(const Problem& problem, std::vector<Scalar> start)
    : lengths(std::move(start)), curvature(lengths.size()), angles(problem.tets.size()),
      jacobian(problem.tets.size()), form(lengths.size()) {}

template <class Scalar>
void State<Scalar>::evaluate(const Problem& problem, bool with_jacobian) {
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (problem.is_null(static_cast<int>(e))) {
      form[e] = kernel::null_form<Scalar>(problem.ends[e][0], problem.ends[e][1]);
      curvature[e] = 0;
    } else {
      form[e] = kernel::edge_form(problem.ends[e][0], problem.ends[e][1], lengths[e]);
      curvature[e] = 2 * numeric::pi<Scalar>();
      if (problem.order[e] != 1) curvature[e] /= problem.order[e];
    }
  }
  first_missing = -1;
  std::array<kernel::EdgeForm<Scalar>, 6> local;
  for (std::size_t t = 0; t < problem.tets.size(); ++t) {
    const Problem::Tet& tet = problem.tets[t];
    for (int e = 0; e < 6; ++e) local[e] = form[tet.edge[e]];
    const kernel::Shape<Scalar> shape(kernel::gram(local, tet.types));
    angles[t] = kernel::angles(shape, local);
    if (tet.orientation < 0)
      for (Scalar& angle : angles[t]) angle = turned_over(angle);
    for (int e = 0; e < 6; ++e) // the angles at a null edge are 0
      if (!problem.is_null(tet.edge[e])) curvature[tet.edge[e]] -= angles[t][e];
    if (!shape.exists && first_missing < 0) first_missing = static_cast<int>(t);
    if (!with_jacobian) continue;
    if (shape.exists) {
      jacobian[t] = kernel::jacobian(shape, local);
      if (tet.orientation < 0)
        for (auto& row : jacobian[t])
          for (Scalar& entry : row) entry = -entry;
    } else {
      for (auto& row : jacobian[t]) row.fill(Scalar(0));
    }
  }
}

template <class Scalar>
Scalar State<Scalar>::residual() const {
  return kernel::largest_magnitude(curvature);
}

template <class Scalar>
Scalar State<Scalar>::squared_curvature() const {
  Scalar sum = 0;
  for (const Scalar& k : curvature) sum += k * k;
  return sum;
}

template <class Scalar>
int State<Scalar>::longest_edge() const {
  using std::abs;
  const auto longer = [](const Scalar& a, const Scalar& b) { return abs(a) < abs(b); };
  return static_cast<int>(std::max_element(lengths.begin(), lengths.end(), longer) - lengths.begin());
}

template <class Scalar>
Scalar State<Scalar>::longest() const {
  using std::abs;
  return abs(lengths[longest_edge()]);
}

#define TETRARCH_INSTANTIATE(Scalar) template struct State<Scalar>;
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
