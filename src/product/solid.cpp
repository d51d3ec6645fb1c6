// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/solid.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

/// Squares of volumes have to fit into a double.
void require_size(const solid::TetMesh& mesh) {
  constexpr double least = 1e-50;
  constexpr double greatest = 1e50;
  double size = 0; // along the axis of the greatest extent
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(mesh.points.begin(), mesh.points.end(),
                            [axis](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    if (low != mesh.points.end()) size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  if (mesh.points.empty() || (size > least && size < greatest)) return;
  std::ostringstream text;
  text << "the solid is " << std::setprecision(3) << size
       << " across; sizes between 1e-50 and 1e50 can be computed with: choose another unit";
  throw InputError(text.str());
}

void require_volumes(const solid::TetMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& v = mesh.tetrahedra[t];
    const numeric::Sign sign =
        numeric::volume_sign(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
    if (sign == numeric::Sign::positive) continue;
    throw InputError("tetrahedron " + std::to_string(t) + " (counted from 0) " +
                     (sign == numeric::Sign::negative ? "is inverted: its volume is negative"
                                                      : "is flat: its volume is 0"));
  }
}

/// The outer faces as a surface with vertices of its own.
void add_boundary(Solid& solid) {
  solid.on_boundary.assign(solid.mesh.points.size(), -1);
  solid.outside.assign(4 * solid.mesh.tetrahedra.size(), -1);
  std::vector<surface::Surface::Triangle> triangles;
  for (int t = 0; t < solid.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      if (!solid.gluings.is_boundary({t, f})) continue;
      solid.outside[4 * t + f] = static_cast<int>(triangles.size());
      solid.face.push_back({t, f});
      const OrientedTetFace seen = outward({t, f});
      surface::Surface::Triangle triangle{solid.corners(t)[seen.a], solid.corners(t)[seen.b],
                                          solid.corners(t)[seen.c]};
      for (int& v : triangle) {
        int& number = solid.on_boundary[v];
        if (number < 0) {
          number = static_cast<int>(solid.vertex.size());
          solid.vertex.push_back(v);
        }
        v = number;
      }
      triangles.push_back(triangle);
    }
  solid.boundary = surface::Surface(static_cast<int>(solid.vertex.size()), std::move(triangles));
}

} // namespace

Solid solid_of(solid::TetMesh mesh) {
  require_size(mesh);
  require_volumes(mesh);
  Solid result;
  result.gluings = solid::triangulation_of(mesh);
  result.mesh = std::move(mesh);
  if (const int pieces = components(result.gluings).count; pieces != 1)
    throw InputError("the solid falls apart into " + std::to_string(pieces) + " pieces; expected one");
  add_boundary(result);
  if (const int surfaces = surface::parts(result.boundary).count; surfaces != 1)
    throw InputError("the boundary of the solid has " + std::to_string(surfaces) +
                     " components; a handlebody has one");
  return result;
}

double volume(const Solid& solid) {
  using namespace numeric;
  double six = 0;
  for (const auto& v : solid.mesh.tetrahedra) {
    const Point& p = solid.point(v[0]);
    six += dot(solid.point(v[1]) - p, cross(solid.point(v[2]) - p, solid.point(v[3]) - p));
  }
  return six / 6;
}

int genus(const Solid& solid) {
  return surface::type_of(solid.boundary).genus();
}

} // namespace tetrarch::product
