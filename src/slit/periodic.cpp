// SPDX-License-Identifier: GPL-2.0-or-later
#include "periodic.hpp"

#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"
#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetrarch::slit {
namespace {

constexpr std::size_t refinement = 8;
constexpr int local_points = 10; ///< of a local polynomial

/// 1 / product of (k - j) over the others: the barycentric weights of points 0, 1, ..., 9.
std::array<double, local_points> barycentric_weights() {
  std::array<double, local_points> weight{};
  for (int k = 0; k < local_points; ++k) {
    double product = 1;
    for (int j = 0; j < local_points; ++j)
      if (j != k) product *= k - j;
    weight[static_cast<std::size_t>(k)] = 1 / product;
  }
  return weight;
}

} // namespace

std::vector<Complex> fourier_coefficients(const std::vector<Complex>& samples) {
  std::vector<Complex> result;
  Eigen::FFT<double> fft;
  fft.fwd(result, samples);
  for (Complex& c : result) c /= static_cast<double>(samples.size());
  return result;
}

std::vector<Complex> from_fourier_coefficients(const std::vector<Complex>& coefficients) {
  std::vector<Complex> result;
  Eigen::FFT<double> fft;
  fft.inv(result, coefficients);
  for (Complex& c : result) c *= static_cast<double>(coefficients.size());
  return result;
}

std::vector<Complex> derivative(const std::vector<Complex>& samples) {
  std::vector<Complex> c = fourier_coefficients(samples);
  const auto n = static_cast<int>(c.size());
  for (int m = 0; m < n; ++m) {
    const int frequency = m == n / 2 ? 0 : m < n / 2 ? m : m - n;
    c[static_cast<std::size_t>(m)] *= Complex(0, frequency);
  }
  return from_fourier_coefficients(c);
}

double unresolved(const std::vector<Complex>& samples) {
  const std::vector<Complex> c = fourier_coefficients(samples);
  const std::size_t n = c.size();
  double all = 0;
  double high = 0;
  for (std::size_t m = 1; m < n; ++m) {
    const std::size_t frequency = std::min(m, n - m);
    all = numeric::maximum(all, std::abs(c[m]));
    if (3 * frequency > n) high = numeric::maximum(high, std::abs(c[m]));
  }
  return all == 0 ? 0 : high / all;
}

Periodic::Periodic(const std::vector<Complex>& samples) {
  const std::vector<Complex> c = fourier_coefficients(samples);
  const std::size_t n = c.size();
  std::vector<Complex> padded(refinement * n, 0.0);
  for (std::size_t m = 0; m < n / 2; ++m) padded[m] = c[m];
  for (std::size_t m = n / 2 + 1; m < n; ++m) padded[padded.size() - n + m] = c[m];
  // The highest frequency has no sign: half of it goes to either.
  padded[n / 2] += c[n / 2] / 2.0;
  padded[padded.size() - n / 2] += c[n / 2] / 2.0;
  fine_ = from_fourier_coefficients(padded);
}

Complex Periodic::operator()(double t) const {
  static const std::array<double, local_points> weight = barycentric_weights();
  const auto n = static_cast<long long>(fine_.size());
  const double position = t / full_turn * static_cast<double>(n);
  const auto first = static_cast<long long>(std::floor(position)) - (local_points / 2 - 1);
  Complex numerator = 0;
  double denominator = 0;
  for (int k = 0; k < local_points; ++k) {
    const long long index = first + k;
    const Complex& value = fine_[static_cast<std::size_t>(((index % n) + n) % n)];
    const double distance = position - static_cast<double>(index);
    if (distance == 0) return value;
    const double share = weight[static_cast<std::size_t>(k)] / distance;
    numerator += share * value;
    denominator += share;
  }
  return numerator / denominator;
}

} // namespace tetrarch::slit
