// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Small soups of triangles, and what validators say of them.

#include "support/soups.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/doctor/validate_surface.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::support::soups {

using Triangle = surface::Surface::Triangle;
using Triangles = std::vector<Triangle>;
using Points = std::vector<std::array<double, 3>>;
using Counts = std::map<std::string, int>;

/// The kinds that were found, and how often. Surfaces are given by their triangles alone here, so that it is
/// chance which way out is: inside_out has tests of its own.
inline Counts counts_in(const doctor::Report& report) {
  Counts found;
  for (int k = 0; k < doctor::kind_count; ++k) {
    const auto kind = static_cast<doctor::Kind>(k);
    if (kind != doctor::Kind::inside_out && report.count(kind) > 0)
      found[std::string(name_of(kind))] = static_cast<int>(report.count(kind));
  }
  return found;
}

/// n points of which no three are on a line: on the moment curve.
inline Points curve(int n) {
  Points points;
  for (double t = 0; t < n; ++t) points.push_back({t, t * t, t * t * t});
  return points;
}

/// As if read from a MEDIT file: of P points, counted from 1, point v stands on line 4 + v, triangle k on
/// line 6 + P + k.
inline format::Soup surface_soup(const Points& points, const Triangles& triangles) {
  return soup_of(points, {}, triangles);
}
inline format::Soup surface_soup(const TriangleList& list) {
  return surface_soup(list.points.empty() ? curve(list.vertices) : list.points, list.triangles);
}

inline Triangle turned(const Triangle& t) {
  return {t[0], t[2], t[1]};
}

/// A Moebius strip of n triangles in a row, n odd and at least 5, each turned as it comes.
inline Triangles moebius_strip(int n) {
  Triangles strip;
  for (int k = 0; k < n; ++k) strip.push_back({k, (k + 1) % n, (k + 2) % n});
  return strip;
}

} // namespace tetrarch::support::soups
