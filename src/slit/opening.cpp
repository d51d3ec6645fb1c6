// SPDX-License-Identifier: GPL-2.0-or-later
#include "opening.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::slit {
namespace {

double signed_area(const std::vector<Complex>& curve) {
  double sum = 0;
  for (std::size_t j = 0; j < curve.size(); ++j)
    sum += (std::conj(curve[j] - curve[0]) * (curve[(j + 1) % curve.size()] - curve[0])).imag();
  return sum / 2;
}

Complex continued(Complex root, Complex last) {
  return (root * std::conj(last)).real() < 0 ? -root : root;
}

} // namespace

double distance_from_zero(const std::vector<Complex>& local) {
  double least = INFINITY;
  for (const Complex w : local) least = std::min(least, std::abs(w + 1.0));
  return least;
}

Opening::Opening(std::vector<Complex> slit)
    : slit_(std::move(slit)), start_(slit_[slit_.size() / 2]), end_(slit_[0]),
      reach_(distance_from_zero(slit_)) {}

/// `root`: of (w - start) / (w - end), cut along the slit.
Complex Opening::added(Complex w, Complex root) const {
  const Complex length = end_ - start_;
  return -length * length / 8.0 / (w - (start_ + end_) / 2.0 + (w - end_) * root);
}

std::vector<Complex> Opening::operator()(const std::vector<Complex>& path) const {
  std::vector<Complex> result;
  result.reserve(path.size());
  Complex last = principal(path[0]) * (is_behind(path[0]) ? -1.0 : 1.0);
  for (const Complex w : path) {
    last = continued(principal(w), last);
    result.push_back(added(w, last));
  }
  return result;
}

/// One bank has the roots of the other with the opposite sign; which has which, the direction of the curve
/// tells.
std::vector<Complex> Opening::itself() const {
  std::vector<Complex> curve = with_sign(1);
  return signed_area(curve) > 0 ? curve : with_sign(-1);
}

/// Whether the slit and the segment that closes it go round w: an odd number of their edges crosses the ray
/// from w to the right. The principal root is cut along the straight segment; a point between it and the slit
/// has the other one.
bool Opening::is_behind(Complex w) const {
  bool odd = false;
  const std::size_t half = slit_.size() / 2;
  for (std::size_t j = 0; j <= half; ++j) {
    const Complex p = slit_[j];
    const Complex q = j < half ? slit_[j + 1] : slit_[0];
    if ((p.imag() > w.imag()) == (q.imag() > w.imag())) continue;
    const double share = (w.imag() - p.imag()) / (q.imag() - p.imag());
    if (p.real() + share * (q.real() - p.real()) > w.real()) odd = !odd;
  }
  return odd;
}

std::vector<Complex> Opening::with_sign(double sign) const {
  const std::size_t n = slit_.size();
  std::vector<Complex> result(n);
  // At the ends S is 0, and h is half the way to the middle.
  result[0] = (3.0 * end_ + start_) / 4.0;
  result[n / 2] = (3.0 * start_ + end_) / 4.0;
  Complex last = principal(slit_[1]) * sign;
  for (std::size_t j = 1; j < n / 2; ++j) {
    last = continued(principal(slit_[j]), last);
    result[j] = slit_[j] + added(slit_[j], last);
    result[n - j] = slit_[j] + added(slit_[j], -last);
  }
  return result;
}

} // namespace tetrarch::slit
