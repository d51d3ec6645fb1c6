// SPDX-License-Identifier: GPL-2.0-or-later
/// Rings with slits to disks with round holes, against the way back by another method.
#include "tetrarch/slit/circular_domain.hpp"

#include "tetrarch/core/error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::slit;

namespace {

using Complex = std::complex<double>;

constexpr double full_turn = 2 * std::numbers::pi;

/// A round hole.
struct Hole {
  Complex center;
  double radius = 0;
};

/// The slit map of the unit disk with round holes, the first of them about 0, as a series:
///
///     w = log z + sum a[m] z^m + sum over holes and m > 0 of b[m] (radius / (z - center))^m
///
/// whose real part is as constant on each circle as least squares can make it. No integral equation, no
/// openings, no iteration.
class SeriesMap {
public:
  SeriesMap(std::vector<Hole> holes, int degree) : holes_(std::move(holes)), degree_(degree) {
    const int samples = 4 * degree;
    const auto rows = static_cast<Eigen::Index>(samples * (holes_.size() + 1));
    const auto terms = static_cast<Eigen::Index>(1 + 2 * degree_ * (holes_.size() + 1));
    const auto columns = terms + static_cast<Eigen::Index>(holes_.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, columns);
    Eigen::VectorXd right(rows);
    Eigen::Index row = 0;
    for (std::size_t k = 0; k <= holes_.size(); ++k)
      for (int j = 0; j < samples; ++j, ++row) {
        const Complex z =
            k == 0 ? std::polar(1.0, full_turn * j / samples) : on_circle(k - 1, full_turn * j / samples);
        const std::vector<Complex> basis = functions(z);
        matrix(row, 0) = 1;
        for (std::size_t m = 0; m < basis.size(); ++m) {
          matrix(row, static_cast<Eigen::Index>(2 * m + 1)) = basis[m].real();
          matrix(row, static_cast<Eigen::Index>(2 * m + 2)) = -basis[m].imag();
        }
        if (k > 0) matrix(row, terms + static_cast<Eigen::Index>(k) - 1) = -1;
        right[row] = -std::log(std::abs(z));
      }
    solution_ = matrix.colPivHouseholderQr().solve(right);
    residual_ = (matrix * solution_ - right).lpNorm<Eigen::Infinity>();
    for (Eigen::Index k = terms; k < columns; ++k) heights_.push_back(solution_[k]);
  }

  double residual() const { return residual_; }

  SlitRing ring() const {
    SlitRing result{std::exp(heights_[0]), {}};
    for (std::size_t k = 1; k < holes_.size(); ++k) {
      const double lowest = -peak(k, -1);
      result.slits.push_back({std::exp(heights_[k]), lowest, peak(k, 1)});
    }
    return result;
  }

private:
  Complex on_circle(std::size_t k, double t) const {
    return holes_[k].center + std::polar(holes_[k].radius, t);
  }

  std::vector<Complex> functions(Complex z) const {
    std::vector<Complex> result;
    const auto add_powers = [&](Complex base) {
      Complex power = 1;
      for (int m = 0; m < degree_; ++m) result.push_back(power *= base);
    };
    add_powers(z);
    for (const Hole& hole : holes_) add_powers(hole.radius / (z - hole.center));
    return result;
  }

  double angle(std::size_t k, Complex z) const {
    // The slit is all on one sheet if the logarithm is continued from its centre.
    const Complex center = holes_[k].center;
    double sum = std::arg(center) + std::arg(z / center);
    const std::vector<Complex> basis = functions(z);
    for (std::size_t m = 0; m < basis.size(); ++m)
      sum += (basis[m] * Complex(solution_[static_cast<Eigen::Index>(2 * m + 1)],
                                 solution_[static_cast<Eigen::Index>(2 * m + 2)]))
                 .imag();
    return sum;
  }

  /// The greatest sign * angle on circle k: the best of a grid, and a parabola through it and its neighbours.
  double peak(std::size_t k, double sign) const {
    const int steps = 20'000;
    const auto value = [&](int j) { return sign * angle(k, on_circle(k, full_turn * j / steps)); };
    int best = 0;
    double highest = value(0);
    for (int j = 1; j < steps; ++j)
      if (const double here = value(j); here > highest) {
        highest = here;
        best = j;
      }
    const double before = value(best - 1);
    const double after = value(best + 1);
    return highest + (after - before) * (after - before) / (8 * (2 * highest - before - after));
  }

  std::vector<Hole> holes_;
  int degree_ = 0;
  Eigen::VectorXd solution_;
  std::vector<double> heights_;
  double residual_ = 0;
};

/// The greatest difference to these holes, after the rotation that the domain has been given.
double difference(const CircularDomain& domain, const std::vector<Hole>& holes) {
  const Complex turn = holes.size() > 1 ? std::conj(holes[1].center) / std::abs(holes[1].center) : 1.0;
  double greatest = std::abs(domain.circles.at(0).center) + std::abs(domain.circles.at(0).radius - 1);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    greatest = std::max(greatest, std::abs(domain.circles.at(k + 1).center - turn * holes[k].center));
    greatest = std::max(greatest, std::abs(domain.circles.at(k + 1).radius - holes[k].radius));
  }
  return greatest;
}

} // namespace

TEST_CASE("A ring is its own circular domain", "[slit]") {
  const CircularDomain domain = circular_domain({0.3, {}});
  CHECK(domain.found);
  CHECK(difference(domain, {{0, 0.3}}) < 1e-14);
}

TEST_CASE("Round holes come back from their slits", "[slit]") {
  // Two, three and six holes; in the last two, gaps of a tenth of a radius, for which the series needs many
  // terms.
  const std::vector<std::pair<std::vector<Hole>, int>> domains{
      {{{0, 0.3}, {{0.6, 0.1}, 0.2}}, 40},
      {{{0, 0.2}, {{0.55, 0.0}, 0.12}, {{-0.2, 0.5}, 0.15}}, 30},
      {{{0, 0.1},
        {{0.5, 0.1}, 0.1},
        {{0.0, 0.5}, 0.2},
        {{-0.5, 0}, 0.05},
        {{-0.3, -0.4}, 0.15},
        {{0.3, -0.5}, 0.1}},
       24},
      {{{0, 0.3}, {{0.5, 0.0}, 0.18}}, 80},
      {{{0, 0.2}, {{0.0, 0.6}, 0.37}}, 80}};
  for (const auto& [holes, degree] : domains) {
    const SeriesMap map(holes, degree);
    REQUIRE(map.residual() < 1e-6);
    const CircularDomain domain = circular_domain(map.ring());
    CHECK(domain.found);
    CHECK(domain.circularity < 1e-9);
    // The series' own error, amplified a little.
    CHECK(difference(domain, holes) < std::max(100 * map.residual(), 1e-11));
    CHECK(domain.rounds <= 20);
  }
}

TEST_CASE("Slits that nearly close, or nearly touch, are opened", "[slit]") {
  const std::vector<SlitRing> rings{{0.2, {{0.6, 0.2, 5.0}, {0.4, 2, 3.5}, {0.8, 1, 4}}},
                                    {0.1, {{0.5, 0, 2}, {0.6, 1, 3}, {0.5, 2.3, 4}}}};
  for (const SlitRing& ring : rings) {
    const CircularDomain domain = circular_domain(ring);
    CHECK(domain.found);
    CHECK(domain.circularity < 1e-9);
    // No two circles meet: their inversive distance is above 1.
    for (std::size_t j = 1; j < domain.circles.size(); ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Circle& a = domain.circles[j];
        const Circle& b = domain.circles[k];
        const double distance = (std::norm(a.center - b.center) - a.radius * a.radius - b.radius * b.radius) /
                                (2 * a.radius * b.radius);
        CHECK((k == 0 ? -distance : distance) > 1);
      }
    // More samples at first change nothing.
    CircularOptions finer;
    finer.samples = 512;
    const CircularDomain again = circular_domain(ring, finer);
    for (std::size_t k = 0; k < domain.circles.size(); ++k) {
      CHECK(std::abs(again.circles[k].center - domain.circles[k].center) < 1e-9);
      CHECK(std::abs(again.circles[k].radius - domain.circles[k].radius) < 1e-9);
    }
  }
}

TEST_CASE("The first opening alone makes a circle of its slit, and of no other", "[slit]") {
  const SlitRing ring{0.2, {{0.6, 0.2, 1.0}, {0.5, 2, 3.5}}};
  const auto roundness = [&](std::size_t slits, std::size_t k) {
    // Ptolemy: four points on a circle have a real cross ratio.
    std::vector<Complex> curve;
    const LogCurve logs = opened_slits(ring, {128, 128, 128, 128}, slits)[k];
    for (std::size_t j = 0; j < logs.size(); ++j) curve.push_back(std::exp(logs.at(j)));
    const std::size_t n = curve.size();
    const Complex a = curve[0];
    const Complex b = curve[n / 4];
    const Complex c = curve[n / 2];
    double worst = 0;
    for (std::size_t j = n / 2 + 1; j < n; ++j) {
      const Complex ratio = (a - b) * (c - curve[j]) / ((a - curve[j]) * (c - b));
      worst = std::max(worst, std::abs(ratio.imag()) / std::abs(ratio));
    }
    return worst;
  };
  CHECK(roundness(1, 2) < 1e-12);
  // What the dissertation says of circles before and after is not so: the outer one is bent.
  CHECK(roundness(1, 0) > 1e-3);
  CHECK(roundness(2, 2) > 1e-3);
}

TEST_CASE("One slit far from both circles becomes the circle that its arc's capacity gives", "[slit]") {
  // The map of the outside of an arc of angle a on the unit circle that is z + const at infinity and keeps 0:
  // the radius is the capacity of the arc, sin(a / 4), and by the symmetry z -> 1 / conj(z), which exchanges
  // 0 and infinity, the center is 1 and the derivative at 0 cos(a / 4)^2. The circles of the ring are e^-150
  // away: they do not feel the slit, nor it them.
  for (const double angle : {1e-11, 1e-6, 0.5, 3.0, 5.5}) {
    const CircularDomain domain = circular_domain({std::exp(-300.0), {{std::exp(-150.0), 0, angle}}});
    REQUIRE(domain.found);
    const Circle& circle = domain.circles.at(2);
    CHECK(circle.radius / std::abs(circle.center) == Approx(std::sin(angle / 4)).epsilon(1e-11));
    CHECK(std::log(std::abs(circle.center)) == Approx(-150).epsilon(1e-14));
    CHECK(std::log(domain.circles[1].radius) + 300 ==
          Approx(2 * std::log(std::cos(angle / 4))).margin(1e-12));
  }
}

TEST_CASE("Far from both ends of a long ring slits do not feel where they are", "[slit]") {
  const auto ring = [](double length) {
    const double middle = std::exp(-length / 2);
    return SlitRing{std::exp(-length), {{middle, 0, 2}, {middle * 0.7, 1, 1.001}, {middle * 0.6, 3, 4}}};
  };
  // Circles of the ring at e^-35 and less change nothing that doubles hold.
  const CircularDomain near = circular_domain(ring(70));
  for (const double length : {200.0, 690.0}) {
    const CircularDomain far = circular_domain(ring(length));
    REQUIRE(far.found);
    for (std::size_t k = 2; k < 5; ++k) {
      const Complex place = far.circles[k].center / far.circles[2].center;
      const Complex known = near.circles[k].center / near.circles[2].center;
      CHECK(std::abs(place - known) < 1e-10);
      CHECK(far.circles[k].radius / far.circles[2].radius ==
            Approx(near.circles[k].radius / near.circles[2].radius).epsilon(1e-10));
    }
  }
}

TEST_CASE("A slit a thousandth from the outer circle: no circles are found, and minutes are not spent",
          "[slit]") {
  // The hole of diameter .019 ends up some 1e-9 from the outer circle, which 8,192 samples do not resolve.
  const SlitRing ring{0.4242027844570741, {{0.9992403282516767, 0, 0.056779060767359724}}};
  for (const int most : {128, 256, 512, 1024, 8192}) {
    CircularOptions options;
    options.most_samples = most;
    const CircularDomain domain = circular_domain(ring, options);
    CAPTURE(most);
    CHECK_FALSE(domain.found);
    CHECK(std::isfinite(domain.circularity));
    CHECK(std::isfinite(domain.unresolved));
    CHECK(domain.circles[2].radius < 0.1);
    CHECK(domain.curves[0].size() <= 4096);
    for (const LogCurve& curve : domain.curves)
      for (const Complex d : curve.offset) CHECK((std::isfinite(d.real()) && std::isfinite(d.imag())));
  }
}

TEST_CASE("Impossible slits are refused", "[slit]") {
  CHECK_THROWS_AS(circular_domain({0, {}}), PreconditionError);
  CHECK_THROWS_AS(circular_domain({0.5, {{0.4, 0, 1}}}), PreconditionError);
  CHECK_THROWS_AS(circular_domain({0.5, {{0.7, 1, 1}}}), PreconditionError);
  CHECK_THROWS_AS(circular_domain({0.5, {{0.7, 0, 7}}}), PreconditionError);
}

TEST_CASE("A budget of no rounds finds nothing, and says so", "[slit]") {
  CircularOptions none;
  none.most_rounds = 0;
  const CircularDomain domain = circular_domain({0.2, {{0.6, 0.2, 1.0}, {0.5, 2, 3.5}}}, none);
  CHECK_FALSE(domain.found);
  CHECK(domain.circularity > 1e-4);
}
