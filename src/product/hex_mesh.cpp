// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hex_mesh.hpp"

#include "hexahedron.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/hex_jacobian.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

/// The edges along each axis, from the lesser to the greater coordinate.
constexpr std::array<std::array<std::array<int, 2>, 4>, 3> edge_ends{{{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}},
                                                                      {{{0, 3}, {1, 2}, {4, 7}, {5, 6}}},
                                                                      {{{0, 4}, {1, 5}, {3, 7}, {2, 6}}}}};
/// Of each corner the edge there along each axis.
constexpr std::array<std::array<int, 3>, 8> edges_at_corners{
    {{0, 0, 0}, {0, 1, 1}, {1, 1, 3}, {1, 0, 2}, {2, 2, 0}, {2, 3, 1}, {3, 3, 3}, {3, 2, 2}}};

Point middle(const std::array<Point, 8>& corners) {
  Point center{};
  for (const Point& p : corners) center = center + 1.0 / 8 * p;
  return center;
}

double scaled_determinant(double determinant, double lengths) {
  return lengths > 0 ? std::clamp(determinant / lengths, -1.0, 1.0) : 0.0;
}

} // namespace

std::array<Point, 8> HexMesh::corners(std::size_t hexahedron) const {
  std::array<Point, 8> result;
  for (std::size_t c = 0; c < 8; ++c) result[c] = points[hexahedra[hexahedron][c]];
  return result;
}

double sampled_jacobian(const std::array<Point, 8>& corners) {
  std::array<std::array<Vector, 4>, 3> edge{};
  std::array<std::array<double, 4>, 3> length{};
  std::array<Vector, 3> axis{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t k = 0; k < 4; ++k) {
      edge[a][k] = corners[edge_ends[a][k][1]] - corners[edge_ends[a][k][0]];
      length[a][k] = norm(edge[a][k]);
      axis[a] = axis[a] + edge[a][k];
    }
  double least = scaled_determinant(dot(axis[0], cross(axis[1], axis[2])),
                                    norm(axis[0]) * norm(axis[1]) * norm(axis[2]));
  for (const auto& [x, y, z] : edges_at_corners)
    least = std::min(least, scaled_determinant(dot(edge[0][x], cross(edge[1][y], edge[2][z])),
                                               length[0][x] * length[1][y] * length[2][z]));
  return least;
}

double scaled_jacobian(const std::array<Point, 8>& corners) {
  const double least = sampled_jacobian(corners);
  return least > 0 && !is_positive_inside(corners) ? 0 : least;
}

double volume(const std::array<Point, 8>& corners) {
  // From a corner, so that cells of round coordinates have exact volumes wherever they are.
  double twelve = 0;
  for (const auto& side : outward_sides)
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector a = corners[side[k]] - corners[0];
      const Vector b = corners[side[(k + 1) % 4]] - corners[0];
      const Vector c = corners[side[(k + 2) % 4]] - corners[0];
      twelve += dot(a, cross(b, c));
    }
  return twelve / 12;
}

double volume(const HexMesh& mesh) {
  double sum = 0;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) sum += volume(mesh.corners(h));
  return sum;
}

bool is_better(const HexQuality& a, const HexQuality& b) {
  if (a.bad.size() != b.bad.size()) return a.bad.size() < b.bad.size();
  if (a.minimum != b.minimum) return a.minimum > b.minimum;
  return a.mean > b.mean;
}

HexQuality quality(const HexMesh& mesh) {
  HexQuality q;
  q.scaled_jacobian.reserve(mesh.hexahedra.size());
  double total = 0;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    const std::array<Point, 8> corners = mesh.corners(h);
    const double j = scaled_jacobian(corners);
    q.scaled_jacobian.push_back(j);
    q.minimum = std::min(q.minimum, j);
    total += j;
    ++q.histogram[static_cast<std::size_t>(std::clamp(std::floor(10 * j) + 10, 0.0, 19.0))];
    if (!(j > 0)) q.bad.push_back({static_cast<int>(h), j, middle(corners)});
  }
  std::vector<int> order(mesh.hexahedra.size());
  std::iota(order.begin(), order.end(), 0);
  const auto named = order.begin() + static_cast<std::ptrdiff_t>(std::min(worst_named, order.size()));
  std::partial_sort(order.begin(), named, order.end(), [&](int g, int h) {
    return std::pair(q.scaled_jacobian[g], g) < std::pair(q.scaled_jacobian[h], h);
  });
  for (auto h = order.begin(); h != named; ++h)
    q.worst.push_back({*h, q.scaled_jacobian[*h], middle(mesh.corners(*h))});
  if (!mesh.hexahedra.empty()) q.mean = total / static_cast<double>(mesh.hexahedra.size());
  return q;
}

} // namespace tetrarch::product
