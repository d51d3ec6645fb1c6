// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Isometries of the upper half space as Moebius transformations of its plane at infinity:
/// zeta -> (a zeta + b) / (c zeta + d) with ad - bc = 1, of the conjugate of zeta if orientation is reversed.
///
/// A vector (x, y, z, t) is the Hermitian matrix X = [[t + z, x + iy], [x - iy, t - z]], whose determinant is
/// -<v,v>, and A moves it to A X A* (to A conj(X) A* if reversing). This agrees with the model's plane at
/// infinity (model.hpp), where zeta is the vector w w*, w = (zeta, 1). A and -A give the same isometry, so A
/// is determined up to sign. Source: Yin, section 4.4.1 (where ad - bc = 1 is misprinted).

#include "tetrarch/embed/lorentz.hpp"

namespace tetrarch::embed {

/// A complex number over any scalar: std::complex promises nothing for scalars other than the built-in ones,
/// and Boost's adaptor does not take numbers that live on the stack.
template <class Scalar>
struct Complex {
  Scalar re = Scalar(0);
  Scalar im = Scalar(0);
};

/// z -> (a z + b) / (c z + d), with the conjugate of z where it reverses orientation.
template <class Scalar>
struct Mobius {
  Complex<Scalar> a{Scalar(1)}, b, c, d{Scalar(1)};
  bool reverses = false; ///< conjugates first

  friend Mobius operator*(const Mobius& m, const Mobius& n) { return composed(m, n); }
};

/// First n, then m.
template <class Scalar>
Mobius<Scalar> composed(const Mobius<Scalar>& m, const Mobius<Scalar>& n);

/// Of an isometry of R^{3,1} that keeps the sheet t > 0; ad - bc = 1, the sign is arbitrary. The relative
/// error is that of m, times the largest entry of m (which ad - bc loses to cancellation).
template <class Scalar>
Mobius<Scalar> mobius_of(const Matrix4<Scalar>& m);

/// The isometry of R^{3,1}. Law: the inverse of `mobius_of` up to rounding.
template <class Scalar>
Matrix4<Scalar> lorentz_of(const Mobius<Scalar>& m);

/// The relative difference of two up to sign, max |M -+ N| / max |N|; infinite if only one reverses.
template <class Scalar>
Scalar relative_difference(const Mobius<Scalar>& m, const Mobius<Scalar>& n);

} // namespace tetrarch::embed
