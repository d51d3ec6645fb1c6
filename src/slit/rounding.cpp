// SPDX-License-Identifier: GPL-2.0-or-later
#include "rounding.hpp"

#include "full_turn.hpp"
#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetrarch::slit {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Of numbers whose squares neither overflow nor underflow.
Complex quotient(Complex a, Complex b) {
  const double inverse = 1 / std::norm(b);
  return {(a.real() * b.real() + a.imag() * b.imag()) * inverse,
          (a.imag() * b.real() - a.real() * b.imag()) * inverse};
}

/// Cauchy's integral over the curve by the trapezoidal rule: C(i, j) = z'(j) / (i N (z(j) - z(i))).
Eigen::MatrixXcd cauchy(const std::vector<Complex>& curve, const std::vector<Complex>& tangent) {
  const auto n = static_cast<Eigen::Index>(curve.size());
  Eigen::MatrixXcd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex factor = tangent[static_cast<std::size_t>(j)] / Complex(0, static_cast<double>(n));
    for (Eigen::Index i = 0; i < n; ++i)
      matrix(i, j) =
          i == j ? 0.0
                 : quotient(factor, curve[static_cast<std::size_t>(j)] - curve[static_cast<std::size_t>(i)]);
  }
  return matrix;
}

/// Equations of the second kind, whose eigenvalues gather at one point: a few steps do.
Vector solved(const Matrix& matrix, const Vector& right) {
  Eigen::BiCGSTAB<Matrix, Eigen::IdentityPreconditioner> solver(matrix);
  solver.setTolerance(1e-15);
  solver.setMaxIterations(100);
  const Vector x = solver.solve(right);
  constexpr double good = 1e-12;
  return solver.error() < good ? x : matrix.partialPivLu().solve(right);
}

/// F on the curve, and what is left of it at infinity.
struct LogOfSlope {
  std::vector<Complex> values;
  Complex residue = 0;
};

/// On the curve F(z) = sum C(z, s) (m(s) - m(z)) + [inside] m(z), with the derivative of m for s = z, which
/// is imaginary. The real part is known but for the constant outside, where m = 1 is lost: its mean takes
/// that place.
LogOfSlope log_of_slope(const std::vector<Complex>& curve, const std::vector<Complex>& tangent, Complex c,
                        bool is_inside) {
  const auto size = static_cast<Eigen::Index>(curve.size());
  const double count = static_cast<double>(curve.size());
  const Eigen::MatrixXcd kernel = cauchy(curve, tangent);
  Vector right(size);
  for (Eigen::Index i = 0; i < size; ++i)
    right[i] = -std::log(std::abs(curve[static_cast<std::size_t>(i)] - c));
  Matrix matrix = kernel.real();
  for (Eigen::Index i = 0; i < size; ++i) matrix(i, i) = (is_inside ? 1.0 : 0.0) - matrix.row(i).sum();
  if (!is_inside) matrix.array() += 1.0 / count;
  const Vector density = solved(matrix, right);

  const std::vector<Complex> slope =
      derivative(std::vector<Complex>(density.data(), density.data() + density.size()));
  const Eigen::VectorXcd integral = kernel * density - kernel.rowwise().sum().cwiseProduct(density);
  LogOfSlope result;
  for (std::size_t j = 0; j < curve.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    result.residue -= density[i] * tangent[j] / Complex(0, count);
    result.values.push_back(integral[i] + slope[j].real() / Complex(0, count) +
                            (is_inside ? density[i] : 0.0));
  }
  return result;
}

/// The mean of the values with weights weight / (curve - z). Nearly all of the time of circular domains goes
/// by here, and most of that went into the infinities that std::complex minds in its divisions.
Complex barycentric(const std::vector<Complex>& curve, const std::vector<Complex>& weight,
                    const std::vector<Complex>& value, Complex z, double scale) {
  const double unit = 1 / scale;
  double numerator_x = 0;
  double numerator_y = 0;
  double denominator_x = 0;
  double denominator_y = 0;
  for (std::size_t j = 0; j < curve.size(); ++j) {
    const double x = (curve[j].real() - z.real()) * unit;
    const double y = (curve[j].imag() - z.imag()) * unit;
    const double inverse = 1 / (x * x + y * y);
    const double share_x = (weight[j].real() * x + weight[j].imag() * y) * inverse;
    const double share_y = (weight[j].imag() * x - weight[j].real() * y) * inverse;
    numerator_x += share_x * value[j].real() - share_y * value[j].imag();
    numerator_y += share_x * value[j].imag() + share_y * value[j].real();
    denominator_x += share_x;
    denominator_y += share_y;
  }
  return Complex(numerator_x, numerator_y) / Complex(denominator_x, denominator_y);
}

} // namespace

OuterRounding::OuterRounding(std::vector<Complex> curve)
    : curve_(std::move(curve)), weight_(derivative(curve_)) {
  const Complex c =
      std::accumulate(curve_.begin(), curve_.end(), Complex(0)) / static_cast<double>(curve_.size());
  const LogOfSlope f = log_of_slope(curve_, weight_, c, false);
  for (std::size_t j = 0; j < curve_.size(); ++j) {
    // (z - c) exp F = z - c + residue + O(1/z).
    image_.push_back((curve_[j] - c) * std::exp(f.values[j]) + c - f.residue);
    weight_[j] /= curve_[j] - c;
    shift_.push_back(image_[j] - curve_[j]);
  }
}

/// Barycentric: Cauchy's formula over the same formula for 1, so that points near the curve lose nothing.
/// What is analytic outside is taken relative to 1 / (z - c), which vanishes at infinity as the formula asks
/// there. Differences are scaled lest they overflow or underflow far outside.
Complex OuterRounding::added(Complex z) const {
  return barycentric(curve_, weight_, shift_, z, std::max(1.0, std::abs(z)));
}

InnerRounding::InnerRounding(std::vector<Complex> curve)
    : curve_(std::move(curve)), tangent_(derivative(curve_)) {
  log_ = log_of_slope(curve_, tangent_, 0, true).values;
}

Complex InnerRounding::operator()(Complex z) const {
  return barycentric(curve_, tangent_, log_, z, 1);
}

} // namespace tetrarch::slit
