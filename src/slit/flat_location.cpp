// SPDX-License-Identifier: GPL-2.0-or-later
#include "flat_location.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/flat_locator.hpp"

namespace tetrarch::slit {

std::vector<FlatPoint> flat_points(const surface::Surface& surface,
                                   const std::vector<std::complex<double>>& position,
                                   const std::vector<std::complex<double>>& points) {
  std::vector<numeric::FlatTriangle> triangles;
  triangles.reserve(surface.triangles().size());
  for (const auto& [a, b, c] : surface.triangles())
    triangles.push_back({position[a], position[b], position[c]});
  const numeric::FlatLocator locator(std::move(triangles));
  if (locator.empty()) throw PreconditionError("all triangles are inverted in the plane");
  std::vector<FlatPoint> result;
  result.reserve(points.size());
  for (const std::complex<double> z : points) {
    const numeric::FlatPlace place = locator.deepest(z);
    result.push_back({{place.triangle, place.weight}, place.outside});
  }
  return result;
}

} // namespace tetrarch::slit
