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

/// Cauchy's integral over the curve by the trapezoidal rule: C(i, j) = z'(j) / (i N (z(j) - z(i))), 0 for
/// i = j. The matrix has 16 N^2 bytes, so its entries are made where they are wanted, twice; that costs less
/// than to fetch them. Differences must have squares that neither overflow nor underflow.
class Cauchy {
public:
  Cauchy(const std::vector<Complex>& curve, const std::vector<Complex>& tangent)
      : x_(static_cast<Eigen::Index>(curve.size())), y_(x_.size()), factor_x_(x_.size()),
        factor_y_(x_.size()) {
    for (Eigen::Index j = 0; j < size(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const Complex factor = tangent[k] / Complex(0, static_cast<double>(curve.size()));
      x_[j] = curve[k].real();
      y_[j] = curve[k].imag();
      factor_x_[j] = factor.real();
      factor_y_[j] = factor.imag();
    }
  }

  Eigen::Index size() const { return x_.size(); }

  /// Re C, and the sums of its rows.
  std::pair<Matrix, Vector> real_part() const {
    Matrix matrix(size(), size());
    Vector sums = Vector::Zero(size());
    for (Eigen::Index j = 0; j < size(); ++j) {
      double* const column = matrix.col(j).data();
      for_others(j, [&](Eigen::Index i, double x, double y, double inverse) {
        column[i] = (factor_x_[j] * x + factor_y_[j] * y) * inverse;
        sums[i] += column[i];
      });
      column[j] = 0;
    }
    return {std::move(matrix), std::move(sums)};
  }

  /// Of each i the sum over j of C(i, j) (m(j) - m(i)).
  std::pair<Vector, Vector> of_differences(const Vector& m) const {
    Vector real = Vector::Zero(size());
    Vector imaginary = Vector::Zero(size());
    for (Eigen::Index j = 0; j < size(); ++j)
      for_others(j, [&](Eigen::Index i, double x, double y, double inverse) {
        const double share = (m[j] - m[i]) * inverse;
        real[i] += (factor_x_[j] * x + factor_y_[j] * y) * share;
        imaginary[i] += (factor_y_[j] * x - factor_x_[j] * y) * share;
      });
    return {std::move(real), std::move(imaginary)};
  }

private:
  /// Calls take(i, x, y, 1 / (x^2 + y^2)) with z(j) - z(i) = x + iy for all i but j.
  template <class Take>
  void for_others(Eigen::Index j, Take take) const {
    for (const auto& [from, to] : {std::pair<Eigen::Index, Eigen::Index>(0, j), {j + 1, size()}})
      for (Eigen::Index i = from; i < to; ++i) {
        const double x = x_[j] - x_[i];
        const double y = y_[j] - y_[i];
        take(i, x, y, 1 / (x * x + y * y));
      }
  }

  Vector x_; ///< of z
  Vector y_;
  Vector factor_x_; ///< of z'(j) / (i N)
  Vector factor_y_;
};

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
  const double count = static_cast<double>(curve.size());
  const Cauchy kernel(curve, tangent);
  Vector right(kernel.size());
  for (Eigen::Index i = 0; i < right.size(); ++i)
    right[i] = -std::log(std::abs(curve[static_cast<std::size_t>(i)] - c));
  auto [matrix, sums] = kernel.real_part();
  matrix.diagonal() = (is_inside ? 1.0 : 0.0) - sums.array();
  if (!is_inside) matrix.array() += 1.0 / count;
  const Vector density = solved(matrix, right);

  const std::vector<Complex> slope =
      derivative(std::vector<Complex>(density.data(), density.data() + density.size()));
  const auto [real, imaginary] = kernel.of_differences(density);
  LogOfSlope result;
  for (std::size_t j = 0; j < curve.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    result.residue -= density[i] * tangent[j] / Complex(0, count);
    result.values.push_back(Complex(real[i], imaginary[i]) + slope[j].real() / Complex(0, count) +
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
