// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::product {
namespace {

using namespace numeric;

/// Of each corner its three neighbours, so that they make a right-handed corner of a cube.
constexpr std::array<std::array<int, 3>, 8> neighbors{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// Opposite faces, those of greater coordinate first.
constexpr std::array<std::array<std::array<int, 4>, 2>, 3> opposite_faces{
    {{{{1, 2, 5, 6}, {0, 3, 4, 7}}}, {{{2, 3, 6, 7}, {0, 1, 4, 5}}}, {{{4, 5, 6, 7}, {0, 1, 2, 3}}}}};

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
    const auto& [x, y, z] = neighbors[c];
    least = std::min(
        least, scaled_determinant(corners[x] - corners[c], corners[y] - corners[c], corners[z] - corners[c]));
  }
  return least;
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
    if (j > 0) continue;
    Point center{};
    for (const Point& p : corners) center = center + 1.0 / 8 * p;
    q.bad.push_back({static_cast<int>(h), j, center});
  }
  if (!mesh.hexahedra.empty()) q.mean = total / static_cast<double>(mesh.hexahedra.size());
  return q;
}

} // namespace tetrarch::product
