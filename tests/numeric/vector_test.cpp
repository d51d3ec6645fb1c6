// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/numeric/real50.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace tetrarch::numeric;

TEST_CASE("vectors obey their laws", "[vector]") {
  const Vector a{1, 2, 3};
  const Vector b{-2, 0.5, 4};
  CHECK(cross({1, 0, 0}, {0, 1, 0}) == Vector{0, 0, 1}); // right-handed
  CHECK(cross(a, b) == -cross(b, a));
  CHECK(dot(cross(a, b), a) == 0);
  // Lagrange's identity.
  CHECK(dot(cross(a, b), cross(a, b)) == dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
  CHECK(2.0 * (a - b) == a + a - (b + b));
  CHECK(norm({2, 3, 6}) == 7);
  CHECK(length({2e200, 3e200, 6e200}) == Approx(7e200));
  CHECK(distance(a, a + Vector{2, 3, 6}) == 7);
  CHECK(direction({0, 0, -5}) == Vector{0, 0, -1});
  CHECK_FALSE(direction({0, 0, 0}));
  CHECK_FALSE(direction({0, std::nan(""), 0}));
  CHECK(extent({{0, 5, 1}, {3, 1, 1}, {1, 2, 1}}) == 4);
}

TEST_CASE("a triangle laid flat keeps its sides and turns counterclockwise", "[vector]") {
  const std::vector<Point> points{{1, 1, 1}, {1, 4, 1}, {1, 1, 5}};
  const FlatTriangle p = laid_flat(points, {0, 1, 2});
  CHECK(p[0] == 0.0);
  CHECK(p[1] == 3.0);
  CHECK(std::abs(p[2] - std::complex<double>(0, 4)) < 1e-15);
  CHECK(twice_area(p) == Approx(12));
  CHECK(longest_squared(p) == Approx(25));
  CHECK(ratio_of_axes(p, {0.0, 6.0, std::complex<double>(0, 4)}) == Approx(2)); // stretched along one side
  CHECK(ratio_of_axes(p, {0.0, 3.0, std::complex<double>(0, -4)}) == 0);        // turned over
  CHECK(nearest_part(0, 4, {1, 9}) == 0.25);
  CHECK(nearest_part(0, 4, {-1, 9}) == 0);
  CHECK(nearest_part(2, 2, {-1, 9}) == 0);
}

TEST_CASE("half a turn in both scalars", "[vector]") {
  // The first 30 digits of pi, as in any table.
  CHECK(pi<Real50>().str(30) == "3.14159265358979323846264338328");
  CHECK(pi<double>() == static_cast<double>(pi<Real50>()));
  CHECK(1 + unit<double>() == 1.0);
  CHECK(1 + 2 * unit<double>() > 1.0);
}

TEST_CASE("A maximum of errors keeps what is no number", "[vector]") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(maximum(1.0, 2.0) == 2);
  CHECK(maximum(2.0, 1.0) == 2);
  CHECK(std::isnan(maximum(none, 1.0)));
  CHECK(std::isnan(maximum(1.0, none)));
  CHECK(std::isinf(maximum(1.0, std::numeric_limits<double>::infinity())));
  CHECK(isnan(maximum(Real50(none), Real50(1))));
  CHECK(isnan(maximum(Real50(1), Real50(none))));
  CHECK(maximum(Real50(1), Real50(2)) == 2);
}

TEST_CASE("classes that merge have one root", "[vector]") {
  std::vector<int> parent{0, 1, 2, 3, 4, 5};
  for (const auto& [a, b] : {std::pair{0, 3}, {3, 5}, {1, 2}})
    parent[find_root(parent, a)] = find_root(parent, b);
  CHECK(find_root(parent, 0) == find_root(parent, 5));
  CHECK(find_root(parent, 1) == find_root(parent, 2));
  CHECK(find_root(parent, 0) != find_root(parent, 1));
  CHECK(find_root(parent, 4) == 4);
}
