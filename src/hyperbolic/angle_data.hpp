// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the volume of a tetrahedron is computed from, so that no digit is lost however flat it is.
///
/// A dihedral angle is turns pi + rest with |rest| <= pi/2: near 0 and near pi the rest holds all digits. The
/// two roots z-, z+ of Ushijima's formula are exp i(-spread - phase) and exp i(spread - phase), where
///   spread = atan2(sqrt D, g01 g23 + g02 g13 + g03 g12),   D = -det W
/// (his square root of the determinant of the angles, D^(3/2) / sqrt(prod A_kk), and his sum of products of
/// sines have the factor D / sqrt(prod A_kk) in common), and `phase` follows from the angles.
///
/// In balls, values carry their errors themselves: the bounds that stand beside them say nothing there.

#include "kernel.hpp"
#include "tetrarch/hyperbolic/volume.hpp"

namespace tetrarch::hyperbolic {

/// Beyond this bound double gives way to 60 digits, which take a hundred times as long: an ordinary
/// tetrahedron stays below 1e-14.
inline constexpr double largest_error_in_double = 1e-13;

template <class Scalar>
struct AngleData {
  std::array<int, 6> turns{};
  SixNumbers<Scalar> rest{};
  Scalar spread = 0;
  /// Bounds of the errors; infinite where the determinant has drowned in rounding.
  SixNumbers<Scalar> rest_error{};
  Scalar spread_error = 0;
};

/// Of a tetrahedron that exists, or nothing; `null` edges are meant to have g = 0, others not. The errors are
/// those of rounding: the lengths count as exact, and `form` as theirs within four units.
template <class Scalar>
std::optional<AngleData<Scalar>> angle_data(const std::array<kernel::EdgeForm<Scalar>, 6>& form,
                                            const VertexTypes& types, const kernel::NullEdges& null = {});

/// From angles alone; without error bounds. Nothing where they belong to no hyperbolic tetrahedron.
template <class Scalar>
std::optional<AngleData<Scalar>> angle_data_of(const SixNumbers<Scalar>& angles);

/// The sum of sixteen values of Clausen's function.
template <class Scalar>
struct ClausenSum {
  Scalar value;
  /// Of `value`, to first order in rounding and to second order in the errors of the data, in which `value`
  /// + 1/2 sum l theta is stationary.
  Scalar error;
  Scalar slopes; ///< no less than sum over the angles of |d value / d theta|, the spread held
};

/// Where a vertex is ideal, one of the roots is 1 and the angles at the vertex add up to pi exactly; `types`
/// tells the formula so. (Without that word an ideal vertex is the limit of others, and loses no digits.)
template <class Scalar>
ClausenSum<Scalar> clausen_sum(const AngleData<Scalar>& data, const VertexTypes& types);

/// The part of a tetrahedron in F: with theta the angles of `data` to the last digit, `value` +
/// 1/2 sum l theta is within `error` of V + 1/2 sum l theta of the exact tetrahedron with these lengths.
template <class Scalar>
struct VolumePart {
  AngleData<Scalar> data;
  Scalar value;
  Scalar error;
};

/// Of a tetrahedron that exists; else nothing. In double, a tetrahedron so flat that the bound would exceed
/// 1e-13 is computed in 60 digits.
template <class Scalar>
std::optional<VolumePart<Scalar>> volume_part(const SixNumbers<Scalar>& lengths, const VertexTypes& types,
                                              const std::array<kernel::EdgeForm<Scalar>, 6>& form,
                                              const kernel::NullEdges& null = {});

} // namespace tetrarch::hyperbolic
