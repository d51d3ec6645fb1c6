// SPDX-License-Identifier: GPL-2.0-or-later
#include "draft.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/numeric/predicates.hpp"

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace tetrarch::diagram {
namespace {

using namespace numeric;
using Rational = boost::multiprecision::mpq_rational;

/// A place where two segments fall together in the picture.
struct Meeting {
  int first = -1;
  int second = -1;
};

/// Two segments that cross in the picture.
struct Crossing {
  int first = 0;
  int second = 0;
  bool first_over = false;
  bool to_left = false; ///< the second runs to the left of the first
};

/// The volume of four points as six times a rational number.
Rational volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<Rational, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i] = Rational(b[i]) - Rational(a[i]);
    m[1][i] = Rational(c[i]) - Rational(a[i]);
    m[2][i] = Rational(d[i]) - Rational(a[i]);
  }
  const Rational first = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]);
  const Rational second = m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]);
  const Rational third = m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return first + second + third;
}

/// What the eye sees from one place.
class View {
public:
  View(const Curve& curve, const Point& eye) : curve_(curve), eye_(eye) {}

  /// False: something falls together; `meeting` says what.
  bool find_crossings(const Progress& progress) {
    flatten();
    const double cell = cell_size();
    std::unordered_map<std::int64_t, std::vector<int>> grid;
    for (int s = 0; s < static_cast<int>(curve_.segments.size()); ++s) {
      if (s % 256 == 0) progress.step("projection", -1);
      std::vector<int> near;
      for (const std::int64_t key : cells(s, cell)) {
        for (const int other : grid[key]) near.push_back(other);
        grid[key].push_back(s);
      }
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      for (const int other : near)
        if (!test(other, s)) return false;
    }
    return sort_along();
  }

  std::size_t crossing_count() const { return crossings_.size(); }
  Meeting meeting() const { return meeting_; }
  bool meets_in_space() const { return meets_in_space_; }

  Diagram diagram() const;

private:
  struct Flat {
    std::array<double, 2> low;
    std::array<double, 2> high;
  };

  const Point& from(int s) const { return curve_.points[curve_.segments[s][0]]; }
  const Point& to(int s) const { return curve_.points[curve_.segments[s][1]]; }

  /// Rounded coordinates in the picture, which only choose what is to be tested.
  void flatten() {
    Point middle{};
    for (const Point& p : curve_.points) middle = middle + (1.0 / curve_.points.size()) * p;
    const Vector axis = *direction(middle - eye_);
    const Vector help = std::fabs(axis[0]) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    const Vector right = *direction(cross(axis, help));
    const Vector up = cross(right, axis);
    for (const Point& p : curve_.points) {
      const Vector v = p - eye_;
      const double depth = dot(v, axis);
      flat_.push_back({dot(v, right) / depth, dot(v, up) / depth});
    }
  }

  Flat flat_box(int s) const {
    constexpr double slack = 1e-9; // the eye's angle: far more than the rounding above
    const auto& a = flat_[curve_.segments[s][0]];
    const auto& b = flat_[curve_.segments[s][1]];
    return {{std::min(a[0], b[0]) - slack, std::min(a[1], b[1]) - slack},
            {std::max(a[0], b[0]) + slack, std::max(a[1], b[1]) + slack}};
  }

  /// The mean length of a segment in the picture, but no less than what makes a few cells for each.
  double cell_size() const {
    double sum = 0;
    double extent = 0;
    for (int s = 0; s < static_cast<int>(curve_.segments.size()); ++s) {
      const Flat box = flat_box(s);
      sum += std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
      extent = std::max({extent, std::fabs(box.low[0]), std::fabs(box.high[0]), std::fabs(box.low[1]),
                         std::fabs(box.high[1])});
    }
    const double count = static_cast<double>(curve_.segments.size());
    return std::max(sum / count, extent / (4 * std::sqrt(count)));
  }

  std::vector<std::int64_t> cells(int s, double size) const {
    const Flat box = flat_box(s);
    const auto number = [size](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
    std::vector<std::int64_t> keys;
    for (std::int64_t i = number(box.low[0]); i <= number(box.high[0]); ++i)
      for (std::int64_t j = number(box.low[1]); j <= number(box.high[1]); ++j)
        keys.push_back((i << 32) ^ (j & 0xffffffff));
    return keys;
  }

  Sign turn(const Point& a, const Point& b, const Point& c) const { return volume_sign(eye_, a, b, c); }

  /// Notes a crossing of the two; false if they touch in the picture.
  bool test(int s, int t) {
    const auto& [a, b] = curve_.segments[s];
    const auto& [c, d] = curve_.segments[t];
    if (a == c || a == d || b == c || b == d) return test_neighbors(s, t);
    const Flat box = flat_box(s);
    const Flat other = flat_box(t);
    for (std::size_t i = 0; i < 2; ++i)
      if (box.high[i] < other.low[i] || other.high[i] < box.low[i]) return true;
    const Sign c_side = turn(from(s), to(s), from(t));
    const Sign d_side = turn(from(s), to(s), to(t));
    const Sign a_side = turn(from(t), to(t), from(s));
    const Sign b_side = turn(from(t), to(t), to(s));
    const bool touch =
        c_side == Sign::zero || d_side == Sign::zero || a_side == Sign::zero || b_side == Sign::zero;
    if (touch) {
      const bool apart =
          (c_side == d_side && c_side != Sign::zero) || (a_side == b_side && a_side != Sign::zero);
      if (apart) return true;
      meeting_ = {s, t};
      return false;
    }
    if (c_side == d_side || a_side == b_side) return true;
    const Sign height = volume_sign(from(s), to(s), from(t), to(t));
    if (height == Sign::zero) {
      meeting_ = {s, t};
      meets_in_space_ = true;
      return false;
    }
    // Look along s, with the end of t to the left: the four points span a negative volume where t is nearer.
    crossings_.push_back({s, t, height != d_side, d_side == Sign::negative});
    return true;
  }

  /// Two segments with a common point fall together if they run the same way. In a straight line of space
  /// they may go on.
  bool test_neighbors(int s, int t) {
    const auto& [a, b] = curve_.segments[s];
    const auto& [c, d] = curve_.segments[t];
    const int common = a == c || a == d ? a : b;
    const Point& p = curve_.points[common];
    const Point& q = curve_.points[a == common ? b : a];
    const Point& r = curve_.points[c == common ? d : c];
    if (turn(p, q, r) != Sign::zero) return true;
    if (are_in_line(p, q, r)) {
      if (dot(q - p, r - p) < 0) return true;
      meets_in_space_ = true;
    }
    meeting_ = {s, t};
    return false;
  }

  static bool are_in_line(const Point& p, const Point& q, const Point& r) {
    const auto coordinate = [](const Point& a, std::size_t i) { return Rational(a[i]); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((coordinate(q, i) - coordinate(p, i)) * (coordinate(r, j) - coordinate(p, j)) !=
          (coordinate(q, j) - coordinate(p, j)) * (coordinate(r, i) - coordinate(p, i)))
        return false;
    }
    return true;
  }

  /// Where along `segment` the other one crosses it, from 0 to 1; none where doubles cannot say to some
  /// digits.
  std::optional<double> parameter(int segment, int other) const {
    const Vector normal = cross(from(other) - eye_, to(other) - eye_);
    const double a = dot(normal, from(segment) - eye_);
    const double b = dot(normal, to(segment) - eye_);
    const double size = norm(from(other) - eye_) * norm(to(other) - eye_) *
                        (norm(from(segment) - eye_) + norm(to(segment) - eye_));
    constexpr double error = 1e-14;
    if (!(error * size < certain_digits * std::fabs(a - b))) return std::nullopt;
    return a / (a - b);
  }
  Rational exact_parameter(int segment, int other) const {
    const Rational a = volume(eye_, from(other), to(other), from(segment));
    const Rational b = volume(eye_, from(other), to(other), to(segment));
    return a / (a - b);
  }

  /// False if three segments cross in one point.
  bool sort_along() {
    along_.assign(curve_.segments.size(), {});
    for (int x = 0; x < static_cast<int>(crossings_.size()); ++x)
      for (const int s : {crossings_[x].first, crossings_[x].second}) along_[s].push_back(x);
    for (int s = 0; s < static_cast<int>(along_.size()); ++s)
      if (!sort_in_doubles(s) && !sort_exactly(s)) return false;
    return true;
  }

  int other_at(int x, int s) const {
    return crossings_[x].first == s ? crossings_[x].second : crossings_[x].first;
  }

  /// False, and nothing is changed, where two are too near one another.
  bool sort_in_doubles(int s) {
    std::vector<std::pair<double, int>> places;
    for (const int x : along_[s]) {
      const std::optional<double> place = parameter(s, other_at(x, s));
      if (!place) return along_[s].size() == 1;
      places.emplace_back(*place, x);
    }
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
      if (!(places[k + 1].first - places[k].first > 4 * certain_digits)) return false;
    for (std::size_t k = 0; k < places.size(); ++k) along_[s][k] = places[k].second;
    return true;
  }

  bool sort_exactly(int s) {
    std::vector<std::pair<Rational, int>> places;
    for (const int x : along_[s]) places.emplace_back(exact_parameter(s, other_at(x, s)), x);
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k < places.size(); ++k) {
      along_[s][k] = places[k].second;
      if (k == 0 || places[k].first != places[k - 1].first) continue;
      meeting_ = {crossings_[places[k].second].first, crossings_[places[k].second].second};
      return false;
    }
    return true;
  }

  static constexpr double certain_digits = 1e-8;

  const Curve& curve_;
  Point eye_;
  std::vector<std::array<double, 2>> flat_;
  std::vector<Crossing> crossings_;
  std::vector<std::vector<int>> along_; ///< of each segment, its crossings in order
  Meeting meeting_;
  bool meets_in_space_ = false;
};

/// Builds the diagram along the segments. Points of valence 2 are no nodes, unless a circle would have none.
class Assembly {
public:
  Assembly(const Curve& curve, const Point& eye, const std::vector<Crossing>& crossings,
           const std::vector<std::vector<int>>& along)
      : curve_(curve), eye_(eye), at_(curve.points.size()), node_(curve.points.size(), -1) {
    for (int s = 0; s < static_cast<int>(curve.segments.size()); ++s)
      for (int end = 0; end < 2; ++end) at_[curve.segments[s][end]].push_back(2 * s + end);
    for (const Crossing& c : crossings) {
      // Darts: back along the first, then counterclockwise.
      first_dart_.push_back(draft_.add_node(4, true, c.first_over ? 0 : 1));
    }
    for (int p = 0; p < static_cast<int>(at_.size()); ++p)
      if (at_[p].size() != 2) add_vertex(p);
    run(crossings, along);
  }

  Diagram finished() && { return std::move(draft_).finished(); }

private:
  Sign turn(int a, int b, int c) const {
    return volume_sign(eye_, curve_.points[a], curve_.points[b], curve_.points[c]);
  }
  int far_end(int end) const { return curve_.segments[end / 2][1 - end % 2]; }

  /// A node with the segments at a point, counterclockwise as the eye sees them: those to the left of the
  /// first, then those to its right, each of the two by turns.
  void add_vertex(int p) {
    std::vector<int>& ends = at_[p];
    const int first = far_end(ends.front());
    std::sort(ends.begin() + 1, ends.end(), [&](int x, int y) {
      const bool x_left = is_left(turn(p, first, far_end(x)));
      const bool y_left = is_left(turn(p, first, far_end(y)));
      return x_left != y_left ? x_left : is_left(turn(p, far_end(x), far_end(y)));
    });
    node_[p] = draft_.add_node(static_cast<int>(ends.size()), false, 0);
  }

  /// The eye sees three points turn left where it and they span a negative volume: it looks at them from
  /// outside, as the tetrahedron's face is seen from its fourth corner.
  static bool is_left(Sign s) { return s == Sign::negative; }

  int dart_at(int p, int end) const {
    const auto& ends = at_[p];
    return node_[p] + static_cast<int>(std::find(ends.begin(), ends.end(), end) - ends.begin());
  }

  /// The darts of crossing x by which segment s comes in and goes out.
  std::pair<int, int> passage(const Crossing& c, int x, int s) const {
    const int first = first_dart_[x];
    if (s == c.first) return {first, first + 2};
    // Darts: the first's past, the right, the first's future, the left.
    return c.to_left ? std::pair{first + 1, first + 3} : std::pair{first + 3, first + 1};
  }

  void run(const std::vector<Crossing>& crossings, const std::vector<std::vector<int>>& along) {
    done_.assign(curve_.segments.size(), false);
    for (int p = 0; p < static_cast<int>(at_.size()); ++p)
      if (node_[p] >= 0)
        for (const int end : at_[p])
          if (!done_[end / 2]) follow(p, end, dart_at(p, end), crossings, along);
    for (int s = 0; s < static_cast<int>(curve_.segments.size()); ++s)
      if (!done_[s]) circle(s, crossings, along);
  }

  /// Walks from a node along segments until the next node that is a vertex.
  void follow(int p, int end, int dart, const std::vector<Crossing>& crossings,
              const std::vector<std::vector<int>>& along) {
    while (true) {
      const int s = end / 2;
      done_[s] = true;
      const bool forward = end % 2 == 0;
      const auto& list = along[s];
      for (std::size_t k = 0; k < list.size(); ++k) {
        const int x = list[forward ? k : list.size() - 1 - k];
        auto [in, out] = passage(crossings[x], x, s);
        if (!forward) std::swap(in, out);
        draft_.join(dart, in);
        dart = out;
      }
      const int arriving = end ^ 1;
      p = curve_.segments[s][arriving % 2];
      if (node_[p] >= 0) {
        draft_.join(dart, dart_at(p, arriving));
        return;
      }
      end = at_[p][0] == arriving ? at_[p][1] : at_[p][0];
    }
  }

  /// A closed curve without vertices gets one at its first point.
  void circle(int s, const std::vector<Crossing>& crossings, const std::vector<std::vector<int>>& along) {
    const int p = curve_.segments[s][0];
    node_[p] = draft_.add_node(2, false, 0);
    follow(p, 2 * s, dart_at(p, 2 * s), crossings, along);
  }

  const Curve& curve_;
  const Point& eye_;
  Draft draft_;
  std::vector<std::vector<int>> at_; ///< of each point, 2 * segment + end
  std::vector<int> node_;            ///< of each point its first dart; -1: it is passed over
  std::vector<int> first_dart_;      ///< of each crossing
  std::vector<bool> done_;
};

Diagram View::diagram() const {
  return Assembly(curve_, eye_, crossings_, along_).finished();
}

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
