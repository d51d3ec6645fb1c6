// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/algebraic.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <ctime>
#include <stdexcept>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

/// What `recognize` asks for, and room for the rounding on the way.
long bits_for(int degree) {
  return 100 * (degree + 1) + 100;
}

Ball cosine_of_turn(int part, int whole) {
  return 2 * cos(2 * part * pi<Ball>() / whole);
}

Ball root_of(int radicand, int index) {
  return exp(log(Ball(radicand)) / index);
}

/// The one real root of x^5 - x - 1, by bisection.
Ball quintic_root() {
  Ball low = 1;
  Ball high = 2;
  for (long step = 0; step < working_precision(); ++step) {
    const Ball middle = ldexp(low + high, -1);
    (middle * middle * middle * middle * middle - middle - 1 < 0 ? low : high) = middle;
  }
  return widened(low, ldexp(Ball(1), static_cast<int>(4 - working_precision())));
}

Algebraic power(const Algebraic& x, int exponent) {
  Algebraic product(1);
  for (int k = 0; k < exponent; ++k) product *= x;
  return product;
}

} // namespace

TEST_CASE("algebraic numbers are known by their least polynomials", "[algebraic]") {
  const WorkingPrecision precise(bits_for(16));
  // Least polynomials of 2 cos(2 pi / n) are in Watkins and Zeitlin, "The minimal polynomial of cos(2 pi /
  // n)" (1993); x^5 - x - 1 is irreducible (Selmer 1956), x^12 - 2 and 3 x^2 - 2 by Eisenstein's criterion.
  const std::vector<std::pair<Ball, std::string>> known{
      {Ball(7), "x-7"},
      {Ball(-3) / 8, "8*x+3"},
      {ldexp(1 + sqrt(Ball(5)), -1), "x^2-x-1"},
      {ldexp(1 - sqrt(Ball(5)), -1), "x^2-x-1"},
      {sqrt(Ball(2) / 3), "3*x^2-2"},
      {sqrt(Ball(2)) + sqrt(Ball(3)), "x^4-10*x^2+1"},
      {cosine_of_turn(1, 7), "x^3+x^2-2*x-1"},
      {quintic_root(), "x^5-x-1"},
      {cosine_of_turn(3, 17), "x^8+x^7-7*x^6-6*x^5+15*x^4+10*x^3-10*x^2-4*x+1"},
      {root_of(2, 12), "x^12-2"}};
  for (const auto& [number, polynomial] : known) {
    CAPTURE(polynomial);
    const auto seen = recognize({number}, 16);
    REQUIRE(seen);
    REQUIRE(seen->numbers.size() == 1);
    CHECK(overlap(seen->numbers[0].value(), number));
    // A whole number or a fraction needs no field but the rationals.
    if (seen->degree == 1)
      CHECK(overlap(seen->numbers[0].value(), number));
    else
      CHECK((seen->polynomial == polynomial || seen->polynomial == "-" + polynomial));
  }
}

TEST_CASE("one field holds sums and products exactly", "[algebraic]") {
  const WorkingPrecision precise(bits_for(8));
  const Ball two = sqrt(Ball(2));
  const Ball three = sqrt(Ball(3));
  const auto seen = recognize({two, three, two + three, two * three, (1 + two) / 3, 1 / (two - three)}, 8);
  REQUIRE(seen);
  CHECK(seen->degree == 4);
  const auto& x = seen->numbers;
  REQUIRE(x.size() == 6);
  CHECK(x[0] * x[0] == Algebraic(2));
  CHECK(x[1] * x[1] == Algebraic(3));
  CHECK(x[0] + x[1] == x[2]);
  CHECK(x[0] * x[1] == x[3]);
  CHECK(x[4] * 3 - 1 == x[0]);
  CHECK(x[5] * (x[0] - x[1]) == Algebraic(1));
  CHECK(-x[5] == x[2]); // since (two - three) (two + three) = -1
  // What is not so is not equal, however near.
  CHECK_FALSE(x[0] == x[1]);
  CHECK_FALSE(x[0] == -x[0]);
  CHECK_FALSE(x[0] * 985 == x[1] * 0 + 1393); // differ by 3.6e-4
  CHECK_FALSE(x[2] * x[2] == Algebraic(10));
  // Values of results are those of the balls' arithmetic.
  const WorkingPrecision plain(200);
  CHECK(overlap((x[0] * x[1] + x[4]).value(), two * three + (1 + two) / 3));
  CHECK(radius((x[0] * x[1] + x[4]).value()) < Ball(1e-50));
  CHECK(Algebraic(-4).value() == Ball(-4));
}

TEST_CASE("a field grows until it holds all numbers", "[algebraic]") {
  const WorkingPrecision precise(bits_for(12));
  const auto seen = recognize({Ball(5), sqrt(Ball(5)), root_of(2, 3), sqrt(Ball(5))}, 12);
  REQUIRE(seen);
  CHECK(seen->degree == 6);
  CHECK(seen->numbers[0] == Algebraic(5));
  CHECK(power(seen->numbers[1], 2) == Algebraic(5));
  CHECK(power(seen->numbers[2], 3) == Algebraic(2));
  CHECK(seen->numbers[1] == seen->numbers[3]);
  CHECK_FALSE(power(seen->numbers[2], 2) == seen->numbers[1]);
}

TEST_CASE("inverses", "[algebraic]") {
  const WorkingPrecision precise(bits_for(4));
  const auto seen = recognize({ldexp(1 + sqrt(Ball(5)), -1)}, 4);
  REQUIRE(seen);
  const Algebraic& golden = seen->numbers[0];
  REQUIRE(golden.inverse());
  CHECK(*golden.inverse() == golden - 1);
  CHECK(golden * *golden.inverse() == Algebraic(1));
  CHECK_FALSE((golden * golden - golden - 1).inverse());
  CHECK_FALSE(Algebraic(0).inverse());
  CHECK(*Algebraic(4).inverse() * 4 == Algebraic(1));
}

TEST_CASE("numbers that are not algebraic of a small degree are refused", "[algebraic]") {
  const WorkingPrecision precise(bits_for(12));
  CHECK_FALSE(recognize({pi<Ball>()}, 12));
  CHECK_FALSE(recognize({exp(Ball(1))}, 12));
  CHECK_FALSE(recognize({sin(Ball(1)) + pi<Ball>()}, 12));
  CHECK_FALSE(recognize({sqrt(Ball(2)), pi<Ball>()}, 12)); // one is not enough
  CHECK_FALSE(recognize({pi<Ball>(), pi<Ball>() * sqrt(Ball(2))}, 12));
  CHECK_FALSE(recognize({Ball(0.6180339887498949)}, 12)); // a fraction of 53 bits tells nothing
  CHECK_FALSE(recognize({root_of(2, 12)}, 8));            // too large a degree
  // What a number differs by is seen as far as the balls know it, 1400 bits here.
  for (const int bits : {250, 600, 1350}) CHECK_FALSE(recognize({sqrt(Ball(2)) + ldexp(Ball(1), -bits)}, 12));
  // Balls that know too little.
  CHECK_FALSE(recognize({widened(pi<Ball>(), Ball(1))}, 12));
  CHECK_FALSE(recognize({widened(sqrt(Ball(2)), ldexp(Ball(1), -150))}, 2));
  CHECK_FALSE(recognize({1 / Ball(0)}, 4));
}

TEST_CASE("a search for a field can be ended", "[algebraic]") {
  const WorkingPrecision precise(bits_for(8));
  int asked = 0;
  const auto stop = [&] {
    if (++asked == 3) throw std::runtime_error("enough");
  };
  CHECK_THROWS_WITH(recognize({sqrt(Ball(2)) + root_of(3, 3)}, 8, stop), "enough");
  CHECK(asked == 3);
}

TEST_CASE("no step of a search is long", "[algebraic]") {
  // Of the greatest degree that proofs of flat cells ask for (src/canonical/exact.cpp). Processor time: 0.1
  // s.
  const WorkingPrecision precise(bits_for(16));
  std::clock_t before = std::clock();
  double longest = 0;
  const auto ask = [&] {
    const std::clock_t now = std::clock();
    longest = std::max(longest, static_cast<double>(now - before) / CLOCKS_PER_SEC);
    before = now;
  };
  const Ball root = root_of(2, 16);
  const auto seen = recognize({root, root * root + 1, 1 / root}, 16, ask);
  ask();
  REQUIRE(seen);
  CHECK(seen->degree == 16);
  CHECK(seen->numbers[0] * seen->numbers[2] == Algebraic(1));
  CHECK_FALSE(recognize({pi<Ball>()}, 16, ask));
  CHECK(longest < 0.5);
}
