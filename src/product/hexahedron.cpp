// SPDX-License-Identifier: GPL-2.0-or-later
#include "hexahedron.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::product {

std::vector<std::array<int, 4>> surface_squares(const HexMesh& mesh) {
  using Square = std::array<int, 4>;
  std::vector<std::pair<Square, Square>> all; // sorted, and in order
  for (const Hexahedron& h : mesh.hexahedra)
    for (const auto& side : outward_sides) {
      const Square square{h[side[0]], h[side[1]], h[side[2]], h[side[3]]};
      Square sorted = square;
      std::sort(sorted.begin(), sorted.end());
      all.emplace_back(sorted, square);
    }
  std::sort(all.begin(), all.end());
  std::vector<Square> result;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_inside = (k > 0 && all[k - 1].first == all[k].first) ||
                           (k + 1 < all.size() && all[k + 1].first == all[k].first);
    if (!is_inside) result.push_back(all[k].second);
  }
  return result;
}

void add_whole_cubes(PolycubeHexahedra& result, const std::vector<int>& number) {
  for (std::size_t h = 0; h < result.cubes.hexahedra.size(); ++h) {
    Hexahedron hexahedron = result.cubes.hexahedra[h];
    for (int& v : hexahedron) v = number[v];
    if (std::count(hexahedron.begin(), hexahedron.end(), -1) > 0) {
      ++result.solid.left_out;
      continue;
    }
    result.solid.mesh.hexahedra.push_back(hexahedron);
    result.cube.push_back(static_cast<int>(h));
  }
}

} // namespace tetrarch::product
