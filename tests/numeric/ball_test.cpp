// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/ball.hpp"
#include "tetrarch/numeric/real50.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

/// A ball with a random midpoint below `size` and a radius from nothing to half of `size`.
Ball random_ball(support::Random& random, double size) {
  const double middle = size * (random.below(20001) / 10000.0 - 1);
  const double width = random.below(3) == 0 ? 0 : size / 2 * std::pow(10.0, -random.below(12));
  return widened(Ball(middle), Ball(width));
}

/// An exact number in a ball with a radius that doubles resolve.
double point_in(support::Random& random, const Ball& x) {
  return to_double(x) + to_double(radius(x)) * 0.999 * (random.below(20001) / 10000.0 - 1);
}

/// In 60 digits, which are far beyond the 53 bits of the ball: the second route.
bool holds(const Ball& ball, const Real50& value) {
  const auto text = value.str(50);
  const Real50 low(lower_decimal(ball, 50));
  const Real50 high(upper_decimal(ball, 50));
  return low <= value + abs(value) * 1e-45 && value <= high + abs(value) * 1e-45;
}

} // namespace

TEST_CASE("the value at a point lies in the value on a ball", "[ball]") {
  support::Random random(5);
  int informed = 0;
  for (int k = 0; k < 20000; ++k) {
    const Ball x = random_ball(random, 3);
    const Ball y = random_ball(random, 3);
    const Real50 a = point_in(random, x);
    const Real50 b = point_in(random, y);
    CAPTURE(k, a, b);
    REQUIRE(holds(x + y, a + b));
    REQUIRE(holds(x - y, a - b));
    REQUIRE(holds(x * y, a * b));
    REQUIRE(holds(-x, -a));
    REQUIRE(holds(abs(x), abs(a)));
    REQUIRE(holds(exp(x), exp(a)));
    REQUIRE(holds(sinh(x), sinh(a)));
    REQUIRE(holds(cosh(x), cosh(a)));
    REQUIRE(holds(sin(x), sin(a)));
    REQUIRE(holds(cos(x), cos(a)));
    if (is_finite(x / y)) REQUIRE(holds(x / y, a / b));
    if (is_finite(sqrt(x))) REQUIRE(holds(sqrt(x), sqrt(a)));
    if (is_finite(log(x))) REQUIRE(holds(log(x), log(a)));
    if (sign(y) == Sign::positive || sign(x) == Sign::positive) REQUIRE(holds(atan2(y, x), atan2(b, a)));
    informed += is_finite(x / y) ? 1 : 0;
  }
  CHECK(informed > 10000);
}

TEST_CASE("comparisons of balls are certain", "[ball]") {
  const Ball around_one = widened(Ball(1), Ball(0.25));
  CHECK(around_one > Ball(0.5));
  CHECK(Ball(0.5) < around_one);
  CHECK_FALSE(around_one > Ball(1));
  CHECK_FALSE(around_one < Ball(1));
  CHECK_FALSE(around_one == around_one); // it may stand for two numbers
  CHECK(around_one != around_one);
  CHECK(Ball(2) == Ball(2));
  CHECK(Ball(2) <= Ball(2));
  CHECK(sign(around_one) == Sign::positive);
  CHECK(sign(around_one - 1) == Sign::undecided);
  CHECK(sign(Ball(0)) == Sign::zero);
  CHECK(sign(-around_one) == Sign::negative);
  CHECK(overlap(around_one, Ball(1.25)));
  CHECK_FALSE(overlap(around_one, Ball(1.5)));
}

TEST_CASE("what knows nothing decides nothing", "[ball]") {
  for (const Ball& x :
       {Ball(1) / Ball(0), sqrt(Ball(-1)), log(Ball(0)), Ball(std::nan("")), Ball(INFINITY)}) {
    CHECK_FALSE(is_finite(x));
    CHECK_FALSE(x < Ball(1e300));
    CHECK_FALSE(x > Ball(-1e300));
    CHECK_FALSE(x == x);
    CHECK(sign(x) == Sign::undecided);
  }
}

TEST_CASE("precision lasts for its scope, and digits are those of the literature", "[ball]") {
  CHECK(working_precision() == 53);
  {
    const WorkingPrecision precise(400);
    CHECK(working_precision() == 400);
    // OEIS A000796.
    CHECK(certain_digits(pi<Ball>(), 50) == "3.1415926535897932384626433832795028841971693993751");
    CHECK(lower_decimal(pi<Ball>(), 20) == "3.1415926535897932384");
    CHECK(upper_decimal(pi<Ball>(), 20) == "3.1415926535897932385");
    CHECK(lower_decimal(-pi<Ball>(), 5) == "-3.1416");
  }
  CHECK(working_precision() == 53);
  CHECK(to_double(pi<Ball>()) == Approx(M_PI).epsilon(1e-15));
  CHECK(hexadecimal(Ball(-0.75)) == "-0x3p-2");
  CHECK(hexadecimal(Ball(0)) == "0x0p0");
  CHECK(std::stod(hexadecimal(Ball(0.1))) == 0.1);
}
