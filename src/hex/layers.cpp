// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/layers.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using product::Hexahedron;
using product::outward_sides;

/// Two sides on the same four points, or one alone.
struct Square {
  std::array<int, 4> sorted{};
  SurfaceSquare at;
};

std::vector<Square> squares_of(const product::HexMesh& mesh) {
  std::vector<Square> all;
  all.reserve(6 * mesh.hexahedra.size());
  for (int h = 0; h < static_cast<int>(mesh.hexahedra.size()); ++h)
    for (int side = 0; side < 6; ++side) {
      Square square{{}, {h, side}};
      for (std::size_t k = 0; k < 4; ++k) square.sorted[k] = mesh.hexahedra[h][outward_sides[side][k]];
      std::sort(square.sorted.begin(), square.sorted.end());
      all.push_back(square);
    }
  std::sort(all.begin(), all.end(), [](const Square& a, const Square& b) {
    return std::pair(a.sorted, std::pair(a.at.hexahedron, a.at.side)) <
           std::pair(b.sorted, std::pair(b.at.hexahedron, b.at.side));
  });
  return all;
}

bool by_place(const SurfaceSquare& a, const SurfaceSquare& b) {
  return std::pair(a.hexahedron, a.side) < std::pair(b.hexahedron, b.side);
}

/// The axis along which a hexahedron's corners i and j, the ends of an edge, lie.
std::size_t axis_between(int i, int j) {
  constexpr std::array<std::array<int, 3>, 8> place{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  for (std::size_t a = 0; a < 3; ++a)
    if (place[i][a] != place[j][a]) return a;
  return 0;
}

/// How far new points go into what shrinks.
constexpr double inward = 0.25;

} // namespace

std::vector<SurfaceSquare> surface_of(const product::HexMesh& mesh) {
  const std::vector<Square> all = squares_of(mesh);
  std::vector<SurfaceSquare> result;
  for (std::size_t k = 0; k < all.size(); ++k)
    if ((k == 0 || all[k - 1].sorted != all[k].sorted) &&
        (k + 1 == all.size() || all[k + 1].sorted != all[k].sorted))
      result.push_back(all[k].at);
  std::sort(result.begin(), result.end(), by_place);
  return result;
}

std::vector<int> add_layer(SizedHexahedra& hexahedra, const std::vector<char>& shrinks,
                           const std::vector<char>& stays, double thickness) {
  product::HexMesh& mesh = hexahedra.mesh;
  const std::vector<Square> all = squares_of(mesh);
  std::vector<SurfaceSquare> gap;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SurfaceSquare& at = all[k].at;
    if (shrinks[at.hexahedron] == 0) continue;
    int beyond = -1;
    if (k > 0 && all[k - 1].sorted == all[k].sorted) beyond = all[k - 1].at.hexahedron;
    if (k + 1 < all.size() && all[k + 1].sorted == all[k].sorted) beyond = all[k + 1].at.hexahedron;
    if (beyond >= 0 ? shrinks[beyond] == 0 : stays[6 * at.hexahedron + at.side] == 0) gap.push_back(at);
  }
  std::sort(gap.begin(), gap.end(), by_place);

  std::vector<int> inner(mesh.points.size(), -1);
  std::vector<int> origin;
  for (const SurfaceSquare& s : gap)
    for (const int c : outward_sides[s.side]) {
      const int v = mesh.hexahedra[s.hexahedron][c];
      if (inner[v] >= 0) continue;
      inner[v] = static_cast<int>(mesh.points.size() + origin.size());
      origin.push_back(v);
    }
  // New points go towards the middle of what shrinks around them.
  std::vector<Vector> sum(inner.size(), Vector{});
  std::vector<int> count(inner.size());
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (shrinks[h] == 0) continue;
    Point middle{};
    for (const Point& p : mesh.corners(h)) middle = middle + 1.0 / 8 * p;
    for (const int v : mesh.hexahedra[h]) {
      sum[v] = sum[v] + middle;
      ++count[v];
    }
  }
  for (const int v : origin)
    mesh.points.push_back(mesh.points[v] + inward * (1.0 / count[v] * sum[v] - mesh.points[v]));
  std::vector<Hexahedron> layer;
  for (const SurfaceSquare& s : gap) {
    const Hexahedron& h = mesh.hexahedra[s.hexahedron];
    const auto& side = outward_sides[s.side];
    Hexahedron cell{};
    for (std::size_t k = 0; k < 4; ++k) {
      cell[k] = inner[h[side[k]]];
      cell[k + 4] = h[side[k]];
    }
    layer.push_back(cell);
    const Lengths& length = hexahedra.lengths[s.hexahedron];
    hexahedra.lengths.push_back(
        {length[axis_between(side[0], side[1])], length[axis_between(side[0], side[3])], thickness});
  }
  for (std::size_t h = 0; h < shrinks.size(); ++h)
    if (shrinks[h] != 0)
      for (int& v : mesh.hexahedra[h])
        if (inner[v] >= 0) v = inner[v];
  mesh.hexahedra.insert(mesh.hexahedra.end(), layer.begin(), layer.end());
  return origin;
}

} // namespace tetrarch::hex
