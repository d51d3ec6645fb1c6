// SPDX-License-Identifier: GPL-2.0-or-later
#include "polycube_sheets.hpp"

#include "tetrarch/core/error.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using Corners = std::array<Point, 3>;

/// In steps of the lattice: what is nearer to a plane lies in it. Polycube maps are written with 6 digits or
/// more.
constexpr double near_plane = 1e-5;
/// A coordinate so great is none of a polycube, and its cubes could not be counted.
constexpr double greatest_coordinate = 1e6;

std::string text(const Point& p) {
  std::string result = "(";
  for (std::size_t c = 0; c < 3; ++c) result += (c > 0 ? ", " : "") + std::to_string(p[c]);
  return result + ")";
}

std::string text(const Corners& p) {
  return text(p[0]) + ", " + text(p[1]) + ", " + text(p[2]);
}

Corners corners_of(const surface::Surface& boundary, const std::vector<Point>& image, int triangle) {
  const auto& v = boundary.corners(triangle);
  return {image[v[0]], image[v[1]], image[v[2]]};
}

double twice_area(const Facing& facing, const Corners& p) {
  return numeric::twice_area({flat(facing, p[0]), flat(facing, p[1]), flat(facing, p[2])});
}

} // namespace

std::complex<double> flat(const Facing& facing, const Point& p) {
  const double next = p[(facing.axis + 1) % 3];
  const double last = p[(facing.axis + 2) % 3];
  return facing.up ? std::complex{next, last} : std::complex{last, next};
}

std::vector<Point> snapped(const surface::Surface& boundary, const std::vector<Point>& image, double step) {
  if (static_cast<int>(image.size()) != boundary.vertex_count())
    throw PreconditionError("a polycube map needs one image for each vertex of the boundary");
  if (!(step > 0)) throw PreconditionError("the step of the polycube's lattice must be positive");
  std::vector<Point> result = image;
  for (std::size_t v = 0; v < result.size(); ++v)
    for (double& x : result[v]) {
      x /= step;
      if (!(std::abs(x) <= greatest_coordinate))
        throw InputError(
            "the image of vertex " + std::to_string(v) +
            " of the boundary (counted from 0) is not finite or too far from 0: " + text(image[v]));
      if (std::abs(x - std::round(x)) < near_plane) x = std::round(x);
    }
  return result;
}

std::vector<Facing> facings(const surface::Surface& boundary, const std::vector<Point>& image) {
  std::vector<Facing> result;
  result.reserve(static_cast<std::size_t>(boundary.triangle_count()));
  for (int t = 0; t < boundary.triangle_count(); ++t) {
    const Corners p = corners_of(boundary, image, t);
    bool is_in_plane = false;
    Facing found;
    double area = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[0][axis] != std::round(p[0][axis]) || p[1][axis] != p[0][axis] || p[2][axis] != p[0][axis])
        continue;
      is_in_plane = true;
      const double twice = twice_area({axis, 0, true}, p);
      if (std::abs(twice) <= std::abs(area)) continue;
      area = twice;
      found = {axis, static_cast<int>(p[0][axis]), twice > 0};
    }
    if (area == 0)
      throw InputError("triangle " + std::to_string(t) + " of the boundary (counted from 0) " +
                       (is_in_plane ? "has no area on the polycube, in lattice steps: "
                                    : "lies in no plane of the lattice, in lattice steps: ") +
                       text(p));
    result.push_back(found);
  }
  return result;
}

Sheets sheets(const surface::Surface& boundary, const std::vector<Point>& image,
              const std::vector<Facing>& facing, const std::vector<char>& wanted) {
  Sheets result;
  std::map<Facing, std::vector<numeric::FlatTriangle>> corners;
  for (int t = 0; t < boundary.triangle_count(); ++t) {
    if (!wanted.empty() && wanted[t] == 0) continue;
    const Corners p = corners_of(boundary, image, t);
    result[facing[t]].triangles.push_back(t);
    corners[facing[t]].push_back({flat(facing[t], p[0]), flat(facing[t], p[1]), flat(facing[t], p[2])});
  }
  for (auto& [which, sheet] : result) sheet.locator = numeric::FlatLocator(std::move(corners[which]));
  return result;
}

OnSurface located(const Sheets& sheets, const Point& p) {
  OnSurface best;
  best.outside = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    for (const bool up : {false, true}) {
      const double plane = std::round(p[axis]);
      if (std::abs(p[axis] - plane) > near_plane) continue;
      const auto found = sheets.find({axis, static_cast<int>(plane), up});
      if (found == sheets.end()) continue;
      const numeric::FlatPlace place = found->second.locator.nearest(flat(found->first, p));
      if (!(place.outside < best.outside)) continue;
      best = {found->second.triangles[place.triangle], place.weight, place.outside};
    }
  return best;
}

} // namespace tetrarch::product
