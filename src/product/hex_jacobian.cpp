// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hex_jacobian.hpp"

#include <algorithm>
#include <cstddef>

namespace tetrarch::product {
namespace {

using namespace numeric;

/// The edges along an axis, as pairs of corners; each at b + 2 c for the places b and c along the two axes
/// that follow, in turn.
using Edges = std::array<std::array<int, 2>, 4>;
constexpr std::array<Edges, 3> edges_along{{{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}},
                                            {{{0, 3}, {4, 7}, {1, 2}, {5, 6}}},
                                            {{{0, 4}, {1, 5}, {3, 7}, {2, 6}}}}};

std::size_t at(std::size_t i, std::size_t j, std::size_t k) {
  return i + 3 * j + 9 * k;
}

/// Halves along an axis, by the algorithm of de Casteljau.
std::array<JacobianCoefficients, 2> halves(const JacobianCoefficients& whole, std::size_t axis) {
  std::array<JacobianCoefficients, 2> result{whole, whole};
  const std::size_t step = axis == 0 ? 1 : axis == 1 ? 3 : 9;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    if (k / step % 3 != 0) continue;
    const double left = (whole[k] + whole[k + step]) / 2;
    const double right = (whole[k + step] + whole[k + 2 * step]) / 2;
    const double middle = (left + right) / 2;
    result[0][k + step] = left;
    result[0][k + 2 * step] = middle;
    result[1][k] = middle;
    result[1][k + step] = right;
  }
  return result;
}

bool has_bad_corner(const JacobianCoefficients& c) {
  for (std::size_t k = 0; k < 8; ++k)
    if (!(c[at(2 * (k & 1), 2 * (k >> 1 & 1), 2 * (k >> 2))] > 0)) return true;
  return false;
}

bool is_positive(const JacobianCoefficients& c, int cuts_left) {
  if (*std::min_element(c.begin(), c.end()) > 0) return true;
  if (has_bad_corner(c) || cuts_left == 0) return false;
  for (const JacobianCoefficients& x : halves(c, 0))
    for (const JacobianCoefficients& y : halves(x, 1))
      for (const JacobianCoefficients& z : halves(y, 2))
        if (!is_positive(z, cuts_left - 1)) return false;
  return true;
}

} // namespace

JacobianCoefficients jacobian_coefficients(const std::array<Point, 8>& corners) {
  std::array<std::array<Vector, 4>, 3> edge{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t k = 0; k < 4; ++k)
      edge[a][k] = corners[edges_along[a][k][1]] - corners[edges_along[a][k][0]];
  // Each derivative is linear in the two other variables: a product of two linear terms in one variable has
  // coefficients 0, 1 and 2, where both ways to the middle one count by half.
  JacobianCoefficients result{};
  for (std::size_t zx = 0; zx < 4; ++zx)     // of the derivative along y: the places along z and x
    for (std::size_t xy = 0; xy < 4; ++xy) { // along z: along x and y
      const Vector normal = cross(edge[1][zx], edge[2][xy]);
      const std::size_t i = (zx >> 1) + (xy & 1);
      for (std::size_t yz = 0; yz < 4; ++yz) {
        const std::size_t j = (xy >> 1) + (yz & 1);
        const std::size_t k = (yz >> 1) + (zx & 1);
        const double weight = (i == 1 ? 0.5 : 1) * (j == 1 ? 0.5 : 1) * (k == 1 ? 0.5 : 1);
        result[at(i, j, k)] += weight * dot(edge[0][yz], normal);
      }
    }
  return result;
}

bool is_positive_inside(const std::array<Point, 8>& corners) {
  constexpr int most_cuts = 5;
  return is_positive(jacobian_coefficients(corners), most_cuts);
}

} // namespace tetrarch::product
