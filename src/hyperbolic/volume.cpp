// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/volume.hpp"

#include "angle_data.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace tetrarch::hyperbolic {
namespace {

/// Angles as half turns and rests; 1 for an angle nearer to pi than to 0. The nearest number to pi is less
/// than pi by `rest_of_pi`, which counts beside small rests.
template <class Scalar>
void split(const SixNumbers<Scalar>& angles, AngleData<Scalar>& data) {
  constexpr double rest_of_pi = 1.2246467991473532e-16; // the sine of the double nearest to pi
  const bool is_double = std::numeric_limits<Scalar>::digits == std::numeric_limits<double>::digits;
  for (int e = 0; e < 6; ++e) {
    data.turns[e] = 2 * angles[e] > numeric::pi<Scalar>() ? 1 : 0;
    data.rest[e] = angles[e];
    if (angles[e] == numeric::pi<Scalar>()) {
      data.rest[e] = 0; // meant to be pi
    } else if (data.turns[e] == 1) {
      data.rest[e] = (angles[e] - numeric::pi<Scalar>()) - (is_double ? rest_of_pi : 0.0);
    }
  }
}

/// Minus the determinant of the matrix G with G_kk = 1, G_kl = -cos theta_ij. Where the signs of the cosines
/// are those of a flat tetrahedron (G_kl = p_k p_l for some signs p, but for squares of small angles), G is
/// that matrix of rank one less 2 H, H_kl = p_k p_l sin^2(rest_ij / 2), and the determinant, of sixth order,
/// is 16 det H - 8 times the sum of the adjugate of H: nothing of lower order is there to cancel.
template <class Scalar>
Scalar minus_determinant(const AngleData<Scalar>& data) {
  using std::cos;
  using std::sin;
  const auto sign = [&](int k, int l) { return data.turns[opposite_edge(edge_number[k][l])] == 0 ? -1 : 1; };
  std::array<int, 4> p{1, sign(0, 1), sign(0, 2), sign(0, 3)};
  const bool flat_signs = p[1] * p[2] == sign(1, 2) && p[1] * p[3] == sign(1, 3) && p[2] * p[3] == sign(2, 3);
  numeric::Matrix4<Scalar> m;
  for (int k = 0; k < 4; ++k) {
    m[k][k] = flat_signs ? 0 : 1;
    for (int l = 0; l < k; ++l) {
      const Scalar& rest = data.rest[opposite_edge(edge_number[k][l])];
      const Scalar half = sin(Scalar(rest / 2));
      m[k][l] = flat_signs ? Scalar(half * half) : Scalar(sign(k, l) * cos(rest));
      m[l][k] = m[k][l];
    }
  }
  const numeric::Minors<Scalar> minors(m);
  if (!flat_signs) return -minors.determinant();
  Scalar sum = 0;
  for (const auto& row : numeric::adjugate(m, minors))
    for (const Scalar& entry : row) sum += entry;
  return 8 * sum - 16 * minors.determinant();
}

/// sinA sinD + sinB sinE + sinC sinF.
template <class Scalar>
Scalar sine_sum(const AngleData<Scalar>& data) {
  using std::abs;
  using std::sin;
  Scalar sum = 0;
  for (int e = 0; e < 3; ++e)
    sum += sin(Scalar(abs(data.rest[e]))) * sin(Scalar(abs(data.rest[opposite_edge(e)])));
  return sum;
}

} // namespace

template <class Scalar>
std::optional<AngleData<Scalar>> angle_data_of(const SixNumbers<Scalar>& angles) {
  using std::atan2;
  using std::sqrt;
  AngleData<Scalar> data;
  split(angles, data);
  const Scalar square = minus_determinant(data);
  if (!(square > 0)) return std::nullopt;
  data.spread = atan2(Scalar(sqrt(square)), sine_sum(data));
  return data;
}

template <class Scalar>
Scalar volume(const SixNumbers<Scalar>& angles) {
  const auto data = angle_data_of(angles);
  return data ? clausen_sum(*data, all_hyperideal).value : Scalar(0);
}

namespace {

std::optional<Estimate<double>> in_60_digits(const SixNumbers<double>& lengths, const VertexTypes& types) {
  SixNumbers<numeric::Real50> precise;
  for (int e = 0; e < 6; ++e) precise[e] = lengths[e];
  const auto estimate = volume(precise, types);
  if (!estimate) return std::nullopt;
  const auto value = static_cast<double>(estimate->value);
  return Estimate<double>{value, static_cast<double>(estimate->error) + 0x1p-52 * value};
}

} // namespace

template <class Scalar>
std::optional<Estimate<Scalar>> volume(const SixNumbers<Scalar>& lengths, const VertexTypes& types) {
  using std::abs;
  const auto part = volume_part(lengths, types, kernel::edge_forms(lengths, types));
  if (!part) return std::nullopt;
  Scalar error = part->error;
  for (int e = 0; e < 6; ++e) error += abs(lengths[e]) * part->data.rest_error[e] / 2;
  if constexpr (std::is_same_v<Scalar, double>) {
    if (!(error < largest_error_in_double)) return in_60_digits(lengths, types);
  }
  return Estimate<Scalar>{part->value, error};
}

/// A ball holds the exact angles, and so whatever the formula makes of them.
template <>
std::optional<Estimate<numeric::Ball>> volume(const SixNumbers<numeric::Ball>& lengths,
                                              const VertexTypes& types) {
  const auto data = angle_data(kernel::edge_forms(lengths, types), types);
  if (!data) return std::nullopt;
  return Estimate<numeric::Ball>{clausen_sum(*data, types).value, numeric::Ball(0)};
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template std::optional<AngleData<Scalar>> angle_data_of(const SixNumbers<Scalar>&);                        \
  template Scalar volume(const SixNumbers<Scalar>&);                                                         \
  template std::optional<Estimate<Scalar>> volume(const SixNumbers<Scalar>&, const VertexTypes&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
