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

/// Opposite faces, those of greater coordinate first.
constexpr std::array<std::array<std::array<int, 4>, 2>, 3> opposite_faces{
    {{{{1, 2, 5, 6}, {0, 3, 4, 7}}}, {{{2, 3, 6, 7}, {0, 1, 4, 5}}}, {{{4, 5, 6, 7}, {0, 1, 2, 3}}}}};

Point middle(const std::array<Point, 8>& corners) {
  Point center{};
  for (const Point& p : corners) center = center + 1.0 / 8 * p;
  return center;
}

double scaled_determinant(const Vector& a, const Vector& b, const Vector& c) {
  const double lengths = norm(a) * norm(b) * norm(c);
  return lengths > 0 ? std::clamp(dot(a, cross(b, c)) / lengths, -1.0, 1.0) : 0.0;
}

} // namespace

std::array<Point, 8> HexMesh::corners(std::size_t hexahedron) const {
  std::array<Point, 8> result;
  for (std::size_t c = 0; c < 8; ++c) result[c] = points[hexahedra[hexahedron][c]];
  return result;
}

double scaled_jacobian(const std::array<Point, 8>& corners) {
  std::array<Vector, 3> axis{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t c = 0; c < 4; ++c)
      axis[a] = axis[a] + (corners[opposite_faces[a][0][c]] - corners[opposite_faces[a][1][c]]);
  double least = scaled_determinant(axis[0], axis[1], axis[2]);
  for (std::size_t c = 0; c < 8; ++c) {
    const auto& [x, y, z] = corner_neighbors[c];
    least = std::min(
        least, scaled_determinant(corners[x] - corners[c], corners[y] - corners[c], corners[z] - corners[c]));
  }
  if (least > 0 && !is_positive_inside(corners)) return 0;
  return least;
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
