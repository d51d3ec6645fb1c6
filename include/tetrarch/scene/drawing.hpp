// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A picture in the plane: circles and outlines, written as SVG.

#include "tetrarch/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::scene {

/// The style of an element; `fill` and `stroke` may each be absent.
struct Ink {
  std::optional<Color> fill;
  std::optional<Color> stroke;
  double width = 1; ///< of the stroke, in pixels, whatever the scale
  friend bool operator==(const Ink&, const Ink&) = default;
};

struct Circle {
  std::array<double, 2> center{};
  double radius = 1;
  Ink ink;
};

/// A polyline; closed: a polygon.
struct Outline {
  std::vector<std::array<double, 2>> points;
  bool closed = false;
  Ink ink;
};

/// Painted in the order: circles, outlines; each list from its beginning. y points upwards.
struct Drawing {
  std::string title;
  /// The window; everything outside it is cut off.
  std::array<double, 2> lower{-1, -1};
  std::array<double, 2> upper{1, 1};
  std::vector<Circle> circles;
  std::vector<Outline> outlines;
};

/// One SVG document, `width` pixels wide, with a title. Numbers have as many digits as a hundredth of a pixel
/// needs; elements outside the window, or smaller than a tenth of a pixel, are left out. A circle more than
/// about ten times larger than the window becomes a polygon near the window, to within a fiftieth of a pixel,
/// because browsers draw in single precision and would misplace it. So callers may pass circles that are
/// nearly lines. O(size). Throws PreconditionError for a window without area, a width that is not positive, a
/// negative radius or stroke width, and numbers that are not finite.
std::string write_svg(const Drawing& drawing, int width = 800);

} // namespace tetrarch::scene
