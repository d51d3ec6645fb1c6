// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/files.hpp"

#include <limits>
#include <numbers>
#include <span>

namespace tetrarch::scene {
namespace {

using namespace numeric;

/// How far a sum of two unit vectors may shrink before they count as opposite.
constexpr double opposite = 1e-6;

/// The directions of the segments; one without length goes the way of the one before it, or else after it.
std::vector<Point> segment_directions(std::span<const Point> points) {
  std::vector<Point> directions(points.size() - 1);
  std::optional<Point> last;
  for (std::size_t k = 0; !last && k < directions.size(); ++k) last = direction(points[k + 1] - points[k]);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    if (const auto here = direction(points[k + 1] - points[k])) last = here;
    directions[k] = last.value_or(Point{0, 0, 1});
  }
  return directions;
}

/// The direction at every point: at a bend, halfway; where the polyline turns back, that of the way there.
std::vector<Point> tangents(std::span<const Point> points) {
  const std::vector<Point> along = segment_directions(points);
  std::vector<Point> out(points.size(), along.front());
  out.back() = along.back();
  for (std::size_t i = 1; i < along.size(); ++i) {
    const Point sum = along[i - 1] + along[i];
    out[i] = dot(sum, sum) < opposite ? along[i - 1] : direction(sum).value_or(along[i]);
  }
  return out;
}

/// Some unit vector at right angles to the unit vector `t`.
Point any_normal(const Point& t) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(t[i]) < std::abs(t[least])) least = i;
  Point axis{};
  axis[least] = 1;
  return direction(cross(t, axis)).value_or(axis);
}

/// The normal u at `from` after the shortest rotation that takes the direction `from` to `to`.
Point transported(const Point& u, const Point& from, const Point& to) {
  const double both = 1 + dot(from, to);
  const Point turned = both < opposite ? u : u - (dot(to, u) / both) * (from + to);
  // Rounding adds up along thousands of segments; each step puts it right.
  return direction(turned - dot(turned, to) * to).value_or(any_normal(to));
}

class Sweep {
public:
  Sweep(Surface& out, int sides) : out_(out), sides_(sides) {}

  void add(std::span<const Point> points, std::span<const double> radii) {
    const std::vector<Point> along = tangents(points);
    Point u = any_normal(along.front());
    const int first = next_point();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) u = transported(u, along[i - 1], along[i]);
      add_ring(points[i], radii[i], u, cross(along[i], u));
      if (i > 0) join_rings(first + static_cast<int>(i - 1) * sides_);
    }
    const int last_ring = next_point() - sides_;
    close(first, points.front(), -1 * along.front(), true);
    close(last_ring, points.back(), along.back(), false);
  }

private:
  int next_point() const { return static_cast<int>(out_.points.size()); }
  int after(int corner) const { return corner + 1 == sides_ ? 0 : corner + 1; }

  void add_ring(const Point& center, double radius, const Point& u, const Point& v) {
    for (int j = 0; j < sides_; ++j) {
      const double angle = 2 * std::numbers::pi * j / sides_;
      const Point outward = std::cos(angle) * u + std::sin(angle) * v;
      out_.points.push_back(center + radius * outward);
      out_.normals.push_back(outward);
    }
  }

  /// The ring that begins with point `ring`, and the one after it.
  void join_rings(int ring) {
    for (int j = 0; j < sides_; ++j) {
      const int a = ring + j;
      const int b = ring + after(j);
      out_.triangles.push_back({a, b, b + sides_});
      out_.triangles.push_back({a, b + sides_, a + sides_});
    }
  }

  void close(int ring, const Point& center, const Point& outward, bool front) {
    const int middle = next_point();
    out_.points.push_back(center);
    out_.normals.push_back(outward);
    for (int j = 0; j < sides_; ++j) {
      const int a = ring + j;
      const int b = ring + after(j);
      out_.triangles.push_back(front ? std::array{middle, b, a} : std::array{middle, a, b});
    }
  }

  Surface& out_;
  int sides_;
};

/// Each value once for every triangle of its polyline.
template <class T>
std::vector<T> spread(const std::vector<T>& values, const Tubes& tubes, int sides) {
  std::vector<T> out;
  for (std::size_t k = 0; k < values.size(); ++k)
    out.insert(out.end(), 2 * static_cast<std::size_t>(sides) * (tubes.starts[k + 1] - tubes.starts[k]),
               values[k]);
  return out;
}

} // namespace

Surface swept(const Tubes& tubes, int sides) {
  require_sound(tubes);
  if (sides < 3) throw PreconditionError("a tube needs at least three sides");
  const std::size_t polylines = part_count(tubes);
  const std::size_t points = tubes.points.size() * static_cast<std::size_t>(sides) + 2 * polylines;
  if (points > std::numeric_limits<int>::max()) throw PreconditionError("the tubes have too many points");
  Surface out;
  out.name = tubes.name;
  out.points.reserve(points);
  out.normals.reserve(points);
  out.triangles.reserve(2 * tubes.points.size() * static_cast<std::size_t>(sides));
  Sweep sweep(out, sides);
  for (std::size_t k = 0; k < polylines; ++k) {
    const auto start = static_cast<std::size_t>(tubes.starts[k]);
    const std::size_t size = static_cast<std::size_t>(tubes.starts[k + 1]) - start;
    sweep.add(std::span(tubes.points).subspan(start, size), std::span(tubes.radii).subspan(start, size));
  }
  out.colors = tubes.colors.size() == 1 ? tubes.colors : spread(tubes.colors, tubes, sides);
  for (const Data& data : tubes.data) out.data.push_back({data.name, spread(data.values, tubes, sides)});
  return out;
}

} // namespace tetrarch::scene
