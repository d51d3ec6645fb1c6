// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/cells.hpp"

#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;
using Place = std::array<int, 3>;

/// Where in its cube the point is by which a cube is found: near the middle, and hardly ever on a face of a
/// tetrahedron.
constexpr Point inside_cube{0.5 + 0.0173205080757, 0.5 - 0.0141421356237, 0.5 + 0.0223606797750};

/// Corners in the order of a hexahedron's.
constexpr std::array<Place, 8> corner_places{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

int corner_at(const Place& p) {
  return static_cast<int>(std::find(corner_places.begin(), corner_places.end(), p) - corner_places.begin());
}

Point point_at(const Place& place, const Point& within = {}) {
  return {place[0] + within[0], place[1] + within[1], place[2] + within[2]};
}

/// A cube, and the tetrahedron that has its point.
struct Cube {
  Place place{};
  int tet = 0;
  friend auto operator<=>(const Cube&, const Cube&) = default;
};

std::vector<Cube> cubes_in(const product::Solid& solid, const std::vector<Point>& image,
                           const ImageWalk& walk, const Progress& progress) {
  std::vector<Cube> result;
  int visits = 0;
  for (int t = 0; t < solid.size(); ++t) {
    Place low{};
    Place high{};
    for (std::size_t a = 0; a < 3; ++a) {
      double least = image[solid.corners(t)[0]][a];
      double most = least;
      for (const int v : solid.corners(t)) {
        least = std::min(least, image[v][a]);
        most = std::max(most, image[v][a]);
      }
      low[a] = static_cast<int>(std::ceil(least - inside_cube[a]));
      high[a] = static_cast<int>(std::floor(most - inside_cube[a]));
    }
    Place at{};
    for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
        for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
          if (++visits % 65536 == 0) progress.step("cubes", t / static_cast<double>(solid.size()));
          const Weights w = walk.weights(t, point_at(at, inside_cube));
          if (std::all_of(w.begin(), w.end(), [](double x) { return x >= 0; })) result.push_back({at, t});
        }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The point of the solid with these weights; those outside by rounding are brought back.
Point point_in(const product::Solid& solid, int tet, Weights weight) {
  constexpr double nothing = 1e-9; // points at vertices and on faces are exactly there
  double sum = 0;
  for (double& w : weight) {
    if (!(w > nothing)) w = 0;
    sum += w;
  }
  Point p{};
  for (std::size_t k = 0; k < 4; ++k) p = p + weight[k] / sum * solid.point(solid.corners(tet)[k]);
  return p;
}

/// Joins the corners of cubes that are neighbors across +axis: the parents of corner c of cube k, at 8 k + c.
std::vector<int> joined_corners(const std::vector<Cube>& cubes, const ImageWalk& walk, int& lost,
                                const Progress& progress) {
  std::map<Cube, int> number;
  for (std::size_t k = 0; k < cubes.size(); ++k) number.emplace(cubes[k], static_cast<int>(k));
  std::vector<int> parent(8 * cubes.size());
  for (std::size_t k = 0; k < parent.size(); ++k) parent[k] = static_cast<int>(k);
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    if (k % 1024 == 0) progress.step("cubes");
    for (std::size_t a = 0; a < 3; ++a) {
      Cube next = cubes[k];
      ++next.place[a];
      const WalkEnd end =
          walk.walk(cubes[k].tet, point_at(cubes[k].place, inside_cube), point_at(next.place, inside_cube));
      if (end.triangle >= 0) continue;
      next.tet = end.tet;
      const auto found = number.find(next);
      if (end.is_lost || found == number.end()) {
        ++lost;
        continue;
      }
      for (const Place& corner : corner_places) {
        if (corner[a] != 0) continue;
        Place across = corner;
        across[a] = 1;
        const int mine = static_cast<int>(8 * k) + corner_at(across);
        const int other = 8 * found->second + corner_at(corner);
        parent[find_root(parent, mine)] = find_root(parent, other);
      }
    }
  }
  return parent;
}

} // namespace

Cells cells(const product::Solid& solid, const std::vector<Point>& image, const Progress& progress) {
  const ImageWalk walk(solid, image);
  const std::vector<Cube> cubes = cubes_in(solid, image, walk, progress);
  Cells result;
  std::vector<int> parent = joined_corners(cubes, walk, result.lost, progress);
  std::vector<int> number(parent.size(), -1);
  result.mesh.hexahedra.reserve(cubes.size());
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    if (k % 1024 == 0) progress.step("cubes");
    product::Hexahedron& hexahedron = result.mesh.hexahedra.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) {
      int& point = number[find_root(parent, static_cast<int>(8 * k + c))];
      if (point < 0) {
        point = static_cast<int>(result.mesh.points.size());
        Place at = cubes[k].place;
        for (std::size_t a = 0; a < 3; ++a) at[a] += corner_places[c][a];
        const WalkEnd end = walk.walk(cubes[k].tet, point_at(cubes[k].place, inside_cube), point_at(at));
        if (end.is_lost) ++result.lost;
        result.mesh.points.push_back(point_in(solid, end.tet, end.weight));
        result.lattice.push_back(at);
      }
      hexahedron[c] = point;
    }
  }
  return result;
}

} // namespace tetrarch::polycube
