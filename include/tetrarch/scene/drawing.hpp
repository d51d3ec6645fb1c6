// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is to be seen in the plane: circles and outlines, written as SVG.

#include "tetrarch/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::scene {

/// How something is drawn; `fill` and `stroke` may each be absent.
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
  /// What is shown; the rest is cut off.
  std::array<double, 2> lower{-1, -1};
  std::array<double, 2> upper{1, 1};
  std::vector<Circle> circles;
  std::vector<Outline> outlines;
};

/// One SVG document, `width` pixels wide, with a title. Numbers have as many digits as a hundredth of a pixel
/// needs; what lies outside what is shown, or is smaller than a tenth of a pixel, is left out. A circle some
/// ten times larger than the window becomes a polygon near it, within a fiftieth of a pixel, since browsers,
/// which draw in single precision, would misplace it; so circles that are nearly lines may be given as they
/// are. O(size). Throws PreconditionError for a window without area, a width that is not positive, a negative
/// radius or width of a stroke, and what is not finite.
std::string write_svg(const Drawing& drawing, int width = 800);

} // namespace tetrarch::scene
