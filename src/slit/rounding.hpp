// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The conformal map that makes one closed curve a circle.
///
///       .--.             .-.      g(z) = (z - c) exp F(z), and F is analytic outside (inside) the curve with
///      (  c )   --g->   ( o )     real part const - log|z - c| on it. F is Cauchy's integral of a real
///       `---'            `-'      density, which solves a Fredholm equation of the second kind: well
///                                 conditioned, and by the trapezoidal rule as exact as the samples are.
///
/// Source: Henrici, "Applied and Computational Complex Analysis" III (1986), chapter 16, for the equation.

#include "periodic.hpp"

#include <vector>

namespace tetrarch::slit {

/// From the outside (inside) of a curve to that of a circle. Outside it is z + O(1/z); inside the circle is
/// the unit circle, and the mean of the samples goes to 0 by a positive derivative.
class Rounding {
public:
  enum class Of { outside, inside };

  /// The curve runs counterclockwise, by an even number N of samples at equal steps of a parameter in which
  /// it is smooth. O(N^2), unless the iteration fails to converge: then O(N^3).
  Rounding(std::vector<Complex> curve, Of of);

  /// Where the samples of the curve come to lie: on a circle, as far as they resolve the curve.
  const std::vector<Complex>& samples() const { return image_; }
  /// The image of a point on the right side of the curve. O(N).
  Complex operator()(Complex z) const;

private:
  Of of_;
  std::vector<Complex> curve_;
  std::vector<Complex> image_;
  std::vector<Complex> weight_; ///< of Cauchy's formula
};

} // namespace tetrarch::slit
