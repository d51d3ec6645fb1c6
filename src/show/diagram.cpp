// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/diagram.hpp"

#include "tetrarch/scene/palette.hpp"

#include <algorithm>

namespace tetrarch::show {
namespace {

/// Darker than the palette, which is for areas.
scene::Color line_color(int edge) {
  constexpr double darkening = 0.25;
  constexpr int first = 4; // blue
  return scene::mixed(scene::qualitative(first + edge), {0, 0, 0}, darkening);
}

} // namespace

scene::Drawing drawing(const diagram::Layout& layout, const std::string& title) {
  scene::Drawing out;
  out.title = title;
  out.lower = layout.lower;
  out.upper = layout.upper;
  constexpr double line_width = 3;
  for (const diagram::Stroke& stroke : layout.strokes)
    out.outlines.push_back(
        {stroke.points, stroke.closed, {std::nullopt, line_color(stroke.edge), line_width}});
  constexpr double largest_dot = 0.015;
  const double radius =
      std::min(0.5 * layout.vertex_radius,
               largest_dot * std::max(layout.upper[0] - layout.lower[0], layout.upper[1] - layout.lower[1]));
  for (const diagram::PlanePoint& v : layout.vertices)
    out.circles.push_back({v, radius, {scene::Color{0, 0, 0}, std::nullopt, 1}});
  return out;
}

} // namespace tetrarch::show
