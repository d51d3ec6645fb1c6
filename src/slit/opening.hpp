// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The opening of one slit: w -> w + h(w), h = O(1/w), after which its two banks are the two halves of one
/// smooth closed curve, a circle if the slit is the arc of one.
///
///     h = -(end - start)^2 / 8 / (u + S),   u = w - (start + end) / 2,   S = sqrt((w - start) (w - end)),
///
/// S near u at infinity and cut along the slit, which need not be straight. Nothing cancels here, however
/// short the slit is or however far w is from it.

#include "log_curve.hpp"

namespace tetrarch::slit {

class Opening {
public:
  /// Samples of the slit in the plane of w, as those of a curve of `circular_domain`.
  explicit Opening(std::vector<Complex> slit);

  /// h along a path that does not meet the slit. O(N) and the length of the path.
  std::vector<Complex> operator()(const std::vector<Complex>& path) const;
  /// The image of the slit itself, counterclockwise.
  std::vector<Complex> itself() const;
  /// The distance from w = -1 to the samples.
  double reach() const { return reach_; }

private:
  Complex principal(Complex w) const { return std::sqrt((w - start_) / (w - end_)); }
  Complex added(Complex w, Complex root) const;
  bool is_behind(Complex w) const;
  std::vector<Complex> with_sign(double sign) const;

  std::vector<Complex> slit_;
  Complex start_;
  Complex end_;
  double reach_ = 0;
};

/// The least distance from w = -1, where z is 0, to samples in that plane. O(N).
double distance_from_zero(const std::vector<Complex>& local);

} // namespace tetrarch::slit
