// SPDX-License-Identifier: GPL-2.0-or-later
#include "view.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/curve.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

namespace tetrarch::diagram {
namespace {

using namespace numeric;

void require_distinct(const Curve& curve, const std::string& source) {
  std::map<Point, int> seen;
  for (int p = 0; p < static_cast<int>(curve.points.size()); ++p) {
    for (const double x : curve.points[p])
      if (!std::isfinite(x)) throw InputError({source, 0}, "point " + std::to_string(p) + " is not finite");
    const auto [at, fresh] = seen.emplace(curve.points[p], p);
    if (!fresh)
      throw InputError({source, 0}, "points " + std::to_string(at->second) + " and " + std::to_string(p) +
                                        " coincide: the curve meets itself");
  }
}

/// Outside the points, in a random direction.
Point random_eye(const Curve& curve, SplitMix64& random) {
  Point low = curve.points.front();
  Point high = low;
  for (const Point& p : curve.points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  const double size = distance(low, high);
  const double z = 2 * random.uniform() - 1;
  const double angle = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1 - z * z);
  const Vector away{r * std::cos(angle), r * std::sin(angle), z};
  return 0.5 * (low + high) + (2 * size * (1 + random.uniform())) * away;
}

std::string segment_name(const Curve& curve, int s) {
  return "of points " + std::to_string(curve.segments[s][0]) + " and " + std::to_string(curve.segments[s][1]);
}

[[noreturn]] void fail_meeting(const Curve& curve, const View& view, const std::string& source) {
  const auto [s, t] = view.meeting();
  throw InputError({source, 0},
                   "the segments " + segment_name(curve, s) + " and " + segment_name(curve, t) +
                       (view.meets_in_space() ? " meet" : " meet, as seen from every place tried"));
}

} // namespace

Diagram project(const Curve& curve, const std::string& source, const ProjectOptions& options,
                const Progress& progress) {
  require_distinct(curve, source);
  SplitMix64 random(options.seed);
  std::optional<View> best;
  constexpr int tries = 8;
  for (int k = 0; k < std::max(options.views, tries); ++k) {
    if (best && k >= options.views) break;
    const Point eye = random_eye(curve, random);
    if (!std::isfinite(dot(eye, eye)) ||
        std::find(curve.points.begin(), curve.points.end(), eye) != curve.points.end())
      throw InputError({source, 0}, "the curve is too small or too large to be looked at");
    View view(curve, eye);
    if (!view.find_crossings(progress)) {
      if (view.meets_in_space() || k + 1 == std::max(options.views, tries)) fail_meeting(curve, view, source);
      continue;
    }
    if (!best || view.crossing_count() < best->crossing_count()) best.emplace(std::move(view));
  }
  if (!best) throw InputError({source, 0}, "no place shows the curve in general position");
  return best->diagram();
}

} // namespace tetrarch::diagram
