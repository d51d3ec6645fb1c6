// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/matrix4.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::numeric;

namespace {

/// Leibniz' sum over all 24 permutations: the second route.
long leibniz(const Matrix4<long>& m) {
  long sum = 0;
  for (int r = 0; r < Perm4::count; ++r) {
    const Perm4 p = Perm4::from_rank(r);
    sum += p.sign() * m[0][p[0]] * m[1][p[1]] * m[2][p[2]] * m[3][p[3]];
  }
  return sum;
}

} // namespace

TEST_CASE("m times its adjugate is det(m), exactly over the integers", "[matrix4]") {
  support::Random random(4);
  for (int round = 0; round < 200; ++round) {
    Matrix4<long> m{};
    for (auto& row : m)
      for (long& x : row) x = random.below(41) - 20;
    const long det = determinant(m);
    CHECK(det == leibniz(m));
    const Matrix4<long> a = adjugate(m);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        long left = 0;
        long right = 0;
        for (int k = 0; k < 4; ++k) {
          left += m[i][k] * a[k][j];
          right += a[i][k] * m[k][j];
        }
        CHECK(left == (i == j ? det : 0));
        CHECK(right == (i == j ? det : 0));
      }
  }
}
