// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The surface of a polycube as sheets: flat pieces, by plane and by the side that is outside.
///
///          ________
///         /  up   /|       Lattice planes are numbered, so that plane k of axis a is where coordinate a is
///        /_______/ |__     k steps. On a sheet that faces up its axis, the plane's coordinates are the next
///       | front  |/  /|    two; on one that faces down they change places: so triangles seen from outside
///       |________/__/ |    are counterclockwise in both.

#include "tetrarch/numeric/flat_locator.hpp"
#include "tetrarch/product/solid.hpp"
#include "tetrarch/surface/surface.hpp"

#include <compare>
#include <complex>
#include <map>
#include <vector>

namespace tetrarch::product {

struct Facing {
  int axis = 0;
  int plane = 0;
  bool up = false;
  friend auto operator<=>(const Facing&, const Facing&) = default;
};

/// A point of space in the plane's coordinates.
std::complex<double> flat(const Facing& facing, const Point& p);

struct Sheet {
  std::vector<int> triangles;       ///< of the surface
  numeric::FlatLocator locator{{}}; ///< of these, in their order
};

using Sheets = std::map<Facing, Sheet>;

/// The images in steps of the lattice; what is nearly a whole number becomes one. Throws as
/// `filled_polycube`.
std::vector<Point> snapped(const surface::Surface& boundary, const std::vector<Point>& image, double step);

/// Where each triangle lies, for images that are snapped. Throws InputError if one lies in no plane of the
/// lattice, or has no area.
std::vector<Facing> facings(const surface::Surface& boundary, const std::vector<Point>& image);

/// Those of the triangles that are in `wanted`; empty: of all.
Sheets sheets(const surface::Surface& boundary, const std::vector<Point>& image,
              const std::vector<Facing>& facing, const std::vector<char>& wanted = {});

struct OnSurface {
  int triangle = -1; ///< -1 if the point is in no plane of a sheet
  std::array<double, 3> weight{};
  double outside = 0;
};

/// Where a point is on the sheets, or the nearest point in the planes that it lies in.
OnSurface located(const Sheets& sheets, const Point& p);

} // namespace tetrarch::product
