// SPDX-License-Identifier: GPL-2.0-or-later
#include "flat_energy.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::unfold {
namespace {

using Complex = std::complex<double>;
using numeric::cross;

struct Parts {
  Complex a;
  Complex b;
  double first = 0;  ///< singular values
  double second = 0; ///< the lesser, negative for what is turned over
};

Parts parts(const FlatDerivative& d, const FlatEdges& now) {
  Parts result;
  result.a = d.conformal[1] * now[0] + d.conformal[2] * now[1];
  result.b = d.anticonformal[1] * now[0] + d.anticonformal[2] * now[1];
  result.first = std::abs(result.a) + std::abs(result.b);
  // |a| - |b| has no digits where the triangle is thin.
  const Complex wanted_cross = d.conformal[1] * std::conj(d.conformal[2]);
  const double determinant = cross(now[0], now[1]) * 4 * std::abs(wanted_cross.imag());
  result.second = determinant / result.first;
  return result;
}

/// Curvatures along the four changes: of each singular value, of twists and flips by their squared size.
struct Curvatures {
  double first = 0;
  double second = 0;
  double twist = 0;
  double flip = 0;
};

double slope(double s) {
  return (s - 1 / (s * s * s)) / 2;
}

Curvatures newton(double first, double second) {
  const double cube = std::pow(first * second, 3);
  const auto bend = [](double s) { return (1 + 3 / (s * s * s * s)) / 2; };
  return {bend(first), bend(second),
          std::max(0.0, 1 - (first * first - first * second + second * second) / cube) / 2,
          (1 + (first * first + first * second + second * second) / cube) / 2};
}

/// Of |W (J - R)|^2, W such that the slopes are those of the energy: those of s along s - 1.
double reweighted(double s) {
  return (s + 1) * (s * s + 1) / (2 * s * s * s);
}

} // namespace

FlatDerivative::FlatDerivative(const FlatEdges& wanted) {
  const Complex twice_area(0, -2 * cross(wanted[0], wanted[1]));
  conformal[1] = std::conj(wanted[1]) / twice_area;
  conformal[2] = -std::conj(wanted[0]) / twice_area;
  conformal[0] = -conformal[1] - conformal[2];
  anticonformal[1] = -wanted[1] / twice_area;
  anticonformal[2] = wanted[0] / twice_area;
  anticonformal[0] = -anticonformal[1] - anticonformal[2];
}

double flat_energy(const FlatDerivative& derivative, const FlatEdges& now) {
  const Parts p = parts(derivative, now);
  if (!(p.second > 0)) return INFINITY;
  return (p.first * p.first + p.second * p.second + 1 / (p.first * p.first) + 1 / (p.second * p.second)) / 4;
}

FlatQuadratic flat_quadratic(const FlatDerivative& derivative, const FlatEdges& now, Model model) {
  const Parts p = parts(derivative, now);
  const auto unit = [](Complex z) { return std::abs(z) > 0 ? std::conj(z) / std::abs(z) : Complex(1); };
  const Complex frame_a = unit(p.a);
  const Complex frame_b = unit(p.b);
  // Rows: Re(da) + Re(db), Re(da) - Re(db), Im(da), Im(db); columns: coordinates of the corners.
  std::array<std::array<double, 6>, 4> change{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Complex a = frame_a * derivative.conformal[k];
    const Complex b = frame_b * derivative.anticonformal[k];
    for (const std::size_t axis : {0, 1}) {
      const Complex da = axis == 0 ? a : Complex(0, 1) * a;
      const Complex db = axis == 0 ? b : Complex(0, 1) * b;
      const std::size_t column = 2 * k + axis;
      change[0][column] = da.real() + db.real();
      change[1][column] = da.real() - db.real();
      change[2][column] = da.imag();
      change[3][column] = db.imag();
    }
  }
  // The form in these four is diagonal but for one product of the last two.
  std::array<double, 4> weight{};
  double product = 0;
  if (model == Model::newton) {
    const Curvatures c = newton(p.first, p.second);
    weight = {c.first, c.second, 2 * c.twist, 2 * c.flip};
  } else {
    const double one = reweighted(p.first);
    const double two = reweighted(p.second);
    weight = {one, two, one + two, one + two};
    product = two - one;
  }
  FlatQuadratic result;
  for (std::size_t i = 0; i < 6; ++i) {
    result.gradient[i] = slope(p.first) * change[0][i] + slope(p.second) * change[1][i];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = product * (change[2][i] * change[3][j] + change[3][i] * change[2][j]);
      for (std::size_t r = 0; r < 4; ++r) sum += weight[r] * change[r][i] * change[r][j];
      result.hessian[i][j] = result.hessian[j][i] = sum;
    }
  }
  return result;
}

double first_flat(const FlatEdges& now, const FlatEdges& step) {
  const double c = cross(now[0], now[1]);
  const double b = cross(now[0], step[1]) + cross(step[0], now[1]);
  const double a = cross(step[0], step[1]);
  // c > 0; the roots of a t^2 + b t + c without cancellation.
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return INFINITY;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  double least = INFINITY;
  for (const double t : {q / a, c / q})
    if (t > 0) least = std::min(least, t);
  return least;
}

} // namespace tetrarch::unfold
