// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Signs that decide something: on which side of a plane a point lies.
///
/// A number computed in doubles has a sign only where it exceeds the bound of its error. `sign_beyond` says
/// so; a predicate that must know goes on in rational numbers.

#include "tetrarch/numeric/vector.hpp"

#include <cstdint>

namespace tetrarch::numeric {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1, undecided = 2 };

/// The sign of a number that is known up to `error` (which is not negative): undecided within it, so that it
/// is zero only where the error is.
template <class Scalar>
constexpr Sign sign_beyond(const Scalar& value, double error) {
  if (value > error) return Sign::positive;
  if (value < -error) return Sign::negative;
  return value == 0 && error == 0 ? Sign::zero : Sign::undecided;
}

/// The sign of det(b-a, c-a, d-a): positive if the tetrahedron abcd is positively handed (core/tet.hpp), zero
/// if it is flat. Exact for all finite coordinates, so never undecided: in doubles where the error bound
/// allows, else in rational numbers.
Sign volume_sign(const Point& a, const Point& b, const Point& c, const Point& d);

} // namespace tetrarch::numeric
