// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/polycube.hpp"

#include "polycube_sheets.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using LatticePoint = std::array<int, 3>;

constexpr double most_cubes = 1e8;

/// Which cubes of a box are filled.
class Box {
public:
  Box(const LatticePoint& low, const LatticePoint& high) : low_(low) {
    double volume = 1;
    for (int a = 0; a < 3; ++a) {
      size_[a] = high[a] - low[a];
      volume *= size_[a];
    }
    if (volume > most_cubes) throw InputError("the polycube would have too many cubes");
    filled_.assign(static_cast<std::size_t>(volume), 0);
  }
  const LatticePoint& low() const { return low_; }
  int high(int axis) const { return low_[axis] + size_[axis]; }
  void fill(const LatticePoint& cube) { filled_[index(cube)] = 1; }
  bool is_filled(const LatticePoint& cube) const {
    for (int a = 0; a < 3; ++a)
      if (cube[a] < low_[a] || cube[a] >= high(a)) return false;
    return filled_[index(cube)] != 0;
  }
  std::vector<LatticePoint> cubes() const {
    std::vector<LatticePoint> result;
    LatticePoint at{};
    for (at[0] = low_[0]; at[0] < high(0); ++at[0])
      for (at[1] = low_[1]; at[1] < high(1); ++at[1])
        for (at[2] = low_[2]; at[2] < high(2); ++at[2])
          if (is_filled(at)) result.push_back(at);
    return result;
  }

private:
  std::size_t index(const LatticePoint& cube) const {
    return (static_cast<std::size_t>(cube[0] - low_[0]) * size_[1] + (cube[1] - low_[1])) * size_[2] +
           (cube[2] - low_[2]);
  }
  LatticePoint low_;
  LatticePoint size_{};
  std::vector<char> filled_;
};

Box bounding_box(const std::vector<Facing>& facing) {
  constexpr int most = std::numeric_limits<int>::max();
  LatticePoint low{most, most, most};
  LatticePoint high{-most, -most, -most};
  for (const Facing& f : facing) {
    low[f.axis] = std::min(low[f.axis], f.plane);
    high[f.axis] = std::max(high[f.axis], f.plane);
  }
  for (int a = 0; a < 3; ++a)
    if (!(low[a] < high[a]))
      throw InputError("the image of the boundary is no surface of a polycube: it is flat");
  return {low, high};
}

/// From below, each column goes in at sheets that face down and out at those that face up.
void fill_column(Box& box, const Sheets& sheets, int x, int y) {
  int depth = 0;
  for (int z = box.low()[2]; z <= box.high(2); ++z) {
    for (const bool up : {true, false}) {
      const auto sheet = sheets.find({2, z, up});
      if (sheet == sheets.end()) continue;
      const auto middle = flat(sheet->first, {x + 0.5, y + 0.5, 0});
      if (sheet->second.locator.inside(middle).triangle >= 0) depth += up ? -1 : 1;
    }
    if (depth < 0 || depth > 1 || (depth == 1 && z == box.high(2)))
      throw InputError("the image of the boundary is no surface of a polycube seen from outside: above x = " +
                       std::to_string(x) + ".5, y = " + std::to_string(y) + ".5 at z = " + std::to_string(z) +
                       " (in lattice steps) the inside is " + std::to_string(depth) + " times inside");
    if (depth == 1) box.fill({x, y, z});
  }
}

LatticePoint cube_beyond(LatticePoint cube, int axis, int by) {
  cube[axis] += by;
  return cube;
}

/// Each triangle is to cover faces of the filled cubes, and all are to be covered just once.
void require_cover(const Box& box, const Sheets& sheets, const surface::Surface& boundary,
                   const std::vector<Point>& image) {
  std::map<Facing, double> faces;
  for (const LatticePoint& cube : box.cubes())
    for (int axis = 0; axis < 3; ++axis)
      for (const bool up : {false, true})
        if (!box.is_filled(cube_beyond(cube, axis, up ? 1 : -1)))
          faces[{axis, cube[axis] + (up ? 1 : 0), up}] += 1;
  for (const auto& [facing, sheet] : sheets) {
    for (const int t : sheet.triangles) {
      LatticePoint cube{};
      for (int a = 0; a < 3; ++a) {
        double middle = 0;
        for (const int v : boundary.corners(t)) middle += image[v][a] / 3;
        cube[a] = static_cast<int>(std::floor(middle));
      }
      cube[facing.axis] = facing.plane - (facing.up ? 1 : 0);
      if (box.is_filled(cube) && !box.is_filled(cube_beyond(cube, facing.axis, facing.up ? 1 : -1))) continue;
      throw InputError("triangle " + std::to_string(t) +
                       " of the boundary (counted from 0) is inverted on the polycube, or overlaps others");
    }
  }
  constexpr double rounding = 1e-3; // far below one face, far above the snapping of vertices
  for (const auto& [facing, count] : faces) {
    const auto sheet = sheets.find(facing);
    const double area = sheet == sheets.end() ? 0 : sheet->second.locator.area();
    if (std::abs(area - count) > rounding * count)
      throw InputError("the image of the boundary covers " + std::to_string(area) + " squares instead of " +
                       std::to_string(std::lround(count)) + " where coordinate " +
                       std::to_string(facing.axis) + " is " + std::to_string(facing.plane) +
                       " (steps of the lattice)");
  }
}

/// Corners of a cube in the order of a hexahedron's.
constexpr std::array<LatticePoint, 8> cube_corners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// The ways from corner 0 to corner 6 along the three axes: paths that are positively handed tetrahedra.
constexpr std::array<std::array<int, 4>, 6> tetrahedra_of_cube{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};

} // namespace

Polycube filled_polycube(const surface::Surface& boundary, const std::vector<Point>& image, double step,
                         int cells) {
  if (cells < 1) throw PreconditionError("a step of the polycube's lattice needs at least one cell");
  const std::vector<Point> at = snapped(boundary, image, step);
  const std::vector<Facing> facing = facings(boundary, at);
  const Sheets all = sheets(boundary, at, facing);
  Box box = bounding_box(facing);
  for (int x = box.low()[0]; x < box.high(0); ++x)
    for (int y = box.low()[1]; y < box.high(1); ++y) fill_column(box, all, x, y);
  require_cover(box, all, boundary, at);

  const std::vector<LatticePoint> large = box.cubes();
  Polycube result;
  result.edge = step / cells;
  if (static_cast<double>(large.size()) * std::pow(cells, 3) > most_cubes)
    throw InputError("the polycube would have too many cubes");
  for (const LatticePoint& cube : large)
    for (int x = 0; x < cells; ++x)
      for (int y = 0; y < cells; ++y)
        for (int z = 0; z < cells; ++z)
          result.cubes.push_back({cells * cube[0] + x, cells * cube[1] + y, cells * cube[2] + z});
  std::sort(result.cubes.begin(), result.cubes.end());
  return result;
}

HexMesh hexahedra(const Polycube& polycube) {
  HexMesh mesh;
  std::map<LatticePoint, int> number;
  mesh.hexahedra.reserve(polycube.cubes.size());
  for (const LatticePoint& cube : polycube.cubes) {
    Hexahedron& hexahedron = mesh.hexahedra.emplace_back();
    for (int c = 0; c < 8; ++c) {
      LatticePoint p = cube;
      for (int a = 0; a < 3; ++a) p[a] += cube_corners[c][a];
      const auto [found, is_new] = number.try_emplace(p, static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back({polycube.edge * p[0], polycube.edge * p[1], polycube.edge * p[2]});
      hexahedron[c] = found->second;
    }
  }
  return mesh;
}

solid::TetMesh tetrahedra(const Polycube& polycube) {
  HexMesh cubes = hexahedra(polycube);
  format::Soup soup;
  soup.points = std::move(cubes.points);
  soup.tetrahedra.reserve(6 * cubes.hexahedra.size());
  for (const Hexahedron& h : cubes.hexahedra)
    for (const auto& [a, b, c, d] : tetrahedra_of_cube) soup.tetrahedra.push_back({h[a], h[b], h[c], h[d]});
  return doctor::build(std::move(soup));
}

} // namespace tetrarch::product
