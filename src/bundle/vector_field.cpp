// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/vector_field.hpp"

#include "tetrarch/core/error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tetrarch::bundle {
namespace {

using std::numbers::pi;
using surface::Side;
using surface::SideEnd;
using surface::Surface;
using Points = std::vector<std::array<double, 3>>;

void require_points(const Surface& surface, const Points& points) {
  if (static_cast<int>(points.size()) != surface.vertex_count())
    throw PreconditionError("a point for each vertex is needed");
}

/// A corner as its vertex sees it.
struct CornerFrame {
  double from = 0;  ///< the angle of the side that starts from the corner
  double to = 0;    ///< the angle of the side that ends at it, looked at backwards
  int sign = 1;     ///< +1 if the triangle's counterclockwise is the vertex's
  double angle = 0; ///< scaled
};

/// The angle of the triangle at corner c; 60 degrees where it has none.
double corner_angle(const Surface& surface, const Points& points, int t, int c) {
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

/// What a vertex sees: the ends around it, and the angle from the first edge at which each of its triangles
/// begins; the last entry is where the last one ends.
struct Fan {
  std::vector<SideEnd> ends;
  std::vector<double> angle;
};

Fan fan_of(const Surface& surface, const Points& points, SideEnd first) {
  Fan fan{surface::fan(surface, first), {0}};
  for (const SideEnd& e : fan.ends)
    fan.angle.push_back(fan.angle.back() + corner_angle(surface, points, e.side.triangle(), e.corner()));
  const double total = fan.angle.back();
  if (!(total > 0)) { // all neighbours lie in one direction
    for (std::size_t k = 0; k < fan.angle.size(); ++k)
      fan.angle[k] = 2 * pi * static_cast<double>(k) / static_cast<double>(fan.ends.size());
  } else if (!surface.is_boundary(fan.ends.front().side)) {
    for (double& angle : fan.angle) angle *= 2 * pi / total;
  }
  return fan;
}

/// Calls `job(v, fan)` for each vertex.
template <class Job>
void for_each_fan(const Surface& surface, const Points& points, Job job) {
  std::vector<char> done(static_cast<std::size_t>(surface.vertex_count()), 0);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      if (done[v]) continue;
      done[v] = 1;
      job(v, fan_of(surface, points, {Side(t, (c + 2) % 3), true}));
    }
}

std::vector<CornerFrame> corner_frames(const Surface& surface, const Points& points) {
  std::vector<CornerFrame> frames(static_cast<std::size_t>(surface.side_count()));
  for_each_fan(surface, points, [&](int, const Fan& fan) {
    for (std::size_t k = 0; k < fan.ends.size(); ++k) {
      const SideEnd& e = fan.ends[k];
      const double begins = fan.angle[k];
      const double ends = fan.angle[k + 1];
      // Entering by the side that starts here one turns counterclockwise.
      frames[3 * e.side.triangle() + e.corner()] = e.at_start ? CornerFrame{begins, ends, 1, ends - begins}
                                                              : CornerFrame{ends, begins, -1, ends - begins};
    }
  });
  return frames;
}

/// In (-pi, pi], but for rounding.
double wrapped(double angle) {
  return angle - 2 * pi * std::round(angle / (2 * pi));
}

} // namespace

std::vector<int> field_indices(const Surface& surface, const Points& points,
                               const std::vector<double>& direction) {
  require_points(surface, points);
  const auto finite = [](double x) { return std::isfinite(x); };
  if (direction.size() != points.size() || !std::all_of(direction.begin(), direction.end(), finite))
    throw PreconditionError("a finite angle for each vertex is needed");
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
    for (const Side s : surface::sides_of(t)) {
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

namespace {

using Vector = Eigen::Vector3d;

/// The angles of vectors in a plane, from the first edge of a fan on.
class TangentPlane {
public:
  TangentPlane(const std::vector<Vector>& edges) {
    Vector normal = Vector::Zero();
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) normal += edges[k].cross(edges[k + 1]);
    normal.normalize();
    x_ = (edges[0] - normal.dot(edges[0]) * normal).normalized();
    y_ = normal.cross(x_);
  }
  double angle(const Vector& v) const { return std::atan2(v.dot(y_), v.dot(x_)); }

private:
  Vector x_;
  Vector y_;
};

double direction_in(const Fan& fan, const std::vector<Vector>& edges, const Vector& vector) {
  const TangentPlane plane(edges);
  const double wanted = plane.angle(vector);
  double nearest = 10;
  double direction = 0;
  for (std::size_t k = 0; k < fan.ends.size(); ++k) {
    const double begins = plane.angle(edges[k]);
    const double width = wrapped(plane.angle(edges[k + 1]) - begins);
    const double offset = wrapped(wanted - begins);
    if (width > 0 && offset >= 0 && offset <= width)
      return fan.angle[k] + offset / width * (fan.angle[k + 1] - fan.angle[k]);
    // No triangle's share, as at a boundary: the nearest edge.
    for (const auto& [distance, angle] :
         {std::pair{std::abs(offset), fan.angle[k]}, {std::abs(wrapped(offset - width)), fan.angle[k + 1]}})
      if (distance < nearest) {
        nearest = distance;
        direction = angle;
      }
  }
  return direction;
}

} // namespace

std::vector<double> projected_field(const Surface& surface, const Points& points,
                                    const std::array<double, 3>& vector) {
  require_points(surface, points);
  const auto at = [&](int v) { return Vector(points[v][0], points[v][1], points[v][2]); };
  std::vector<double> direction(points.size(), 0);
  for_each_fan(surface, points, [&](int v, const Fan& fan) {
    std::vector<Vector> edges;
    edges.reserve(fan.ends.size() + 1);
    for (const SideEnd& e : fan.ends) edges.push_back(at(surface.vertex({e.side, !e.at_start})) - at(v));
    const SideEnd last = fan.ends.back().pivot();
    edges.push_back(at(surface.vertex({last.side, !last.at_start})) - at(v));
    const double angle = direction_in(fan, edges, Vector(vector[0], vector[1], vector[2]));
    direction[v] = std::isfinite(angle) ? angle : 0;
  });
  return direction;
}

} // namespace tetrarch::bundle
