// SPDX-License-Identifier: GPL-2.0-or-later
#include "levels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tetrarch::product {
namespace {

using surface::Side;

/// A crossing nearer than this part of the edge to one of its ends is at that end.
constexpr double snap = 0.2;

bool crosses(double a, double b, double level) {
  return (a < level && b > level) || (a > level && b < level);
}

/// Corners near the level are put on it, in all triangles of the vertex that have the same value there.
void snap_to(const Solid& solid, CornerValues& values, double level) {
  std::map<std::pair<int, double>, bool> near; // by vertex and value
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) {
        const double here = values[t][c];
        const double there = values[t][d];
        if (crosses(here, there, level) && (level - here) / (there - here) < snap)
          near[{solid.corner(t, c), here}] = true;
      }
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      if (near.contains({solid.corner(t, c), values[t][c]})) values[t][c] = level;
}

} // namespace

Levelled split_at_level(const Solid& solid, CornerValues values, double level) {
  snap_to(solid, values, level);
  std::vector<solid::EdgePoint> splits;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t)) {
      const int from = solid.corner(t, s.next().corner());
      const int to = solid.corner(t, s.previous().corner());
      const double a = values[t][s.next().corner()];
      const double b = values[t][s.previous().corner()];
      if (from < to && crosses(a, b, level)) splits.push_back({from, to, (level - a) / (b - a)});
    }
  const int old_points = static_cast<int>(solid.mesh.points.size());
  solid::SplitTets split = solid::split_edges(solid.mesh, splits);
  Levelled result{product::solid_of(std::move(split.mesh)), {}, std::move(splits)};
  result.values.reserve(result.solid.face.size());
  for (int t = 0; t < result.solid.boundary.triangle_count(); ++t) {
    const TetFace face = result.solid.face[t];
    const int from = solid.outside[4 * split.origin[face.tet] + split.face_of[4 * face.tet + face.face]];
    std::array<double, 3> value{level, level, level};
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d)
        if (result.solid.corner(t, c) < old_points && result.solid.corner(t, c) == solid.corner(from, d))
          value[c] = values[from][d];
    result.values.push_back(value);
  }
  return result;
}

} // namespace tetrarch::product
