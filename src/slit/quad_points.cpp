// SPDX-License-Identifier: GPL-2.0-or-later
#include "quad_points.hpp"

#include "full_turn.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetrarch::slit {
namespace {

using Place = std::array<double, 2>;

/// Far above rounding errors, far below the size of triangles.
constexpr double tile_margin = 1e-9;

SpacePoint between(const SpacePoint& p, const SpacePoint& q, double part) {
  SpacePoint r{};
  for (std::size_t k = 0; k < 3; ++k) r[k] = (1 - part) * p[k] + part * q[k];
  return r;
}

/// A triangle on the cylinder.
class Tile {
public:
  explicit Tile(const std::array<Place, 3>& corners) : p_(corners) {}
  bool is_upright() const { return area(p_[0])[0] > 0; }
  double low(std::size_t axis) const { return std::min({p_[0][axis], p_[1][axis], p_[2][axis]}); }
  double high(std::size_t axis) const { return std::max({p_[0][axis], p_[1][axis], p_[2][axis]}); }
  /// Twice the signed areas of the triangles between the point and the sides, by opposite corners.
  std::array<double, 3> area(const Place& at) const {
    std::array<double, 3> result{};
    for (std::size_t c = 0; c < 3; ++c) {
      const Place& a = p_[(c + 1) % 3];
      const Place& b = p_[(c + 2) % 3];
      result[c] = (a[0] - at[0]) * (b[1] - at[1]) - (a[1] - at[1]) * (b[0] - at[0]);
    }
    return result;
  }
  /// The distance from the nearest side, negative outside.
  double depth(const Place& at) const {
    const std::array<double, 3> areas = area(at);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
      const Place& a = p_[(c + 1) % 3];
      const Place& b = p_[(c + 2) % 3];
      least = std::min(least, areas[c] / std::hypot(b[0] - a[0], b[1] - a[1]));
    }
    return least;
  }

private:
  std::array<Place, 3> p_;
};

/// The best triangle up to now for a point.
struct Find {
  int triangle = -1;
  double depth = -std::numeric_limits<double>::infinity();
  Place at{}; ///< the point, where the triangle lies
  void offer(const Tile& tile, int t, const Place& place) {
    const double d = tile.depth(place);
    if (d > depth) *this = {t, d, place};
  }
};

/// The finds of all crossing points.
class Screen {
public:
  Screen(const std::vector<double>& angles, const std::vector<double>& heights)
      : angles_(angles), heights_(heights), finds_(angles.size() * (heights.size() - 2)) {}

  void paint(const Tile& tile, int t) {
    const auto row_of = [&](double height) {
      return std::lower_bound(heights_.begin() + 1, heights_.end() - 1, height) - heights_.begin();
    };
    const auto last_row = row_of(tile.high(1) + tile_margin);
    for (auto row = row_of(tile.low(1) - tile_margin); row < last_row; ++row) {
      const double right = tile.high(0) + tile_margin;
      for (long column = column_of(tile.low(0) - tile_margin); angle(column) <= right; ++column)
        at(static_cast<std::size_t>(row), column).offer(tile, t, {angle(column), heights_[row]});
    }
  }
  std::vector<Find>& finds() { return finds_; }
  Place place(std::size_t k) const { return {angles_[k % angles_.size()], heights_[1 + k / angles_.size()]}; }

private:
  long count() const { return static_cast<long>(angles_.size()); }
  /// Columns go on beyond the first and the last one, turn after turn.
  double angle(long column) const {
    const long turn = column >= 0 ? column / count() : -((count() - 1 - column) / count());
    return angles_[column - turn * count()] + full_turn * static_cast<double>(turn);
  }
  long column_of(double angle) const {
    const double turn = std::floor((angle - angles_.front()) / full_turn);
    const auto found = std::lower_bound(angles_.begin(), angles_.end(), angle - turn * full_turn);
    return static_cast<long>(turn) * count() + (found - angles_.begin());
  }
  Find& at(std::size_t row, long column) {
    const long rest = column % count();
    return finds_[(row - 1) * angles_.size() + static_cast<std::size_t>(rest < 0 ? rest + count() : rest)];
  }

  const std::vector<double>& angles_;
  const std::vector<double>& heights_;
  std::vector<Find> finds_;
};

/// Whatever no triangle was offered for, as its bounding box missed it: all of them are.
void search_everywhere(Find& find, const Place& place, const std::vector<Tile>& tiles) {
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (const double turn : {-full_turn, 0.0, full_turn})
      if (tiles[t].is_upright()) find.offer(tiles[t], static_cast<int>(t), {place[0] + turn, place[1]});
}

SpacePoint interpolated(const surface::TriangleMesh& mesh, const Tile& tile, const Find& find) {
  std::array<double, 3> weight = tile.area(find.at);
  double sum = 0;
  for (double& w : weight) sum += w = std::max(w, 0.0);
  SpacePoint result{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < 3; ++k)
      result[k] += weight[c] / sum * mesh.points[mesh.surface.corners(find.triangle)[c]][k];
  return result;
}

/// A curve on the surface and the angle along it.
struct Path {
  std::vector<double> angle;
  std::vector<SpacePoint> point;
  void add(double a, const SpacePoint& p) {
    angle.push_back(a);
    point.push_back(p);
  }
};

/// Where the angles, ascending, are reached first.
std::vector<SpacePoint> reached(const Path& path, const std::vector<double>& angles) {
  std::vector<SpacePoint> result;
  std::size_t k = 0;
  for (const double wanted : angles) {
    while (k + 1 < path.angle.size() && path.angle[k] < wanted) ++k;
    // No farther than to the end, and back to no more than the beginning.
    const double step = k == 0 ? 0.0 : path.angle[k] - path.angle[k - 1];
    const double part = step > 0 ? std::min(1.0, (wanted - path.angle[k - 1]) / step) : 1.0;
    result.push_back(k == 0 ? path.point[0] : between(path.point[k - 1], path.point[k], part));
  }
  return result;
}

/// The vertices of a loop in its order, with angles that do not jump.
Path path_around(const OneForms& forms, const SlitMap& map, int loop) {
  const surface::TriangleMesh& mesh = forms.mesh();
  const auto& sides = forms.loops()[loop].sides;
  Path path;
  double angle = map.angle[mesh.surface.vertex(sides.front())];
  for (const surface::SideEnd e : sides) {
    path.add(angle, mesh.points[mesh.surface.vertex(e)]);
    angle += map.form.imaginary[e.side.value];
  }
  return path;
}

/// A closed path whose places are numbers: vertex k at k, the edges between.
class ClosedPath {
public:
  explicit ClosedPath(Path path) : path_(std::move(path)) {}
  long size() const { return static_cast<long>(path_.angle.size()); }
  double angle(long k) const { return path_.angle[cyclic(k)]; }
  const SpacePoint& vertex(long k) const { return path_.point[cyclic(k)]; }
  SpacePoint point(double place) const {
    const double before = std::floor(place);
    const long k = static_cast<long>(before);
    return between(vertex(k), vertex(k + 1), place - before);
  }
  /// Where the angle turns at vertex k, which is an extremum: the parabola through it and its neighbours,
  /// over the length along the edges, has slope 0.
  double turning_place(long k) const {
    const double before = numeric::distance(vertex(k - 1), vertex(k));
    const double after = numeric::distance(vertex(k), vertex(k + 1));
    const double slope_before = (angle(k) - angle(k - 1)) / before;
    const double slope_after = (angle(k + 1) - angle(k)) / after;
    if (slope_before == slope_after) return static_cast<double>(k);
    const double part = slope_before / (slope_before - slope_after);
    const double along = (part * (before + after) - before) / 2;
    return static_cast<double>(k) + along / (along < 0 ? before : after);
  }

private:
  std::size_t cyclic(long k) const { return static_cast<std::size_t>((k % size() + size()) % size()); }
  Path path_;
};

} // namespace

CrossingPoints crossing_points(const surface::TriangleMesh& mesh, const SlitMap& map,
                               const std::vector<double>& angles, const std::vector<double>& heights) {
  std::vector<Tile> tiles;
  for (const auto& corners : parallel_domain(mesh.surface, map).corners) tiles.emplace_back(corners);
  Screen screen(angles, heights);
  for (std::size_t t = 0; t < tiles.size(); ++t)
    if (tiles[t].is_upright()) screen.paint(tiles[t], static_cast<int>(t));
  CrossingPoints result;
  for (std::size_t k = 0; k < screen.finds().size(); ++k) {
    Find& find = screen.finds()[k];
    if (find.triangle < 0) search_everywhere(find, screen.place(k), tiles);
    result.outside = std::max(result.outside, -find.depth);
    result.points.push_back(interpolated(mesh, tiles[find.triangle], find));
  }
  return result;
}

std::vector<SpacePoint> rim_points(const OneForms& forms, const SlitMap& map, int loop,
                                   const std::vector<double>& angles) {
  Path path = path_around(forms, map, loop);
  if (loop == map.inner) {
    std::reverse(path.angle.begin(), path.angle.end());
    std::reverse(path.point.begin(), path.point.end());
  }
  // Twice round, from before the first angle.
  const double shift = full_turn * std::floor((angles.front() - path.angle.front()) / full_turn);
  for (double& angle : path.angle) angle += shift;
  const std::size_t size = path.angle.size();
  for (std::size_t k = 0; k < size; ++k) path.add(path.angle[k] + full_turn, path.point[k]);
  path.add(path.angle[size] + full_turn, path.point[size]);
  return reached(path, angles);
}

SlitPoints slit_points(const OneForms& forms, const SlitMap& map, const Slit& slit,
                       const std::vector<double>& angles) {
  Path path = path_around(forms, map, slit.loop);
  const auto [low, high] = std::minmax_element(path.angle.begin(), path.angle.end());
  const long first = low - path.angle.begin();
  const long last = high - path.angle.begin();
  // Vertices come near the start of the slit only.
  const double shift = full_turn * std::round((slit.start - *low) / full_turn);
  for (double& angle : path.angle) angle += shift;
  const ClosedPath loop(std::move(path));
  const double start = loop.turning_place(first);
  const double end = loop.turning_place(last < first ? last + loop.size() : last);
  SlitPoints result{loop.point(start), loop.point(end), {}, {}};
  // Where angles grow, the surface, to the left, is above.
  Path above;
  above.add(slit.start, result.start);
  for (long k = static_cast<long>(std::ceil(start)); static_cast<double>(k) < end; ++k)
    above.add(loop.angle(k), loop.vertex(k));
  above.add(slit.end, result.end);
  result.above = reached(above, angles);
  Path below;
  below.add(slit.start, result.start);
  const double back = start + static_cast<double>(loop.size());
  for (long k = static_cast<long>(std::floor(back)); static_cast<double>(k) > end; --k)
    below.add(loop.angle(k), loop.vertex(k));
  below.add(slit.end, result.end);
  result.below = reached(below, angles);
  return result;
}

} // namespace tetrarch::slit
