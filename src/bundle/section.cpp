// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/section.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetrarch::bundle {
namespace {

using mesh::SideEnd;
using mesh::Surface;

void require_finite(const std::vector<double>& numbers, int count) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (static_cast<int>(numbers.size()) != count || !std::all_of(numbers.begin(), numbers.end(), finite))
    throw PreconditionError("a finite number for each vertex is needed");
}

/// How far the section rises along side s, as the ring of its triangle has it, but for whole turns.
double rise_along(const CircleBundle& bundle, const Fibers& fibers, const std::vector<double>& place,
                  Side s) {
  const Fibers::Reference& r = fibers.reference[s.value];
  const int t = 3 * s.triangle();
  const double before = r.start - place[bundle.base.from(s)];
  const double after = place[bundle.base.to(s)] - r.stop;
  return fibers.up[t + s.next().corner()] * before + r.rise + fibers.up[t + s.previous().corner()] * after;
}

} // namespace

std::vector<int> indices(const CircleBundle& bundle, const Fibers& fibers, const std::vector<double>& place) {
  const Surface& base = bundle.base;
  require_finite(place, base.vertex_count());
  const double n = bundle.fiber;
  // Whole turns are taken off to make the way short, as the side of less number sees it. Its mate sees them
  // with the opposite sign: either it runs the other way, or, where mates are turned, its up is down.
  std::vector<double> rise(static_cast<std::size_t>(base.side_count()));
  for (int k = 0; k < base.side_count(); ++k) {
    const Side s(k);
    const Side m = base.mate(s);
    if (m.exists() && m.value < k) continue;
    const double along = rise_along(bundle, fibers, place, s);
    const double turns = std::round(along / n);
    rise[k] = along - turns * n;
    if (m.exists()) rise[m.value] = rise_along(bundle, fibers, place, m) + turns * n;
  }
  std::vector<int> index(static_cast<std::size_t>(base.triangle_count()));
  for (int t = 0; t < base.triangle_count(); ++t) {
    double sum = 0;
    for (const Side s : sides_of(t)) sum += rise[s.value];
    index[t] = static_cast<int>(std::lround(sum / n));
  }
  return index;
}

namespace {

using std::numbers::pi;

/// A corner as its vertex sees it.
struct CornerFrame {
  double from = 0;  ///< the angle of the side that starts from the corner
  double to = 0;    ///< the angle of the side that ends at it, looked at backwards
  int sign = 1;     ///< +1 if the triangle's counterclockwise is the vertex's
  double angle = 0; ///< scaled
};

/// The angle of the triangle at corner c; 60 degrees where it has none.
double corner_angle(const Surface& surface, const std::vector<std::array<double, 3>>& points, int t, int c) {
  const auto& corners = surface.corners(t);
  double dot = 0;
  double first = 0;
  double second = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = points[corners[(c + 1) % 3]][k] - points[corners[c]][k];
    const double b = points[corners[(c + 2) % 3]][k] - points[corners[c]][k];
    dot += a * b;
    first += a * a;
    second += b * b;
  }
  const double cosine = dot / std::sqrt(first * second);
  return std::isfinite(cosine) ? std::acos(std::clamp(cosine, -1.0, 1.0)) : pi / 3;
}

std::vector<CornerFrame> corner_frames(const Surface& surface,
                                       const std::vector<std::array<double, 3>>& points) {
  std::vector<CornerFrame> frames(static_cast<std::size_t>(surface.side_count()));
  std::vector<char> done(static_cast<std::size_t>(surface.vertex_count()), 0);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      if (done[v]) continue;
      done[v] = 1;
      const auto around = mesh::fan(surface, {Side(t, (c + 2) % 3), true});
      double total = 0;
      for (const SideEnd& e : around) total += corner_angle(surface, points, e.side.triangle(), e.corner());
      const bool flat = !(total > 0); // a vertex all of whose neighbours lie in one direction
      if (flat) total = static_cast<double>(around.size());
      const double scale = surface.is_boundary(around.front().side) && !flat ? 1 : 2 * pi / total;
      double at = 0;
      for (const SideEnd& e : around) {
        // Entering by the side that starts here one turns counterclockwise.
        const double angle =
            scale * (flat ? 1 : corner_angle(surface, points, e.side.triangle(), e.corner()));
        CornerFrame& frame = frames[3 * e.side.triangle() + e.corner()];
        frame = e.at_start ? CornerFrame{at, at + angle, 1, angle} : CornerFrame{at + angle, at, -1, angle};
        at += angle;
      }
    }
  return frames;
}

/// In (-pi, pi], but for rounding.
double wrapped(double angle) {
  return angle - 2 * pi * std::round(angle / (2 * pi));
}

} // namespace

std::vector<int> field_indices(const Surface& surface, const std::vector<std::array<double, 3>>& points,
                               const std::vector<double>& direction) {
  require_finite(direction, surface.vertex_count());
  if (static_cast<int>(points.size()) != surface.vertex_count())
    throw PreconditionError("a point for each vertex is needed");
  const std::vector<CornerFrame> frames = corner_frames(surface, points);
  const auto turn = [&](Side s) {
    const CornerFrame& start = frames[3 * s.triangle() + s.next().corner()];
    const CornerFrame& stop = frames[3 * s.triangle() + s.previous().corner()];
    const double before = start.sign * (direction[surface.from(s)] - start.from);
    const double after = stop.sign * (direction[surface.to(s)] - stop.to) - pi;
    return wrapped(after - before);
  };
  std::vector<int> index(static_cast<std::size_t>(surface.triangle_count()));
  for (int t = 0; t < surface.triangle_count(); ++t) {
    double sum = -pi;
    for (const Side s : sides_of(t)) {
      // Seen from its mate the edge must turn by the same, even by half a turn.
      const Side m = surface.mate(s);
      const bool told_by_mate = m.exists() && m.value < s.value;
      sum += told_by_mate ? -turn(m) : turn(s);
      sum += frames[s.value].angle;
    }
    index[t] = static_cast<int>(std::lround(sum / (2 * pi)));
  }
  return index;
}

} // namespace tetrarch::bundle
