// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Smooth functions of period 2 pi, given by their values at t = 2 pi j / N.
///
/// Between the samples they are the trigonometric polynomial of least degree: first on a grid eight times as
/// fine, by the fast Fourier transform, from there by polynomials of degree 9. For what N samples resolve to
/// rounding, so does this.

#include <complex>
#include <vector>

namespace tetrarch::slit {

using Complex = std::complex<double>;

/// c[m] is the coefficient of exp(i m t) for m < N/2, and c[N + m] that of negative m. O(N log N).
std::vector<Complex> fourier_coefficients(const std::vector<Complex>& samples);
std::vector<Complex> from_fourier_coefficients(const std::vector<Complex>& coefficients);

/// At the same t. O(N log N).
std::vector<Complex> derivative(const std::vector<Complex>& samples);

/// The share of the highest third of the frequencies, against the greatest coefficient but the mean: near
/// 1e-16 where the samples resolve the function. O(N log N).
double unresolved(const std::vector<Complex>& samples);

class Periodic {
public:
  /// The number of samples is even. O(N log N).
  explicit Periodic(const std::vector<Complex>& samples);

  /// O(1).
  Complex operator()(double t) const;

private:
  std::vector<Complex> fine_;
};

} // namespace tetrarch::slit
