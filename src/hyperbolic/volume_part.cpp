// SPDX-License-Identifier: GPL-2.0-or-later
#include "angle_data.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace tetrarch::hyperbolic {
namespace {

/// How far the angles at an ideal vertex are from adding up to pi, at the worst one.
template <class Scalar>
Scalar largest_defect(const AngleData<Scalar>& data, const VertexTypes& types) {
  using std::abs;
  Scalar worst = 0;
  for (int v = 0; v < 4; ++v) {
    if (types[v] != VertexType::ideal) continue;
    int turns = -1;
    Scalar rest = 0;
    Scalar size = 0;
    for (int w = 0; w < 4; ++w) {
      if (w == v) continue;
      turns += data.turns[edge_number[v][w]];
      rest += data.rest[edge_number[v][w]];
      size += abs(data.rest[edge_number[v][w]]);
    }
    if (turns != 0) size += numeric::pi<Scalar>();
    worst = numeric::maximum(worst, Scalar(abs(Scalar(rest + turns * numeric::pi<Scalar>())) +
                                           4 * numeric::unit<Scalar>() * size));
  }
  return worst;
}

template <class Scalar>
std::optional<VolumePart<Scalar>> part_in_scalar(const SixNumbers<Scalar>& lengths, const VertexTypes& types,
                                                 const std::array<kernel::EdgeForm<Scalar>, 6>& form,
                                                 const kernel::NullEdges& null) {
  using std::abs;
  std::optional<AngleData<Scalar>> data = angle_data(form, types, null);
  if (!data) return std::nullopt;
  // At an ideal vertex the formula holds for angles that add up to pi. Changes of the angles by no more than
  // twice the defect make them do so: the matrix 2 + (ones) of at most four vertices has an inverse of row
  // sums below 0.84, and every edge has two ends.
  const Scalar defect = 2 * largest_defect(*data, types);
  for (Scalar& error : data->rest_error) error += defect;
  const ClausenSum<Scalar> sum = clausen_sum(*data, types);
  Scalar error = sum.error;
  if (defect > 0) {
    Scalar slopes = sum.slopes;
    for (const Scalar& length : lengths) slopes += abs(length) / 2;
    error += defect * slopes;
  }
  return VolumePart<Scalar>{*data, sum.value, error};
}

/// In 60 digits, and brought back so that the value fits the rounded angles.
std::optional<VolumePart<double>> part_in_60_digits(const SixNumbers<double>& lengths,
                                                    const VertexTypes& types, const kernel::NullEdges& null) {
  SixNumbers<numeric::Real50> precise;
  std::array<kernel::EdgeForm<numeric::Real50>, 6> form;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    precise[e] = lengths[e];
    form[e] = null[e] ? kernel::null_form<numeric::Real50>(types[i], types[j])
                      : kernel::edge_form(types[i], types[j], precise[e]);
  }
  const auto part = part_in_scalar(precise, types, form, null);
  if (!part) return std::nullopt;
  VolumePart<double> rounded;
  rounded.data.turns = part->data.turns;
  numeric::Real50 value = part->value;
  for (int e = 0; e < 6; ++e) {
    rounded.data.rest[e] = static_cast<double>(part->data.rest[e]);
    rounded.data.rest_error[e] = numeric::unit<double>() * std::abs(rounded.data.rest[e]);
    value += precise[e] * (part->data.rest[e] - rounded.data.rest[e]) / 2;
  }
  rounded.data.spread = static_cast<double>(part->data.spread);
  rounded.data.spread_error = numeric::unit<double>() * rounded.data.spread;
  rounded.value = static_cast<double>(value);
  rounded.error = static_cast<double>(part->error) + 2 * numeric::unit<double>() * std::abs(rounded.value);
  return rounded;
}

} // namespace

template <class Scalar>
std::optional<VolumePart<Scalar>> volume_part(const SixNumbers<Scalar>& lengths, const VertexTypes& types,
                                              const std::array<kernel::EdgeForm<Scalar>, 6>& form,
                                              const kernel::NullEdges& null) {
  auto part = part_in_scalar(lengths, types, form, null);
  if constexpr (std::is_same_v<Scalar, double>) {
    if (part && !(part->error < largest_error_in_double)) return part_in_60_digits(lengths, types, null);
  }
  return part;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template std::optional<VolumePart<Scalar>> volume_part(const SixNumbers<Scalar>&, const VertexTypes&,      \
                                                         const std::array<kernel::EdgeForm<Scalar>, 6>&,     \
                                                         const kernel::NullEdges&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
