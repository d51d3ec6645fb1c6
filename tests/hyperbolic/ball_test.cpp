// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/tetrahedron.hpp"
#include "tetrarch/hyperbolic/volume.hpp"
#include "tetrarch/numeric/ball.hpp"
#include "tetrarch/numeric/real50.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using numeric::Ball;
using numeric::Real50;

namespace {

/// 60 digits against a ball of 53 bits; what they err by themselves is far below its radius.
bool holds(const Ball& ball, const Real50& value) {
  const Real50 slack = 1e-40 * (1 + abs(value));
  return Real50(numeric::lower_decimal(ball, 50)) <= value + slack &&
         value <= Real50(numeric::upper_decimal(ball, 50)) + slack;
}

struct Sample {
  VertexTypes types;
  SixNumbers<Ball> box;
  SixNumbers<Real50> point; ///< in the box
};

/// Lengths near those of regular tetrahedra, or from `flat` away from a flat one; boxes of radius from 1e-3
/// to nothing.
Sample random_sample(support::Random& random) {
  Sample sample;
  for (auto& type : sample.types) type = random.below(3) == 0 ? VertexType::ideal : VertexType::hyperideal;
  const double radius = random.below(4) == 0 ? 0 : std::pow(10.0, -3 - random.below(12));
  for (int e = 0; e < 6; ++e) {
    const double length = 0.3 + random.below(20000) / 10000.0;
    sample.box[e] = numeric::widened(Ball(length), Ball(radius));
    sample.point[e] = Real50(length) + Real50(radius) * 0.99 * (random.below(2001) / 1000.0 - 1);
  }
  return sample;
}

} // namespace

TEST_CASE("angles, their derivatives and the volume at a point lie in those of its box", "[hyperbolic]") {
  support::Random random(11);
  int seen = 0;
  int sharp = 0;
  for (int k = 0; k < 6000; ++k) {
    const Sample s = random_sample(random);
    const auto angles = dihedral_angles(s.box, s.types);
    if (!angles) continue;
    ++seen;
    const auto exact = dihedral_angles(s.point, s.types);
    REQUIRE(exact); // what exists on the box exists at each of its points
    const auto slopes = angle_jacobian(s.box, s.types);
    const auto exact_slopes = angle_jacobian(s.point, s.types);
    for (int e = 0; e < 6; ++e) {
      CAPTURE(k, e);
      REQUIRE(holds((*angles)[e], (*exact)[e]));
      for (int f = 0; f < 6; ++f) REQUIRE(holds(slopes[e][f], exact_slopes[e][f]));
    }
    const auto size = volume(s.box, s.types);
    REQUIRE(size);
    REQUIRE(holds(size->value, volume(s.point, s.types)->value));
    sharp += numeric::radius(size->value) < Ball(1e-10);
  }
  CHECK(seen > 1000);
  CHECK(sharp > 200);
}

TEST_CASE("no tetrahedron exists on a box that holds one that does not", "[hyperbolic]") {
  support::Random random(12);
  int refused = 0;
  for (int k = 0; k < 3000; ++k) {
    const Sample s = random_sample(random);
    if (exists(s.point, s.types)) continue;
    ++refused;
    REQUIRE_FALSE(exists(s.box, s.types));
    REQUIRE_FALSE(dihedral_angles(s.box, s.types).has_value());
    REQUIRE_FALSE(volume(s.box, s.types).has_value());
  }
  CHECK(refused > 100);
  // cosh is even: a length below 0 would fold back. And two planes that touch.
  for (const double length : {-1.0, 0.0}) {
    SixNumbers<Ball> box;
    box.fill(Ball(1));
    box[3] = Ball(length);
    CHECK_FALSE(exists(box, all_hyperideal));
  }
}

TEST_CASE("Clausen's function at a point lies in that of its ball", "[hyperbolic]") {
  support::Random random(13);
  for (int k = 0; k < 20000; ++k) {
    // Around whole turns, where tangents are vertical, around half turns, and anywhere in a few turns.
    const double centre = (random.below(9) - 4) * M_PI;
    const double x = k % 2 == 0
                         ? centre + std::pow(10.0, -random.below(18)) * (random.below(2001) / 1000.0 - 1)
                         : 14 * (random.below(20001) / 10000.0 - 1);
    const double radius = random.below(3) == 0 ? 0 : std::pow(10.0, -random.below(17));
    const Real50 point = Real50(x) + Real50(radius) * 0.99 * (random.below(2001) / 1000.0 - 1);
    CAPTURE(k, x, radius);
    REQUIRE(holds(clausen(numeric::widened(Ball(x), Ball(radius))), clausen(point)));
  }
  // Catalan's constant, OEIS A006752, is Cl(pi/2); in 300 bits.
  const numeric::WorkingPrecision precise(300);
  CHECK(numeric::certain_digits(clausen(Ball(numeric::pi<Ball>() / 2)), 60) ==
        "0.915965594177219015054603514932384110774149374281672134266498");
}

TEST_CASE("volumes in balls of any precision hold the known ones", "[hyperbolic]") {
  const numeric::WorkingPrecision precise(400);
  const auto volume_of = [](double length, const VertexTypes& types) {
    SixNumbers<Ball> lengths;
    lengths.fill(Ball(length));
    return volume(lengths, types)->value;
  };
  // The regular ideal tetrahedron, 3 Lobachevsky(pi/3): OEIS A143298.
  CHECK(numeric::certain_digits(volume_of(0, all_ideal), 60) ==
        "1.01494160640965362502120255427452028594168930753029979201749");
  // Any gauge.
  CHECK(numeric::overlap(volume_of(0.75, all_ideal), volume_of(0, all_ideal)));
}
