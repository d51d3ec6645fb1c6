// SPDX-License-Identifier: GPL-2.0-or-later
#include "flat_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetrarch::product {
namespace {

using Complex = std::complex<double>;

/// Weights below this are rounding: the point is on the side.
constexpr double on_side = 1e-10;

double cross(Complex a, Complex b) {
  return (std::conj(a) * b).imag();
}

double twice_area(const FlatCorners& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

std::array<double, 3> weights(const FlatCorners& p, Complex z) {
  const double whole = twice_area(p);
  return {cross(p[1] - z, p[2] - z) / whole, cross(p[2] - z, p[0] - z) / whole,
          cross(p[0] - z, p[1] - z) / whole};
}

void tidy(std::array<double, 3>& weight) {
  double sum = 0;
  for (double& x : weight) {
    if (x < on_side) x = 0;
    sum += x;
  }
  for (double& x : weight) x /= sum;
}

struct Box {
  Complex low;
  Complex high;
};

Box box_of(const FlatCorners& p) {
  const auto [left, right] = std::minmax({p[0].real(), p[1].real(), p[2].real()});
  const auto [below, above] = std::minmax({p[0].imag(), p[1].imag(), p[2].imag()});
  return {{left, below}, {right, above}};
}

} // namespace

double nearest_part(Complex from, Complex to, Complex z) {
  const Complex side = to - from;
  const double square = std::norm(side);
  return square > 0 ? std::clamp((std::conj(side) * (z - from)).real() / square, 0.0, 1.0) : 0.0;
}

FlatLocator::FlatLocator(std::vector<FlatCorners> triangles) : triangles_(std::move(triangles)) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box all{{infinity, infinity}, {-infinity, -infinity}};
  for (const FlatCorners& p : triangles_) {
    const double twice = twice_area(p);
    upright_.push_back(static_cast<char>(twice > 0));
    if (!(twice > 0)) continue;
    area_ += twice / 2;
    const Box box = box_of(p);
    all.low = {std::min(all.low.real(), box.low.real()), std::min(all.low.imag(), box.low.imag())};
    all.high = {std::max(all.high.real(), box.high.real()), std::max(all.high.imag(), box.high.imag())};
  }
  if (!(area_ > 0)) return;
  const Complex extent = all.high - all.low;
  width_ = std::sqrt(extent.real() * extent.imag() / static_cast<double>(triangles_.size()));
  low_ = all.low;
  columns_ = static_cast<int>(extent.real() / width_) + 1;
  rows_ = static_cast<int>(extent.imag() / width_) + 1;
  bucket_.resize(static_cast<std::size_t>(columns_) * rows_);
  const Complex margin(1e-6 * width_, 1e-6 * width_);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (!upright_[t]) continue;
    const Box box = box_of(triangles_[t]);
    const Cell first = cell_of(box.low - margin);
    const Cell last = cell_of(box.high + margin);
    for (int row = first.row; row <= last.row; ++row)
      for (int column = first.column; column <= last.column; ++column)
        bucket_[row * columns_ + column].push_back(static_cast<int>(t));
  }
}

FlatLocator::Cell FlatLocator::cell_of(Complex z) const {
  const Complex at = (z - low_) / width_;
  return {static_cast<int>(std::clamp(at.real(), 0.0, columns_ - 1.0)),
          static_cast<int>(std::clamp(at.imag(), 0.0, rows_ - 1.0))};
}

FlatPlace FlatLocator::inside(Complex z) const {
  FlatPlace best;
  if (bucket_.empty()) return best;
  double depth = -on_side;
  const Cell cell = cell_of(z);
  for (const int t : bucket_[cell.row * columns_ + cell.column]) {
    const std::array<double, 3> weight = weights(triangles_[t], z);
    const double least = *std::min_element(weight.begin(), weight.end());
    if (!(least > depth)) continue;
    depth = least;
    best = {t, weight, 0};
  }
  if (best.triangle >= 0) tidy(best.weight);
  return best;
}

FlatPlace FlatLocator::nearest(Complex z) const {
  FlatPlace best = inside(z);
  if (best.triangle >= 0) return best;
  best.outside = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t c = 0; c < 3 && upright_[t]; ++c) {
      const Complex from = triangles_[t][c];
      const std::size_t next = (c + 1) % 3;
      const Complex side = triangles_[t][next] - from;
      const double part = nearest_part(from, triangles_[t][next], z);
      const double distance = std::abs(from + part * side - z);
      if (!(distance < best.outside)) continue;
      best = {static_cast<int>(t), {}, distance};
      best.weight[c] = 1 - part;
      best.weight[next] = part;
    }
  if (best.triangle >= 0) tidy(best.weight);
  return best;
}

} // namespace tetrarch::product
