// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/circular_domain.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"
#include "log_curve.hpp"
#include "opening.hpp"
#include "periodic.hpp"
#include "rounding.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetrarch::slit {
namespace {

void check_ring(const SlitRing& ring) {
  bool good = 0 < ring.inner && ring.inner < 1;
  for (const Arc& arc : ring.slits)
    good = good && ring.inner < arc.radius && arc.radius < 1 && arc.start < arc.end &&
           arc.end - arc.start < full_turn;
  if (!good) throw PreconditionError("slits must lie inside the ring and span less than a full turn");
}

/// Angles of the outer and the inner curve run from 0 to a full turn.
LogCurves sampled(const SlitRing& ring, const std::vector<int>& samples) {
  LogCurves curves(samples.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Arc* const arc = k < 2 ? nullptr : &ring.slits[k - 2];
    const double radius = k == 0 ? 1.0 : k == 1 ? ring.inner : arc->radius;
    curves[k].center = Complex(std::log(radius), arc != nullptr ? (arc->start + arc->end) / 2 : 0.0);
    for (int j = 0; j < samples[k]; ++j) {
      const double t = full_turn * j / samples[k];
      curves[k].offset.emplace_back(0, arc != nullptr ? (arc->end - arc->start) / 2 * std::cos(t) : t);
    }
  }
  return curves;
}

Complex mean(const std::vector<Complex>& curve) {
  return std::accumulate(curve.begin(), curve.end(), Complex(0)) / static_cast<double>(curve.size());
}

/// The circle through the samples, or the best one.
Circle fitted_circle(const std::vector<Complex>& curve) {
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
        numeric::maximum(std::abs(std::abs(z - circle.center) / circle.radius - 1), circle.circularity);
  return circle;
}

/// The curve's shift when what is around it is mapped by `h`: w = expm1(zeta - center) -> w + h(w), which
/// takes the curve's own samples to `image`. All other curves are carried along.
void map_around(LogCurves& curves, std::size_t k, const Shift& h, double reach,
                const std::vector<Complex>& image) {
  const LogCurve own = curves[k];
  const ShiftKeepingZero shift(h, reach, own.center);
  for (std::size_t other = 0; other < curves.size(); ++other)
    if (other != k) carry(curves[other], shift, gap(curves[other].center, own));
  // z / exp(center) - 1 of the image, after the translation that keeps z = 0 in its place.
  const Complex middle = mean(image);
  const Complex center = middle - shift.translation();
  curves[k].center += log1p(center);
  for (std::size_t j = 0; j < image.size(); ++j) curves[k].offset[j] = (image[j] - middle) / (1.0 + center);
  curves[k].offset = log1p_along(std::move(curves[k].offset));
}

void open(LogCurves& curves, std::size_t k) {
  const Opening opening(local(curves[k]));
  map_around(curves, k, opening, opening.reach(), opening.itself());
}

void make_round(LogCurves& curves, std::size_t k) {
  const std::vector<Complex> samples = local(curves[k]);
  const OuterRounding rounding(samples);
  const Shift h = [&](const std::vector<Complex>& path) {
    std::vector<Complex> result;
    result.reserve(path.size());
    for (const Complex w : path) result.push_back(rounding.added(w));
    return result;
  };
  map_around(curves, k, h, distance_from_zero(samples), rounding.samples());
}

/// The outer curve, or the inner one, which is an outer one for 1 / conj(z).
void make_round_about_zero(LogCurves& curves, bool is_outer) {
  LogCurve& own = curves[is_outer ? 0 : 1];
  const LogCurve before = own;
  const auto inward = [&](Complex zeta) {
    return is_outer ? zeta - before.center : -std::conj(zeta - before.center);
  };
  std::vector<Complex> curve;
  for (std::size_t j = 0; j < before.size(); ++j) curve.push_back(std::exp(inward(before.at(j))));
  const InnerRounding rounding(std::move(curve));
  const Complex at_infinity = is_outer ? 0 : rounding(0);
  const auto added = [&](Complex f) { return is_outer ? f : -std::conj(f - at_infinity); };
  const Shift shift = [&](const std::vector<Complex>& path) {
    std::vector<Complex> result;
    result.reserve(path.size());
    for (const Complex zeta : path) result.push_back(added(rounding(std::exp(inward(zeta)))));
    return result;
  };
  for (LogCurve& curve_moved : curves)
    if (&curve_moved != &own) carry(curve_moved, shift, gap(curve_moved.center, before));
  for (std::size_t j = 0; j < own.size(); ++j) own.offset[j] += added(rounding.logs()[j]);
}

/// Makes every curve a circle once, the outer one last.
void go_round(LogCurves& curves, const Progress& progress) {
  make_round_about_zero(curves, false);
  for (std::size_t k = 2; k < curves.size(); ++k) {
    progress.step("circles");
    make_round(curves, k);
  }
  make_round_about_zero(curves, true);
}

/// The outer and the inner curve are circles about 0, once they are circles.
Circle fitted_about_zero(const LogCurve& curve) {
  double log_radius = 0;
  for (const Complex d : curve.offset) log_radius += d.real() / static_cast<double>(curve.size());
  Circle circle{0, std::exp(curve.center.real() + log_radius), 0};
  for (const Complex d : curve.offset)
    circle.circularity = numeric::maximum(std::abs(std::expm1(d.real() - log_radius)), circle.circularity);
  return circle;
}

double unresolved_part(const LogCurve& curve) {
  return unresolved(local(curve));
}

void measure(CircularDomain& domain) {
  domain.circles.clear();
  domain.circularity = domain.unresolved = 0;
  for (std::size_t k = 0; k < domain.curves.size(); ++k) {
    const LogCurve& curve = domain.curves[k];
    if (k < 2) {
      domain.circles.push_back(fitted_about_zero(curve));
    } else {
      Circle circle = fitted_circle(local(curve));
      const Complex scale = std::exp(curve.center);
      circle.center = scale * (1.0 + circle.center);
      circle.radius *= std::abs(scale);
      domain.circles.push_back(circle);
    }
    domain.circularity = numeric::maximum(domain.circles.back().circularity, domain.circularity);
    domain.unresolved = numeric::maximum(unresolved_part(curve), domain.unresolved);
  }
}

/// The outer circle to the unit circle, the center of the first slit's circle to the positive axis.
void normalise(LogCurves& curves) {
  double outer = 0;
  for (const Complex d : curves[0].offset) outer += d.real() / static_cast<double>(curves[0].size());
  outer += curves[0].center.real();
  double turn = 0;
  if (curves.size() > 2)
    turn = curves[2].center.imag() + std::arg(1.0 + fitted_circle(local(curves[2])).center);
  for (LogCurve& curve : curves) curve.center -= Complex(outer, turn);
}

CircularDomain opened_domain(const SlitRing& ring, const std::vector<int>& samples) {
  CircularDomain domain;
  domain.curves = opened_slits(ring, samples, ring.slits.size());
  measure(domain);
  return domain;
}

void iterate(CircularDomain& domain, const CircularOptions& options, const Progress& progress) {
  double best = domain.circularity;
  int rounds_without_gain = 0;
  // Beyond the tolerance too, as long as it pays: rounds converge by a factor, until rounding stops them.
  while (domain.rounds < options.most_rounds && rounds_without_gain < 5) {
    const double before = domain.circularity;
    go_round(domain.curves, progress);
    ++domain.rounds;
    measure(domain);
    if (!std::isfinite(domain.circularity)) return;
    if (domain.circularity < options.tolerance && domain.circularity > before / 4) break;
    rounds_without_gain = domain.circularity < best / 2 ? 0 : rounds_without_gain + 1;
    best = std::min(best, domain.circularity);
  }
}

constexpr int most_samples_of_lost_curves = 1024;

/// How many samples each curve has, and what more of them have gained.
class Sampling {
public:
  Sampling(std::size_t curves, const CircularOptions& options)
      : options_(options), samples_(curves, options.samples), before_(curves, INFINITY) {}

  const std::vector<int>& samples() const { return samples_; }

  /// Doubles those of the curves that are not resolved, as long as it helps and may do. Whether there were
  /// any.
  bool refine(const CircularDomain& domain) {
    bool refined = false;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const double now = unresolved_part(domain.curves[k]);
      if (samples_[k] >= options_.most_samples || now < options_.tolerance / 10 || !may_do(k, now)) continue;
      if (std::isfinite(now)) before_[k] = now;
      samples_[k] *= 2;
      refined = true;
    }
    return refined;
  }

private:
  /// What is unresolved falls exponentially in the number of samples once it falls at all: with each doubling
  /// by a factor that is the square of the last one. Circles that nearly touch fall more slowly, and so much
  /// is granted; where even that would not do, twice and four times the samples cost minutes for nothing.
  bool may_do(std::size_t k, double now) const {
    // Curves that ran into each other; with more samples they may not.
    if (!std::isfinite(now)) return samples_[k] < most_samples_of_lost_curves;
    double factor = now / before_[k];
    if (!(factor < 0.5)) return false;
    for (int samples = samples_[k]; samples < options_.most_samples && now > options_.tolerance;
         samples *= 2) {
      factor *= factor;
      now *= factor;
    }
    return now <= options_.tolerance;
  }

  CircularOptions options_;
  std::vector<int> samples_;
  std::vector<double> before_;
};

} // namespace

CircularDomain circular_domain(const SlitRing& ring, const CircularOptions& options,
                               const Progress& progress) {
  check_ring(ring);
  Sampling sampling(ring.slits.size() + 2, options);
  while (true) {
    progress.step("circles");
    CircularDomain domain = opened_domain(ring, sampling.samples());
    if (sampling.refine(domain)) continue; // openings cost next to nothing
    iterate(domain, options, progress);
    if (sampling.refine(domain)) continue;
    if (!std::isfinite(domain.circularity)) domain = opened_domain(ring, sampling.samples());
    normalise(domain.curves);
    measure(domain);
    domain.found = domain.circularity < options.tolerance && domain.unresolved < options.tolerance;
    domain.circles[0].radius = 1;
    if (domain.circles.size() > 2) domain.circles[2].center.imag(0); // what is 0 but for rounding
    return domain;
  }
}

LogCurves opened_slits(const SlitRing& ring, const std::vector<int>& samples, std::size_t slits) {
  check_ring(ring);
  if (samples.size() != ring.slits.size() + 2 || slits > ring.slits.size())
    throw PreconditionError("each curve needs a number of samples, and only slits can be opened");
  LogCurves curves = sampled(ring, samples);
  for (std::size_t k = 0; k < slits; ++k) open(curves, k + 2);
  return curves;
}

std::vector<Complex> curve_at(const CircularDomain& domain, int curve, const std::vector<double>& t) {
  const LogCurve& samples = domain.curves[static_cast<std::size_t>(curve)];
  const Periodic at(local(samples));
  std::vector<Complex> result;
  result.reserve(t.size());
  for (const double parameter : t) result.push_back(std::exp(samples.center) * (1.0 + at(parameter)));
  return result;
}

} // namespace tetrarch::slit
