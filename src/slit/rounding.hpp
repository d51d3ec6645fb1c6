// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The conformal maps that make one closed curve a circle.
///
///       .--.             .-.      g(z) = (z - c) exp F(z), and F is analytic outside (inside) the curve with
///      (  c )   --g->   ( o )     real part const - log|z - c| on it. F is Cauchy's integral of a real
///       `---'            `-'      density, which solves a Fredholm equation of the second kind: well
///                                 conditioned, and by the trapezoidal rule as exact as the samples are.
///
/// A curve runs counterclockwise, by an even number N of samples at equal steps of a parameter in which it is
/// smooth. Source: Henrici, "Applied and Computational Complex Analysis" III (1986), chapter 16, for the
/// equation.

#include "periodic.hpp"

#include <vector>

namespace tetrarch::slit {

/// From the outside of a curve to that of a circle: z + O(1/z).
class OuterRounding {
public:
  /// O(N^2), unless the iteration fails to converge: then O(N^3).
  explicit OuterRounding(std::vector<Complex> curve);

  /// Where the samples of the curve come to lie: on a circle, as far as they resolve the curve.
  const std::vector<Complex>& samples() const { return image_; }
  /// The image less the point itself, of a point outside. O(N).
  Complex added(Complex z) const;

private:
  std::vector<Complex> curve_;
  std::vector<Complex> image_;
  std::vector<Complex> shift_;  ///< of the samples
  std::vector<Complex> weight_; ///< of Cauchy's formula
};

/// From the inside of a curve around 0 to the unit disk, 0 to 0: z exp F(z), F being given.
class InnerRounding {
public:
  /// As above.
  explicit InnerRounding(std::vector<Complex> curve);

  /// F at the samples of the curve.
  const std::vector<Complex>& logs() const { return log_; }
  /// F at a point inside. O(N).
  Complex operator()(Complex z) const;

private:
  std::vector<Complex> curve_;
  std::vector<Complex> log_;
  std::vector<Complex> tangent_;
};

} // namespace tetrarch::slit
