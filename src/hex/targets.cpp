// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/targets.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/hex/deviation.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using Triangles = std::vector<std::array<Point, 3>>;

} // namespace

Targets::Targets(const product::Solid& solid, Features features)
    : features_(std::move(features)), whole_(boundary_triangles(solid)) {
  std::vector<Triangles> parts(static_cast<std::size_t>(features_.patches));
  for (int t = 0; t < whole_.size(); ++t) parts[patch_of(t)].push_back(whole_.corners(t));
  for (Triangles& part : parts) patches_.emplace_back(std::move(part));
  for (const Ridge& ridge : features_.ridges) {
    Triangles segments;
    std::vector<Point> line{solid.point(ridge.vertices.front())};
    for (std::size_t k = 1; k < ridge.vertices.size(); ++k) {
      line.push_back(solid.point(ridge.vertices[k]));
      segments.push_back({line[k - 1], line[k], line[k]});
    }
    ridges_.emplace_back(std::move(segments));
    lines_.push_back(std::move(line));
  }
  for (const int v : features_.corners) corners_.push_back(solid.point(v));
}

std::vector<Point> Targets::ridge(int k) const {
  return lines_[static_cast<std::size_t>(k)];
}

Place Targets::place(const Home& home, const Point& p, const Vector* facing) const {
  const auto on = [&](const NearestTriangle& part, const Vector* facing_it) {
    const Foot foot = part.nearest(p, facing_it);
    return Place{foot.at, foot.distance, part.normal(foot.triangle)};
  };
  switch (home.kind) {
  case Home::Kind::inside:
    break;
  case Home::Kind::surface:
    return on(whole_, facing);
  case Home::Kind::patch:
    return on(patches_[home.index], facing);
  case Home::Kind::ridge: {
    const NearestTriangle& ridge = ridges_[home.index];
    const Foot foot = ridge.nearest(p);
    const auto& segment = ridge.corners(foot.triangle);
    return {foot.at, foot.distance, direction(segment[1] - segment[0]).value_or(Vector{})};
  }
  case Home::Kind::corner:
    return {corner(home.index), distance(corner(home.index), p), {}};
  }
  throw PreconditionError("a point inside has no place on the surface");
}

} // namespace tetrarch::hex
