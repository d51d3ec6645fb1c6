// SPDX-License-Identifier: GPL-2.0-or-later
#include "log_curve.hpp"

#include "full_turn.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::slit {

Complex expm1(Complex z) {
  const double growth = std::expm1(z.real());
  const double half = std::sin(z.imag() / 2);
  // e^x cos y - 1 = (e^x - 1) cos y - 2 sin^2 (y / 2)
  return {growth * std::cos(z.imag()) - 2 * half * half, (growth + 1) * std::sin(z.imag())};
}

Complex log1p(Complex z) {
  constexpr double small = 0.5;
  if (!(std::abs(z) < small)) return std::log(1.0 + z);
  return {std::log1p(2 * z.real() + std::norm(z)) / 2, std::atan2(z.imag(), 1 + z.real())};
}

std::vector<Complex> log1p_along(std::vector<Complex> path) {
  double before = 0;
  for (std::size_t j = 0; j < path.size(); ++j) {
    path[j] = log1p(path[j]);
    if (j > 0) path[j].imag(before + std::remainder(path[j].imag() - before, full_turn));
    before = path[j].imag();
  }
  return path;
}

std::vector<Complex> local(const LogCurve& curve) {
  std::vector<Complex> result;
  result.reserve(curve.size());
  for (const Complex d : curve.offset) result.push_back(expm1(d));
  return result;
}

std::vector<Complex> TaylorSeries::path(Complex center, double gap) {
  std::vector<Complex> result;
  result.reserve(terms);
  for (int j = 0; j < terms; ++j) result.push_back(center + std::polar(gap / 4, full_turn * j / terms));
  return result;
}

TaylorSeries::TaylorSeries(const std::vector<Complex>& values, double gap) : radius_(gap / 4) {
  // Values are first freed of what is common to them, so that small differences keep their digits.
  for (int m = 0; m < terms; ++m) {
    Complex sum = 0;
    for (int j = 0; j < terms; ++j)
      sum += (values[static_cast<std::size_t>(j)] - values[0]) *
             std::polar(1.0, -full_turn * (j * m % terms) / terms);
    coefficient_.push_back(sum / static_cast<double>(terms));
  }
  coefficient_[0] += values[0];
}

Complex TaylorSeries::slope(Complex step) const {
  const Complex x = step / radius_;
  Complex sum = 0;
  for (int m = terms - 1; m > 0; --m) sum = sum * x + coefficient_[static_cast<std::size_t>(m)];
  return sum / radius_;
}

Complex TaylorSeries::difference(Complex step) const {
  return slope(step) * step;
}

double gap(Complex zeta, const LogCurve& curve) {
  double least = INFINITY;
  for (std::size_t j = 0; j < curve.size(); ++j) {
    const Complex d = curve.at(j) - zeta;
    least = std::min(least, std::hypot(d.real(), std::remainder(d.imag(), full_turn)));
  }
  return least;
}

void carry(LogCurve& curve, const Shift& shift, double gap) {
  double size = 0;
  for (const Complex d : curve.offset) size = std::max(size, std::abs(d));
  constexpr double widest = 2; // circles of Taylor's series stay well inside one turn
  gap = std::min(gap, widest);
  constexpr double small = 0.05;
  if (size < small * gap) {
    const TaylorSeries series(shift(TaylorSeries::path(curve.center, gap)), gap);
    curve.center += series.constant();
    for (Complex& d : curve.offset) d += series.difference(d);
    return;
  }
  std::vector<Complex> path;
  path.reserve(curve.size());
  for (std::size_t j = 0; j < curve.size(); ++j) path.push_back(curve.at(j));
  const std::vector<Complex> added = shift(path);
  Complex mean = 0;
  for (const Complex d : added) mean += d / static_cast<double>(added.size());
  curve.center += mean;
  for (std::size_t j = 0; j < curve.size(); ++j) curve.offset[j] += added[j] - mean;
}

ShiftKeepingZero::ShiftKeepingZero(Shift h, double reach, Complex center)
    : h_(std::move(h)), reach_(reach), center_(center),
      about_zero_(h_(TaylorSeries::path(-1.0, reach)), reach) {}

std::vector<Complex> ShiftKeepingZero::operator()(const std::vector<Complex>& path) const {
  constexpr double small = 0.05;
  std::vector<Complex> w;
  w.reserve(path.size());
  for (const Complex zeta : path) w.push_back(expm1(zeta - center_));
  std::vector<Complex> result = h_(w);
  for (std::size_t j = 0; j < path.size(); ++j) {
    const Complex z = std::exp(path[j] - center_);
    result[j] =
        std::abs(z) < small * reach_ ? about_zero_.slope(z) : (result[j] - about_zero_.constant()) / z;
  }
  return log1p_along(std::move(result));
}

} // namespace tetrarch::slit
