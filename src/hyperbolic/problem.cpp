// SPDX-License-Identifier: GPL-2.0-or-later
#include "problem.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>

namespace tetrarch::hyperbolic {

Problem::Problem(const Skeleton& skeleton) {
  const Table<VertexId, VertexType> types = vertex_types(skeleton);
  tets.resize(static_cast<std::size_t>(skeleton.tetrahedron_count()));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t) {
    for (int e = 0; e < 6; ++e) tets[t].edge[e] = skeleton.edge({t, e}).value;
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

template <class Scalar>
State<Scalar>::State(const Problem& problem, std::vector<Scalar> start)
    : lengths(std::move(start)), curvature(lengths.size()), angles(problem.tets.size()),
      jacobian(problem.tets.size()), form(lengths.size()) {}

template <class Scalar>
void State<Scalar>::evaluate(const Problem& problem, bool with_jacobian) {
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    form[e] = kernel::edge_form(problem.ends[e][0], problem.ends[e][1], lengths[e]);
    curvature[e] = 2 * numeric::pi<Scalar>();
  }
  first_missing = -1;
  std::array<kernel::EdgeForm<Scalar>, 6> local;
  for (std::size_t t = 0; t < problem.tets.size(); ++t) {
    const Problem::Tet& tet = problem.tets[t];
    for (int e = 0; e < 6; ++e) local[e] = form[tet.edge[e]];
    const kernel::Shape<Scalar> shape(kernel::gram(local, tet.types));
    angles[t] = kernel::angles(shape, local);
    for (int e = 0; e < 6; ++e) curvature[tet.edge[e]] -= angles[t][e];
    if (!shape.exists && first_missing < 0) first_missing = static_cast<int>(t);
    if (!with_jacobian) continue;
    if (shape.exists) {
      jacobian[t] = kernel::jacobian(shape, local);
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
