// SPDX-License-Identifier: GPL-2.0-or-later
#include "structure_volume.hpp"

#include "angle_data.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <cmath>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

/// A sum that carries along what its additions round off.
template <class Scalar>
struct CarefulSum {
  Scalar sum = 0;
  Scalar lost = 0;

  void add(const Scalar& x) {
    const Scalar next = sum + x;
    const Scalar part = next - sum;
    lost += (sum - (next - part)) + (x - part);
    sum = next;
  }
  Scalar total() const { return sum + lost; }
};

/// The angles around one edge.
template <class Scalar>
struct AngleTotal {
  int turns = 0;
  CarefulSum<Scalar> rest;
  Scalar error = 0;

  /// 2 pi / order less the angles. `rest_of_pi`: pi less its nearest double.
  Scalar curvature(double order) const {
    constexpr double rest_of_pi = 1.2246467991473532e-16;
    CarefulSum<Scalar> k = rest;
    const int whole = order == 1 ? 2 : 0;
    for (int turn = turns; turn < whole; ++turn) k.add(-numeric::pi<Scalar>());
    for (int turn = whole; turn < turns; ++turn) k.add(numeric::pi<Scalar>());
    if (whole == 0) k.add(Scalar(-2 * numeric::pi<Scalar>() / order));
    if constexpr (std::is_same_v<Scalar, double>) k.lost += (turns - whole) * rest_of_pi;
    return -k.total();
  }
};

} // namespace

template <class Scalar>
Estimate<Scalar> structure_volume(const Problem& problem, const State<Scalar>& state,
                                  const Scalar& last_step) {
  using std::abs;
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  CarefulSum<Scalar> volume;
  Scalar error = 0;
  std::vector<AngleTotal<Scalar>> around(state.lengths.size());
  SixNumbers<Scalar> lengths;
  std::array<kernel::EdgeForm<Scalar>, 6> form;
  for (const Problem::Tet& tet : problem.tets) {
    for (int e = 0; e < 6; ++e) {
      lengths[e] = state.lengths[tet.edge[e]];
      form[e] = state.form[tet.edge[e]];
    }
    const auto part = volume_part(lengths, tet.types, form, problem.null_edges(tet));
    if (!part) return {volume.total(), infinity};
    volume.add(tet.orientation * part->value);
    error += part->error;
    for (int e = 0; e < 6; ++e) {
      AngleTotal<Scalar>& total = around[tet.edge[e]];
      total.turns += part->data.turns[e]; // of a tetrahedron turned over, pi + r counts as pi - r
      total.rest.add(tet.orientation * part->data.rest[e]);
      total.error += part->data.rest_error[e];
    }
  }
  for (std::size_t e = 0; e < around.size(); ++e) {
    if (problem.is_null(static_cast<int>(e))) continue;
    const Scalar k = around[e].curvature(problem.order[e]);
    volume.add(-state.lengths[e] * k / 2);
    error += abs(state.lengths[e]) * (abs(k) + numeric::unit<Scalar>()) * numeric::unit<Scalar>() +
             (abs(k) + around[e].error) * last_step;
    if (problem.order[e] != 1) error += 8 * abs(state.lengths[e]) * numeric::unit<Scalar>();
  }
  const Scalar value = volume.total();
  return {value, error + 2 * numeric::unit<Scalar>() * abs(value)};
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Estimate<Scalar> structure_volume(const Problem&, const State<Scalar>&, const Scalar&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
