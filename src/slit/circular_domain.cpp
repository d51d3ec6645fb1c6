// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/circular_domain.hpp"

#include "full_turn.hpp"
#include "rounding.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetrarch::slit {
namespace {

void check(const SlitRing& ring) {
  bool good = 0 < ring.inner && ring.inner < 1;
  for (const Arc& arc : ring.slits)
    good = good && ring.inner < arc.radius && arc.radius < 1 && arc.start < arc.end &&
           arc.end - arc.start < full_turn;
  if (!good) throw PreconditionError("slits must lie inside the ring and span less than a full turn");
}

Curves sampled(const SlitRing& ring, const std::vector<int>& samples) {
  Curves curves(samples.size());
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (int j = 0; j < samples[k]; ++j) {
      const double t = full_turn * j / samples[k];
      if (k < 2) {
        curves[k].push_back(std::polar(k == 0 ? 1.0 : ring.inner, t));
        continue;
      }
      const Arc& arc = ring.slits[k - 2];
      const double angle = (arc.start + arc.end) / 2 + (arc.end - arc.start) / 2 * std::cos(t);
      curves[k].push_back(std::polar(arc.radius, angle));
    }
  return curves;
}

double signed_area(const std::vector<Complex>& curve) {
  double sum = 0;
  for (std::size_t j = 0; j < curve.size(); ++j)
    sum += (std::conj(curve[j]) * curve[(j + 1) % curve.size()]).imag();
  return sum / 2;
}

/// The opening of one slit, z + O(1/z):
///
///     w = sqrt((z - start) / (z - end)),   1 at infinity,
///     z' = (end - start) / (2 (w - 1)) + (3 end + start) / 4
///
/// The principal root is cut along the straight segment; a point between it and the slit has the other one.
class Opening {
public:
  explicit Opening(std::vector<Complex> slit)
      : slit_(std::move(slit)), start_(slit_[slit_.size() / 2]), end_(slit_[0]) {}

  /// A closed curve that does not meet the slit.
  std::vector<Complex> operator()(const std::vector<Complex>& curve) const {
    std::vector<Complex> result;
    Complex last = principal(curve[0]) * (is_behind(curve[0]) ? -1.0 : 1.0);
    for (const Complex z : curve) {
      last = continued(principal(z), last);
      result.push_back(opened(last));
    }
    return result;
  }

  /// The slit itself. One bank has the roots of the other with the opposite sign; which has which, the
  /// direction of the curve tells.
  std::vector<Complex> itself() const {
    std::vector<Complex> curve = with_sign(1);
    return signed_area(curve) > 0 ? curve : with_sign(-1);
  }

private:
  Complex principal(Complex z) const { return std::sqrt((z - start_) / (z - end_)); }
  static Complex continued(Complex root, Complex last) {
    return (root * std::conj(last)).real() < 0 ? -root : root;
  }
  Complex opened(Complex w) const {
    return (end_ - start_) / (2.0 * (w - 1.0)) + (3.0 * end_ + start_) / 4.0;
  }

  /// Whether the slit and the segment that closes it go round z: an odd number of their edges crosses the ray
  /// from z to the right.
  bool is_behind(Complex z) const {
    bool odd = false;
    const std::size_t half = slit_.size() / 2;
    for (std::size_t j = 0; j <= half; ++j) {
      const Complex p = slit_[j];
      const Complex q = j < half ? slit_[j + 1] : slit_[0];
      if ((p.imag() > z.imag()) == (q.imag() > z.imag())) continue;
      const double share = (z.imag() - p.imag()) / (q.imag() - p.imag());
      if (p.real() + share * (q.real() - p.real()) > z.real()) odd = !odd;
    }
    return odd;
  }

  std::vector<Complex> with_sign(double sign) const {
    const std::size_t n = slit_.size();
    std::vector<Complex> result(n);
    result[0] = (3.0 * end_ + start_) / 4.0; // w is infinite
    result[n / 2] = opened(0);
    Complex last = principal(slit_[1]) * sign;
    for (std::size_t j = 1; j < n / 2; ++j) {
      last = continued(principal(slit_[j]), last);
      result[j] = opened(last);
      result[n - j] = opened(-last);
    }
    return result;
  }

  std::vector<Complex> slit_;
  Complex start_;
  Complex end_;
};

Complex mean(const std::vector<Complex>& curve) {
  return std::accumulate(curve.begin(), curve.end(), Complex(0)) / static_cast<double>(curve.size());
}

/// The circle through the samples, or the best one.
Circle fitted(const std::vector<Complex>& curve) {
  // Samples are not equally spaced. |z|^2 = 2 Re(conj(c) z) + r^2 - |c|^2 is linear in c and the rest; about
  // the mean the moments are well scaled.
  const Complex middle = mean(curve);
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Complex right = 0;
  double square = 0;
  for (const Complex z : curve) square += std::norm(z - middle) / static_cast<double>(curve.size());
  for (const Complex z : curve) {
    const Complex d = z - middle;
    xx += d.real() * d.real();
    xy += d.real() * d.imag();
    yy += d.imag() * d.imag();
    right += d * (std::norm(d) - square) / 2.0;
  }
  const double determinant = xx * yy - xy * xy;
  const Complex c((right.real() * yy - right.imag() * xy) / determinant,
                  (right.imag() * xx - right.real() * xy) / determinant);
  Circle circle{middle + c, std::sqrt(square + std::norm(c)), 0};
  for (const Complex z : curve)
    circle.circularity =
        std::max(circle.circularity, std::abs(std::abs(z - circle.center) / circle.radius - 1));
  return circle;
}

/// Makes every curve a circle once, the outer one last.
void go_round(Curves& curves) {
  for (std::size_t turn = 0; turn < curves.size(); ++turn) {
    const std::size_t k = (turn + 1) % curves.size();
    const Rounding rounding(curves[k], k == 0 ? Rounding::Of::inside : Rounding::Of::outside);
    for (std::size_t other = 0; other < curves.size(); ++other)
      if (other != k)
        for (Complex& z : curves[other]) z = rounding(z);
    curves[k] = rounding.samples();
  }
}

void measure(CircularDomain& domain) {
  domain.circles.clear();
  domain.circularity = domain.unresolved = 0;
  for (const auto& curve : domain.curves) {
    domain.circles.push_back(fitted(curve));
    domain.circularity = std::max(domain.circularity, domain.circles.back().circularity);
    domain.unresolved = std::max(domain.unresolved, unresolved(curve));
  }
}

template <class Map>
void apply(Curves& curves, const Map& map) {
  for (auto& curve : curves)
    for (Complex& z : curve) z = map(z);
}

/// The outer circle to the unit circle, the inner one to one about 0, the first slit to the positive axis.
void normalise(Curves& curves) {
  const Circle outer = fitted(curves[0]);
  apply(curves, [&](Complex z) { return (z - outer.center) / outer.radius; });
  const Circle inner = fitted(curves[1]);
  const double c = std::abs(inner.center);
  if (c > 0) {
    // On the line through both centres: the point p such that (p, 1/p) are inverse to one another in the
    // inner circle too: p + 1/p = (1 + c^2 - r^2) / c.
    const double sum = (1 + c * c - inner.radius * inner.radius) / c;
    const Complex p = inner.center / c * (2 / (sum + std::sqrt(sum * sum - 4)));
    apply(curves, [&](Complex z) { return (z - p) / (1.0 - std::conj(p) * z); });
  }
  if (curves.size() < 3) return;
  const Complex first = fitted(curves[2]).center;
  apply(curves, [turn = std::conj(first) / std::abs(first)](Complex z) { return z * turn; });
}

/// The domain with its slits opened, by so many samples of each curve.
CircularDomain opened(const SlitRing& ring, const std::vector<int>& samples) {
  CircularDomain domain;
  domain.curves = sampled(ring, samples);
  domain.stages.push_back(domain.curves);
  for (std::size_t k = 2; k < domain.curves.size(); ++k) {
    const Opening opening(domain.curves[k]);
    for (std::size_t other = 0; other < domain.curves.size(); ++other)
      domain.curves[other] = other == k ? opening.itself() : opening(domain.curves[other]);
    domain.stages.push_back(domain.curves);
  }
  measure(domain);
  return domain;
}

void iterate(CircularDomain& domain, const CircularOptions& options) {
  double best = domain.circularity;
  int rounds_without_gain = 0;
  // Beyond the tolerance too, as long as it pays: rounds converge by a factor, until rounding stops them.
  while (domain.rounds < options.most_rounds && rounds_without_gain < 5) {
    const double before = domain.circularity;
    go_round(domain.curves);
    ++domain.rounds;
    measure(domain);
    if (!std::isfinite(domain.circularity)) return;
    if (domain.circularity < options.tolerance && domain.circularity > before / 4) break;
    rounds_without_gain = domain.circularity < best / 2 ? 0 : rounds_without_gain + 1;
    best = std::min(best, domain.circularity);
  }
}

/// How many samples each curve has, and what more of them have gained.
class Sampling {
public:
  Sampling(std::size_t curves, const CircularOptions& options)
      : options_(options), samples_(curves, options.samples), before_(curves, INFINITY) {}

  const std::vector<int>& samples() const { return samples_; }

  /// Doubles those of the curves that are not resolved, as long as it helps. Whether there were any.
  bool refine(const CircularDomain& domain) {
    bool refined = false;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const double now = unresolved(domain.curves[k]);
      if (samples_[k] >= options_.most_samples || now < options_.tolerance / 10 || !(now < before_[k] / 2))
        continue;
      before_[k] = now;
      samples_[k] *= 2;
      refined = true;
    }
    return refined;
  }

private:
  CircularOptions options_;
  std::vector<int> samples_;
  std::vector<double> before_;
};

} // namespace

CircularDomain circular_domain(const SlitRing& ring, const CircularOptions& options) {
  check(ring);
  Sampling sampling(ring.slits.size() + 2, options);
  while (true) {
    CircularDomain domain = opened(ring, sampling.samples());
    if (sampling.refine(domain)) continue; // openings cost next to nothing
    iterate(domain, options);
    if (sampling.refine(domain)) continue;
    domain.found = domain.circularity < options.tolerance && domain.unresolved < options.tolerance;
    normalise(domain.curves);
    measure(domain);
    // What is 0 but for rounding.
    domain.circles[0].center = domain.circles[1].center = 0;
    if (domain.circles.size() > 2) domain.circles[2].center.imag(0);
    return domain;
  }
}

std::vector<Complex> curve_at(const CircularDomain& domain, int curve, const std::vector<double>& t) {
  const Periodic at(domain.curves[static_cast<std::size_t>(curve)]);
  std::vector<Complex> result;
  result.reserve(t.size());
  for (const double parameter : t) result.push_back(at(parameter));
  return result;
}

} // namespace tetrarch::slit
