// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/predicates.hpp"

#include "support/random.hpp"
#include "tetrarch/core/perm4.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

int sign_of(const std::array<Point, 4>& p) {
  return static_cast<int>(volume_sign(p[0], p[1], p[2], p[3]));
}

std::array<Point, 4> permuted(const std::array<Point, 4>& p, Perm4 order) {
  return {p[static_cast<std::size_t>(order[0])], p[static_cast<std::size_t>(order[1])],
          p[static_cast<std::size_t>(order[2])], p[static_cast<std::size_t>(order[3])]};
}

} // namespace

TEST_CASE("the standard tetrahedron is positive", "[sign]") {
  CHECK(volume_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Sign::positive);
  CHECK(volume_sign({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == Sign::negative);
  CHECK(volume_sign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}) == Sign::zero);
}

TEST_CASE("the sign changes with the order of the vertices, and with nothing else", "[sign]") {
  // Law: odd permutations turn the sign. The points lie on a plane, or a few units in the last place above.
  support::Random random(3);
  int flat = 0;
  for (int k = 0; k < 2000; ++k) {
    std::array<Point, 4> p{};
    for (Point& q : p) {
      q = {random.below(100) * 0.125, random.below(100) * 0.125, 0};
      q[2] = q[0] * 0.5 + q[1] * 0.25;
      for (int ulps = random.below(3); ulps > 0; --ulps) q[2] = std::nextafter(q[2], 100);
    }
    const int sign = sign_of(p);
    flat += sign == 0;
    for (int r = 0; r < Perm4::count; ++r) {
      const Perm4 order = Perm4::from_rank(r);
      REQUIRE(sign_of(permuted(p, order)) == order.sign() * sign);
    }
  }
  CHECK(flat > 0);
  CHECK(flat < 2000);
}

TEST_CASE("the smallest and the largest numbers do not mislead", "[sign]") {
  const double tiny = 5e-324;
  const double huge = 1e300;
  CHECK(volume_sign({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}) == Sign::positive);
  CHECK(volume_sign({0, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, -huge}) == Sign::negative);
  CHECK(volume_sign({-huge, -huge, -huge}, {1.7e308, 0, 0}, {0, 1.7e308, 0}, {0, 0, 1.7e308}) ==
        Sign::positive);
  // A point one unit in the last place above a plane far from the origin.
  const double above = std::nextafter(1e6, 2e6);
  CHECK(volume_sign({0, 0, 1e6}, {1e6, 0, 1e6}, {0, 1e6, 1e6}, {3e5, 3e5, above}) == Sign::positive);
  CHECK(volume_sign({0, 0, 1e6}, {1e6, 0, 1e6}, {0, 1e6, 1e6}, {3e5, 3e5, 1e6}) == Sign::zero);
}

TEST_CASE("what is no number has no sign", "[sign]") {
  const Point o{0, 0, 0};
  const Point x{1, 0, 0};
  const Point y{0, 1, 0};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK(volume_sign(o, x, y, {0, 0, bad}) == Sign::undecided);
    CHECK(volume_sign({bad, 0, 0}, x, y, {0, 0, 1}) == Sign::undecided);
  }
}

TEST_CASE("a sign is believed beyond its error only", "[sign]") {
  CHECK(sign_beyond(2, 1) == Sign::positive);
  CHECK(sign_beyond(-2, 1) == Sign::negative);
  for (const double value : {-1.0, -0.5, 0.0, 0.5, 1.0}) CHECK(sign_beyond(value, 1) == Sign::undecided);
  CHECK(sign_beyond(0, 0) == Sign::zero);
  CHECK(sign_beyond(std::nan(""), 1) == Sign::undecided);
  CHECK(sign_beyond(1, std::nan("")) == Sign::undecided);
}
