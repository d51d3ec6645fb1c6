// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hex_jacobian.hpp"

#include "support/random.hpp"
#include "tetrarch/product/hex_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::product;
using numeric::operator+;
using numeric::operator-;
using numeric::operator*;

namespace {

using Corners = std::array<Point, 8>;

constexpr Corners cube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

Corners shaken(double by, support::Random& random) {
  Corners result = cube;
  for (Point& p : result)
    for (double& x : p) x += by * (2 * random.uniform() - 1);
  return result;
}

/// Where the trilinear map sends a point of the unit cube.
Point image(const Corners& corners, const Point& u) {
  Point result{};
  for (std::size_t c = 0; c < 8; ++c) {
    double weight = 1;
    for (std::size_t a = 0; a < 3; ++a) weight *= cube[c][a] > 0 ? u[a] : 1 - u[a];
    result = result + weight * corners[c];
  }
  return result;
}

/// The determinant by differences, which are exact but for rounding: the map is linear along each axis.
double determinant(const Corners& corners, const Point& u) {
  std::array<numeric::Vector, 3> derivative{};
  for (std::size_t a = 0; a < 3; ++a) {
    Point low = u;
    Point high = u;
    low[a] = 0;
    high[a] = 1;
    derivative[a] = image(corners, high) - image(corners, low);
  }
  return numeric::dot(derivative[0], numeric::cross(derivative[1], derivative[2]));
}

double least_of_samples(const Corners& corners) {
  constexpr int n = 20;
  double least = determinant(corners, {0, 0, 0});
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
        least = std::min(least, determinant(corners, {i / double{n}, j / double{n}, k / double{n}}));
  return least;
}

} // namespace

TEST_CASE("Bernstein coefficients are those of the determinant", "[hex_jacobian]") {
  support::Random random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners corners = shaken(0.5, random);
    const JacobianCoefficients c = jacobian_coefficients(corners);
    for (int sample = 0; sample < 20; ++sample) {
      const Point u{random.uniform(), random.uniform(), random.uniform()};
      double sum = 0;
      const auto bernstein = [](int i, double x) {
        return i == 0 ? (1 - x) * (1 - x) : i == 1 ? 2 * x * (1 - x) : x * x;
      };
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            sum += c[i + 3 * j + 9 * k] * bernstein(i, u[0]) * bernstein(j, u[1]) * bernstein(k, u[2]);
      CHECK(sum == Approx(determinant(corners, u)).margin(1e-12));
    }
  }
}

TEST_CASE("A determinant is positive inside or not as dense samples say", "[hex_jacobian]") {
  support::Random random(5);
  int positive = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Corners corners = shaken(0.45, random);
    const double least = least_of_samples(corners);
    const bool is_positive = is_positive_inside(corners);
    if (least <= 0) CHECK_FALSE(is_positive);
    // Between the samples it may fall by little.
    if (least > 0.02) CHECK(is_positive);
    positive += is_positive ? 1 : 0;
    double at_corners = determinant(corners, {0.5, 0.5, 0.5});
    for (const Point& u : cube) at_corners = std::min(at_corners, determinant(corners, u));
    if (at_corners <= 0) continue;
    CHECK((scaled_jacobian(corners) > 0) == is_positive);
  }
  CHECK(positive > 100);
  // Positive at the corners and in the middle, and not between them.
  // Found by chance: no other way finds what is wrong with it.
  const Corners hidden{{{0.13, 0.48, 0.32},
                        {1.72, 0.76, -0.13},
                        {0.38, 1.67, 0.74},
                        {-0.8, 1.55, 0.44},
                        {-0.2, 0.15, 1.37},
                        {1.65, -0.66, 1.44},
                        {1.75, 0.79, 0.29},
                        {-0.79, 1.96, 1.62}}};
  for (const Point& u : cube) CHECK(determinant(hidden, u) > 0);
  CHECK(determinant(hidden, {0.5, 0.5, 0.5}) > 0);
  CHECK(least_of_samples(hidden) < -0.4);
  CHECK_FALSE(is_positive_inside(hidden));
  CHECK(scaled_jacobian(hidden) == 0);
  CHECK(is_positive_inside(cube));
  Corners flat = cube;
  for (Point& p : flat) p[2] = 0;
  CHECK_FALSE(is_positive_inside(flat));
}
