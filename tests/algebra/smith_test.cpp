// SPDX-License-Identifier: GPL-2.0-or-later
#include "naive_algebra.hpp"

#include "tetrarch/algebra/abelian_group.hpp"
#include "tetrarch/algebra/smith.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <utility>

using namespace tetrarch;
using namespace tetrarch::algebra;
using naive::Dense;
using support::Random;

namespace {

SmithForm smith(const Dense& m) {
  return smith_normal_form(naive::sparse(m));
}

Dense transposed(const Dense& m) {
  Dense out(m[0].size(), std::vector<Integer>(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m[0].size(); ++j) out[j][i] = m[i][j];
  return out;
}

/// The matrix with this diagonal, hidden: rows and columns, some of them zero, are mixed with many-digit factors.
Dense hidden(const std::vector<Integer>& diagonal, std::size_t rows, std::size_t columns, Random& random) {
  Dense m(rows, std::vector<Integer>(columns));
  for (std::size_t i = 0; i < diagonal.size(); ++i) m[i][i] = diagonal[i];
  const auto factor = [&random] {
    return (Integer(random.below(1 << 30)) << 30) + random.below(1 << 30) - (Integer(1) << 59);
  };
  // Each line but the last gets a multiple of the next, then each but the first one of the one before.
  const auto add = [](auto& x, const auto& y, const Integer& f) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += f * y[k];
  };
  for (int turn = 0; turn < 2; ++turn) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i) add(m[i], m[i + 1], factor());
    for (std::size_t i = m.size(); i-- > 1;) add(m[i], m[i - 1], factor());
    m = transposed(m);
  }
  return m;
}

} // namespace

// By hand: the relations are f_i - f_(i+1) + a h = 0 around a ring of n, whose sum is n a h = 0. The row of h
// is long, and so changes its form; with a large a it outgrows machine integers on the way. The square of the
// longest would take a minute.
TEST_CASE("A generator in every relation", "[smith]") {
  const auto ring = [](int n, const Integer& a) {
    SparseMatrix m(n + 1, n);
    for (int i = 0; i < n; ++i) {
      m.add(i, i, 1);
      m.add((i + 1) % n, i, -1);
      m.add(n, i, a);
    }
    return smith_normal_form(m);
  };
  for (const int n : {2, 255, 256, 257, 1000, 200'000}) CHECK(ring(n, 1) == SmithForm{n - 1, {n}});
  const Integer large = Integer(1) << 60;
  for (const int n : {200, 300}) CHECK(ring(n, large) == SmithForm{n - 1, {n * large}});
}

TEST_CASE("Smith forms by hand", "[smith]") {
  // By hand: the gcd of the entries 2 and 3 is 1, the determinant 6.
  CHECK(smith({{2, 0}, {0, 3}}) == SmithForm{1, {6}});
  // By hand: entries' gcd 2, minors' gcd 12 (for instance 2*6+4*6 = 36, 2*12+4*6 = 48), determinant -144.
  CHECK(smith({{2, 4, 4}, {-6, 6, 12}, {10, -4, -16}}) == SmithForm{0, {2, 6, 12}});
  // By hand: rank one, gcd of the entries 3.
  CHECK(smith({{6, 9}, {-12, -18}, {0, 0}}) == SmithForm{0, {3}});
  // By hand: 4 and 6 alone in their rows and columns: gcd 2, lcm 12, beside a unit and a zero.
  CHECK(smith({{0, 4, 0, 0}, {6, 0, 0, 0}, {0, 0, 0, -1}}) == SmithForm{1, {2, 12}});
  CHECK(smith_normal_form(SparseMatrix(0, 0)) == SmithForm{});
  CHECK(smith_normal_form(SparseMatrix(3, 0)) == SmithForm{});
  CHECK(smith_normal_form(SparseMatrix(3, 5)) == SmithForm{});
}

TEST_CASE("entries given twice add up", "[smith]") {
  SparseMatrix m(1, 2);
  for (const int value : {1, 1, 1}) m.add(0, 1, value);
  m.add(0, 0, 5);
  m.add(0, 0, -5);
  CHECK(smith_normal_form(m) == SmithForm{0, {3}}); // by hand: the matrix (0 3)
  CHECK_THROWS_AS(m.add(1, 0, 1), PreconditionError);
  CHECK_THROWS_AS(m.add(0, 2, 1), PreconditionError);
  CHECK_THROWS_AS(SparseMatrix(-1, 2), PreconditionError);
}

TEST_CASE("the Smith form is that of the determinantal divisors", "[smith]") {
  Random random(1);
  for (int round = 0; round < 400; ++round) {
    const std::array<int, 4> draw{random.below(4), random.below(5), random.below(70), random.below(9)};
    const Dense m = naive::random_dense(1 + draw[0], 1 + draw[1], 30 + draw[2], 1 + draw[3], random);
    INFO("round " << round);
    CHECK(smith(m) == naive::smith_by_minors(m));
  }
}

TEST_CASE("sparse and dense elimination agree", "[smith]") {
  Random random(2);
  for (int round = 0; round < 150; ++round) {
    const Integer size = round % 3 == 0 ? 1 : round % 3 == 1 ? 6 : 1000;
    const std::array<int, 3> draw{random.below(16), random.below(16), random.below(60)};
    const Dense m = naive::random_dense(1 + draw[0], 1 + draw[1], 10 + draw[2], size, random);
    INFO("round " << round);
    CHECK(smith(m) == naive::smith_dense(m));
    CHECK(smith(transposed(m)) == smith(m));
  }
}

TEST_CASE("numbers beyond a machine word", "[smith]") {
  Random random(3);
  const Integer word = Integer(1) << 62;
  for (int round = 0; round < 40; ++round) {
    // Entries that fit into 63 bits but whose products do not, entries that do not fit, and a mixture.
    const Integer size = round % 3 == 0 ? word : round % 3 == 1 ? Integer(word * word) : Integer(1000000000);
    const std::array<int, 2> draw{random.below(6), random.below(6)};
    const Dense m = naive::random_dense(2 + draw[0], 2 + draw[1], 80, size, random);
    INFO("round " << round);
    CHECK(smith(m) == naive::smith_dense(m));
  }
  // The smallest machine integer has no absolute value there.
  const Integer least = -(Integer(1) << 63);
  CHECK(smith({{least, 0}, {0, least}}) == SmithForm{0, {Integer(-least), Integer(-least)}});
  CHECK(smith({{1, 1}, {Integer(-(least + 1)), Integer(least + 1)}}) ==
        SmithForm{1, {Integer(-2 * (least + 1))}}); // the determinant
}

TEST_CASE("a common factor comes out of every invariant factor", "[smith]") {
  Random random(4);
  for (const Integer& factor : {Integer(7), Integer(1) << 100}) {
    Dense m = naive::random_dense(12, 9, 40, 3, random);
    const SmithForm before = smith(m);
    for (auto& row : m)
      for (Integer& x : row) x *= factor;
    Torsion expected(static_cast<std::size_t>(before.units), factor);
    for (const Integer& f : before.factors) expected.push_back(factor * f);
    CHECK(smith(m) == SmithForm{0, expected});
  }
}

TEST_CASE("a long chain of small numbers makes a large one", "[smith]") {
  // The matrix with 3 on the diagonal and -1, -1 beside it has the determinant F(2n+2) (Fibonacci numbers, by
  // expansion: D(n) = 3 D(n-1) - D(n-2), D(0) = 1, D(1) = 3), and n-1 units because of its off-diagonal.
  const int n = 200;
  SparseMatrix m(n, n);
  for (int i = 0; i < n; ++i) {
    m.add(i, i, 3);
    if (i > 0) m.add(i, i - 1, -1);
    if (i + 1 < n) m.add(i, i + 1, -1);
  }
  Integer a = 1;
  Integer b = 3;
  for (int i = 1; i < n; ++i) {
    const Integer next = 3 * b - a;
    a = b;
    b = next;
  }
  CHECK(smith_normal_form(m) == SmithForm{n - 1, {b}});
}

TEST_CASE("abelian groups are written in one way", "[abelian]") {
  CHECK(AbelianGroup().str() == "0");
  CHECK(AbelianGroup(1).str() == "Z");
  CHECK(AbelianGroup(2, {3}).str() == "Z^2 + Z/3");
  CHECK(AbelianGroup(0, {4, 2}).str() == "Z/2 + Z/4");
  CHECK(AbelianGroup(1, {1, 2, 3, 1}).str() == "Z + Z/6");
  CHECK(AbelianGroup(0, {1, 1}).is_trivial());
  CHECK_THROWS_AS(AbelianGroup(-1), PreconditionError);
  CHECK_THROWS_AS(AbelianGroup(0, {2, 0}), PreconditionError);
}

TEST_CASE("Z/a + Z/b is Z/gcd + Z/lcm, and order does not matter", "[abelian]") {
  for (int a = 1; a <= 24; ++a)
    for (int b = 1; b <= 24; ++b) {
      const Integer common = gcd(Integer(a), Integer(b));
      CHECK(AbelianGroup(0, {a, b}) == AbelianGroup(0, {common, a * b / common}));
      CHECK(AbelianGroup(0, {a, b, 12}) == AbelianGroup(0, {12, b, a}));
    }
  Random random(5);
  for (int round = 0; round < 100; ++round) {
    Torsion orders;
    for (int i = 0; i < 6; ++i) orders.push_back(1 + random.below(60));
    const auto factors = invariant_factors(orders);
    Integer product = 1;
    for (const Integer& order : orders) product *= order;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      product /= factors[i];
      CHECK((factors[i] > 1 && (i == 0 || factors[i] % factors[i - 1] == 0)));
    }
    CHECK(product == 1);
  }
}

TEST_CASE("Invariant factors hidden behind entries of many digits are found", "[smith]") {
  Random random(7);
  const Integer large = (Integer(1) << 200) + 235; // whatever its divisors
  for (int round = 0; round < 6; ++round) {
    CAPTURE(round);
    // The zero of rank, and of columns, and factors that are the whole minor.
    CHECK(smith(hidden(std::vector<Integer>(20, 1), 20, 20, random)) == SmithForm{20, {}});
    std::vector<Integer> one(20, 1);
    one.back() = large;
    CHECK(smith(hidden(one, 20, 20, random)) == SmithForm{19, {large}});
    CHECK(smith(hidden(one, 24, 20, random)) == SmithForm{19, {large}});
    CHECK(smith(hidden(one, 20, 23, random)) == SmithForm{19, {large}});
    std::vector<Integer> many(17, 1);
    for (const int d : {2, 2, 6, 12, 360}) many.push_back(d);
    many.push_back(360 * large);
    many.push_back(360 * large);
    const Torsion factors{2, 2, 6, 12, 360, 360 * large, 360 * large};
    CHECK(smith(hidden(many, 24, 24, random)) == SmithForm{17, factors});
    CHECK(smith(hidden(many, 29, 27, random)) == SmithForm{17, factors});
    CHECK(smith(hidden(std::vector<Integer>(18, 30), 18, 18, random)) == SmithForm{0, Torsion(18, 30)});
  }
}

// The first homology of the n-fold cyclic covers of the figure-eight knot's exterior, as t - 3 + 1/t presents it:
// Z/L + Z/L for odd n, with Lucas' number L of n, and Z/F + Z/5F for even n, with Fibonacci's number F (Plans; Rolfsen,
// "Knots and Links", 8.D for small n).
TEST_CASE("Covers of the figure-eight knot have Lucas' and Fibonacci's numbers", "[smith]") {
  Random random(8);
  for (const int n : {40, 41, 60, 61}) {
    CAPTURE(n);
    Dense circulant(n, std::vector<Integer>(n));
    for (int i = 0; i < n; ++i) {
      circulant[i][i] = -3;
      circulant[i][(i + 1) % n] += 1;
      circulant[i][(i + n - 1) % n] += 1;
    }
    Integer fibonacci = 0;
    Integer next = 1;
    for (int k = 0; k < n; ++k) fibonacci = std::exchange(next, Integer(fibonacci + next));
    const Integer lucas = 2 * next - fibonacci;
    const Torsion factors = n % 2 == 1 ? Torsion{lucas, lucas} : Torsion{fibonacci, 5 * fibonacci};
    CHECK(smith(circulant) == SmithForm{n - 2, factors});
    // The same, with its units hidden.
    for (int i = 0; i + 1 < n; ++i) {
      const Integer f = (Integer(random.below(1 << 30)) << 40) + 1;
      for (int j = 0; j < n; ++j) circulant[i][j] += f * circulant[i + 1][j];
    }
    CHECK(smith(circulant) == SmithForm{n - 2, factors});
  }
}
