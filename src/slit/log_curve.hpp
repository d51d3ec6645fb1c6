// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Closed curves in the plane of zeta = log z, and maps that carry them.
///
///        Re zeta = 0        outer circle        A ring of modulus M is a strip of width M here, however
///      ----------------                         small its inner radius e^-M. A curve is a center and offsets
///         ( o )   <- offsets about a center     from it: a slit of width 1e-10 keeps all its digits, which
///      ----------------                         its places z themselves would not.
///        Re zeta = -M       inner circle
///
/// Maps are given by what they add to zeta. Curves that are small against their distance from where a map is
/// singular move by its Taylor series, so that their offsets lose nothing either.

#include "tetrarch/slit/circular_domain.hpp"

#include <complex>
#include <functional>
#include <vector>

namespace tetrarch::slit {

using Complex = std::complex<double>;

/// exp(z) - 1 and log(1 + z), accurate against |z| where z is small.
Complex expm1(Complex z);
Complex log1p(Complex z);

/// log(1 + x) along a path on which 1 + x does not jump, continued from the principal value at its start.
std::vector<Complex> log1p_along(std::vector<Complex> path);

/// z / exp(center) - 1 of each sample.
std::vector<Complex> local(const LogCurve& curve);

/// What a map adds to zeta at each point of a path, which does not jump.
using Shift = std::function<std::vector<Complex>(const std::vector<Complex>& path)>;

/// Taylor's coefficients about a point of a function that is analytic at less than `gap` from it, from its
/// values on a circle of a quarter of that radius.
class TaylorSeries {
public:
  static constexpr int terms = 32;
  /// The path on which values are wanted.
  static std::vector<Complex> path(Complex center, double gap);
  TaylorSeries(const std::vector<Complex>& values, double gap);

  Complex constant() const { return coefficient_[0]; }
  /// f(center + step) - f(center), for |step| at most a fifth of the radius of the circle.
  Complex difference(Complex step) const;
  /// That divided by the step; the derivative where the step is 0.
  Complex slope(Complex step) const;

private:
  double radius_ = 1;
  std::vector<Complex> coefficient_; ///< times powers of the radius
};

/// The least distance from a point to the samples of a curve, modulo full turns. O(N).
double gap(Complex zeta, const LogCurve& curve);

/// Moves a curve by a map that is analytic at less than `gap` from its center. O(N) and the shift.
void carry(LogCurve& curve, const Shift& shift, double gap);

/// What w -> w + h(w) adds to zeta, w = expm1(zeta - center), once followed by the translation that keeps
/// z = 0 in its place: log1p((h(w) - h(-1)) / (w + 1)). Near z = 0 it takes its series.
class ShiftKeepingZero {
public:
  /// `h` is of order 1/w at infinity and takes paths; `reach` is the distance of -1 from its singularities.
  ShiftKeepingZero(Shift h, double reach, Complex center);

  std::vector<Complex> operator()(const std::vector<Complex>& path) const;
  /// h(-1).
  Complex translation() const { return about_zero_.constant(); }

private:
  Shift h_;
  double reach_;
  Complex center_;
  TaylorSeries about_zero_;
};

} // namespace tetrarch::slit
