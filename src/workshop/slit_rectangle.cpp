// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_rectangle.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/workshop/in_file.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tetrarch::workshop {
namespace {

/// Where the vertices of a loop lie.
ConformalMap::Rectangle::Hole box_of_loop(const HoledSurface& surface, int loop,
                                          const std::vector<std::complex<double>>& position) {
  ConformalMap::Rectangle::Hole hole{loop, INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const surface::SideEnd e : surface.loops[loop].sides) {
    const std::complex<double> z = position[surface.mesh().surface.vertex(e)];
    hole.left = std::min(hole.left, z.real());
    hole.right = std::max(hole.right, z.real());
    hole.bottom = std::min(hole.bottom, z.imag());
    hole.top = std::max(hole.top, z.imag());
  }
  return hole;
}

ConformalMap::Rectangle rectangle_of(const slit::RicciRectangles& found, const HoledSurface& surface,
                                     int outer) {
  ConformalMap::Rectangle rectangle;
  rectangle.outer = outer;
  for (const slit::LoopCorner& c : found.corners.front())
    rectangle.corners.push_back(surface.opened.number[c.vertex]);
  rectangle.height = found.height;
  for (int k = 0; k < static_cast<int>(surface.loops.size()); ++k)
    if (k != outer) rectangle.holes.push_back(box_of_loop(surface, k, found.position));
  rectangle.holonomy = found.holonomy;
  rectangle.residual = found.residual;
  rectangle.rounds = found.rounds;
  rectangle.found = found.found;
  return rectangle;
}

} // namespace

ConformalMap map_to_rectangle(const HoledSurface& surface, const MapOptions& options,
                              const Progress& progress) {
  const surface::TriangleMesh& mesh = surface.mesh();
  int outer = options.circles.outer;
  if (outer < 0 || outer >= static_cast<int>(surface.loops.size()))
    throw PreconditionError("there is no loop " + std::to_string(outer));
  const std::array<int, 4> corners =
      options.corners ? *options.corners
                      : in_file(options.name, [&] { return slit::corners_of(mesh, surface.loops[outer]); });
  if (options.corners)
    if (const int loop = surface::loop_through(surface.loops, mesh.surface, corners[0]); loop >= 0)
      outer = loop;
  const slit::RicciRectangles found = in_file(options.name, [&] {
    return slit::ricci_rectangles(mesh, slit::rectangle_hints(mesh, corners, {}, progress), {}, progress);
  });
  ConformalMap made;
  made.rectangle = rectangle_of(found, surface, outer);
  made.distortion = slit::distortion_in_plane(mesh, found.position);
  made.layout = show::plane_layout(mesh, found.position, "rectangular domain");
  return made;
}

} // namespace tetrarch::workshop
