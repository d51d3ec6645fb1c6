// SPDX-License-Identifier: GPL-2.0-or-later

/// Flatness from linear relations, of matrices made by hand.

#include "src/canonical/relations.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::canonical;
using numeric::Ball;

namespace {

/// Norms 1, and symbols by their values, which may be whole numbers.
struct Pattern {
  SymbolMatrix symbols;
  BallMatrix gram;
};

Pattern pattern(const SymbolMatrix& symbols, const std::vector<Ball>& values) {
  Pattern p{symbols, {}};
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    p.gram.emplace_back();
    for (std::size_t j = 0; j < symbols.size(); ++j)
      p.gram[i].push_back(i == j ? Ball(1) : values[symbols[i][j]]);
  }
  return p;
}

bool is_flat(const Pattern& p) {
  return is_flat_by_relations(p.symbols, p.gram);
}

/// A pyramid: 0 the sides of its base A C B D, 1 both diagonals A B and C D, 2 the edges to the apex.
const SymbolMatrix pyramid{
    {1, 1, 0, 0, 2}, {1, 1, 0, 0, 2}, {0, 0, 1, 1, 2}, {0, 0, 1, 1, 2}, {2, 2, 2, 2, 1}};
/// Two apexes, 0 between them, 1 from them to a triangle, whose sides are 2.
const SymbolMatrix double_pyramid{
    {1, 0, 1, 1, 1}, {0, 1, 1, 1, 1}, {1, 1, 1, 2, 2}, {1, 1, 2, 1, 2}, {1, 1, 2, 2, 1}};

} // namespace

TEST_CASE("a square is flat", "[canonical]") {
  // A + B = C + D if 1 + d = 2 a. On the complement: 1 - d twice, and [8 a, 4 p; 4 p, 1] for the sums.
  CHECK(is_flat(pattern(pyramid, {-2, -5, -3})));
  const Ball about = widened(Ball(-5), Ball(1e-10));
  CHECK(is_flat(pattern(pyramid, {-2, about, -3})));
}

TEST_CASE("what only looks like a relation proves nothing", "[canonical]") {
  CHECK_FALSE(is_flat(pattern(pyramid, {-2, -4.75, -3}))); // 1 + d is not 2 a
  // As before, but G may have rank 3 on the complement: 4 p^2 = 4 a. Then d may be another.
  CHECK_FALSE(is_flat(pattern(pyramid, {9, widened(Ball(17), Ball(1e-10)), -3})));
  // The square again, when nothing is known of which products are equal.
  SymbolMatrix all_different = pyramid;
  int next = 0;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j) all_different[i][j] = all_different[j][i] = next++;
  std::vector<Ball> values;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j) values.push_back(std::array<Ball, 3>{-2, -5, -3}[pyramid[i][j]]);
  CHECK_FALSE(is_flat(pattern(all_different, values)));
}

TEST_CASE("a double pyramid that is not flat is not proved to be", "[canonical]") {
  // A + B - k (C + D + E) is in the kernel if (1 + x)(1 + 2 a) = 6 p^2, k = (1 + x) / 3 p: with p = a = -2
  // x = -9, k = 4/3; flat were k = 2/3.
  CHECK_FALSE(is_flat(pattern(double_pyramid, {-9, -2, -2})));
  // And with 1 + x = 2 p it is, but that is no relation of eigenvectors.
  CHECK_FALSE(is_flat(pattern(double_pyramid, {-7, -3, -5})));
}

TEST_CASE("a relation alone proves nothing", "[canonical]") {
  // Two pyramids over the square, 2 from apexes to corners, 3 between apexes. With S = A + B = C + D of norm
  // -8 and P + Q of norm -18, product -12, the kernel holds 3 S - 2 P - 2 Q, whose sum is 2.
  const SymbolMatrix two_apexes{{1, 1, 0, 0, 2, 2}, {1, 1, 0, 0, 2, 2}, {0, 0, 1, 1, 2, 2},
                                {0, 0, 1, 1, 2, 2}, {2, 2, 2, 2, 1, 3}, {2, 2, 2, 2, 3, 1}};
  CHECK_FALSE(is_flat(pattern(two_apexes, {-2, -5, -3, -10})));
}

TEST_CASE("a constant column is enough", "[canonical]") {
  // An octahedron with all edges a and diagonals 2 a - 1: the sums of opposite corners are equal, of norm 4
  // a.
  SymbolMatrix octahedron(6, std::vector<int>(6, 0));
  for (int i = 0; i < 6; ++i) {
    octahedron[i][i] = 1;
    octahedron[i][i % 2 == 0 ? i + 1 : i - 1] = 1;
  }
  CHECK(is_flat(pattern(octahedron, {-2, -5})));
}
