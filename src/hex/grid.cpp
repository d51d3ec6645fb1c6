// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/grid.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tetrarch::hex {
namespace {

using namespace numeric;

/// Sample points of a cell along an axis.
constexpr int samples = 3;

std::vector<double> planes_between(double least, double most, double edge, std::vector<double> fixed,
                                   double apart) {
  fixed.push_back(least);
  fixed.push_back(most);
  std::sort(fixed.begin(), fixed.end());
  std::vector<double> kept;
  for (const double x : fixed)
    if (kept.empty() || x - kept.back() > apart * edge) kept.push_back(x);
  if (kept.size() < 2) kept = {least, std::max(most, least + edge)};
  std::vector<double> planes{kept.front()};
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    const int count = std::max(1, static_cast<int>(std::lround((kept[k + 1] - kept[k]) / edge)));
    for (int i = 1; i <= count; ++i)
      planes.push_back(i == count ? kept[k + 1] : kept[k] + i * (kept[k + 1] - kept[k]) / count);
  }
  return planes;
}

/// Where the sample points lie along an axis.
std::vector<double> sample_places(const std::vector<double>& plane) {
  std::vector<double> places;
  for (std::size_t k = 0; k + 1 < plane.size(); ++k)
    for (int i = 0; i < samples; ++i)
      places.push_back(plane[k] + (i + 0.5) / samples * (plane[k + 1] - plane[k]));
  return places;
}

/// Half spaces whose intersection is a tetrahedron, its faces included.
struct HalfSpaces {
  std::array<Vector, 4> normal{};
  std::array<double, 4> offset{};

  explicit HalfSpaces(const std::array<Point, 4>& p) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Point& a = p[(k + 1) % 4];
      Vector n = cross(p[(k + 2) % 4] - a, p[(k + 3) % 4] - a);
      if (dot(n, p[k] - a) < 0) n = -n;
      normal[k] = n;
      offset[k] = dot(n, a);
    }
  }
  bool contain(const Point& x) const {
    for (std::size_t k = 0; k < 4; ++k)
      if (dot(normal[k], x) < offset[k]) return false;
    return true;
  }
};

} // namespace

std::array<int, 3> Grid::cell(std::size_t index) const {
  const auto nx = static_cast<std::size_t>(cells(0));
  const auto ny = static_cast<std::size_t>(cells(1));
  return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny), static_cast<int>(index / nx / ny)};
}

Grid grid_around(const std::vector<Point>& points, double edge,
                 const std::array<std::vector<double>, 3>& fixed, double apart) {
  Grid grid;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto less = [a](const Point& p, const Point& q) { return p[a] < q[a]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    std::vector<double> planes = planes_between((*low)[a], (*high)[a], edge, fixed[a], apart);
    planes.insert(planes.begin(), planes.front() - edge);
    planes.push_back(planes.back() + edge);
    grid.plane[a] = std::move(planes);
  }
  return grid;
}

std::int64_t bytes_for(std::int64_t cells) {
  // A word of samples, a fraction, and what the choice takes.
  return 16 * cells;
}

std::vector<float> filled(const product::Solid& solid, const std::vector<Point>& image, const Grid& grid,
                          const Progress& progress) {
  std::array<std::vector<double>, 3> places;
  for (std::size_t a = 0; a < 3; ++a) places[a] = sample_places(grid.plane[a]);
  std::vector<std::uint32_t> inside(static_cast<std::size_t>(grid.size()));
  for (int t = 0; t < solid.size(); ++t) {
    if (t % 1024 == 0) progress.step("cells", t / static_cast<double>(solid.size()));
    std::array<Point, 4> p{};
    for (std::size_t k = 0; k < 4; ++k) p[k] = image[solid.corners(t)[k]];
    const HalfSpaces half_spaces(p);
    std::array<int, 3> first{};
    std::array<int, 3> last{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax({p[0][a], p[1][a], p[2][a], p[3][a]});
      const auto begin = places[a].begin();
      first[a] = static_cast<int>(std::lower_bound(begin, places[a].end(), low) - begin);
      last[a] = static_cast<int>(std::upper_bound(begin, places[a].end(), high) - begin);
    }
    for (int z = first[2]; z < last[2]; ++z)
      for (int y = first[1]; y < last[1]; ++y)
        for (int x = first[0]; x < last[0]; ++x)
          if (half_spaces.contain({places[0][x], places[1][y], places[2][z]}))
            inside[grid.index(x / samples, y / samples, z / samples)] |=
                1U << ((z % samples * samples + y % samples) * samples + x % samples);
  }
  std::vector<float> result;
  result.reserve(inside.size());
  constexpr float all = samples * samples * samples;
  for (const std::uint32_t word : inside) result.push_back(static_cast<float>(std::popcount(word)) / all);
  return result;
}

SizedHexahedra cells_of(const Grid& grid, const std::vector<char>& chosen) {
  SizedHexahedra result;
  const int nx = grid.cells(0) + 1;
  const int ny = grid.cells(1) + 1;
  const int nz = grid.cells(2) + 1;
  std::vector<int> number(static_cast<std::size_t>(nx) * ny * nz, -1);
  const auto node = [&](int x, int y, int z) {
    int& n = number[(static_cast<std::size_t>(z) * ny + y) * nx + x];
    if (n < 0) {
      n = static_cast<int>(result.mesh.points.size());
      result.mesh.points.push_back({grid.plane[0][x], grid.plane[1][y], grid.plane[2][z]});
    }
    return n;
  };
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k] == 0) continue;
    const auto [x, y, z] = grid.cell(k);
    result.mesh.hexahedra.push_back({node(x, y, z), node(x + 1, y, z), node(x + 1, y + 1, z),
                                     node(x, y + 1, z), node(x, y, z + 1), node(x + 1, y, z + 1),
                                     node(x + 1, y + 1, z + 1), node(x, y + 1, z + 1)});
    result.lengths.push_back({grid.plane[0][x + 1] - grid.plane[0][x],
                              grid.plane[1][y + 1] - grid.plane[1][y],
                              grid.plane[2][z + 1] - grid.plane[2][z]});
  }
  return result;
}

} // namespace tetrarch::hex
