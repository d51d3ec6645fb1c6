// SPDX-License-Identifier: GPL-2.0-or-later
#include "view.hpp"

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace tetrarch::diagram {
namespace {

using namespace numeric;
using Rational = boost::multiprecision::mpq_rational;

constexpr double certain_digits = 1e-8;

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

bool are_in_line(const Point& p, const Point& q, const Point& r) {
  const auto coordinate = [](const Point& a, std::size_t i) { return Rational(a[i]); };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((coordinate(q, i) - coordinate(p, i)) * (coordinate(r, j) - coordinate(p, j)) !=
        (coordinate(q, j) - coordinate(p, j)) * (coordinate(r, i) - coordinate(p, i)))
      return false;
  }
  return true;
}

/// Where along a segment another one crosses it, from 0 to 1.
Rational exact_parameter(const Curve& curve, const Point& eye, int segment, int other) {
  const auto point = [&curve](int s, int end) { return curve.points[curve.segments[s][end]]; };
  const Rational a = volume(eye, point(other, 0), point(other, 1), point(segment, 0));
  const Rational b = volume(eye, point(other, 0), point(other, 1), point(segment, 1));
  return a / (a - b);
}

} // namespace

/// False: something falls together; `meeting` says what.
bool View::find_crossings(const Progress& progress) {
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

/// Rounded coordinates in the picture, which only choose what is to be tested.
void View::flatten() {
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

View::Flat View::flat_box(int s) const {
  constexpr double slack = 1e-9; // the eye's angle: far more than the rounding above
  const auto& a = flat_[curve_.segments[s][0]];
  const auto& b = flat_[curve_.segments[s][1]];
  return {{std::min(a[0], b[0]) - slack, std::min(a[1], b[1]) - slack},
          {std::max(a[0], b[0]) + slack, std::max(a[1], b[1]) + slack}};
}

/// The mean length of a segment in the picture, but no less than what makes a few cells for each.
double View::cell_size() const {
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

std::vector<std::int64_t> View::cells(int s, double size) const {
  const Flat box = flat_box(s);
  const auto number = [size](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
  std::vector<std::int64_t> keys;
  for (std::int64_t i = number(box.low[0]); i <= number(box.high[0]); ++i)
    for (std::int64_t j = number(box.low[1]); j <= number(box.high[1]); ++j)
      keys.push_back((i << 32) ^ (j & 0xffffffff));
  return keys;
}

/// Notes a crossing of the two; false if they touch in the picture.
bool View::test(int s, int t) {
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
bool View::test_neighbors(int s, int t) {
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

/// Where along `segment` the other one crosses it, from 0 to 1; none where doubles cannot say to some
/// digits.
std::optional<double> View::parameter(int segment, int other) const {
  const Vector normal = cross(from(other) - eye_, to(other) - eye_);
  const double a = dot(normal, from(segment) - eye_);
  const double b = dot(normal, to(segment) - eye_);
  const double size = norm(from(other) - eye_) * norm(to(other) - eye_) *
                      (norm(from(segment) - eye_) + norm(to(segment) - eye_));
  constexpr double error = 1e-14;
  if (!(error * size < certain_digits * std::fabs(a - b))) return std::nullopt;
  return a / (a - b);
}

/// False if three segments cross in one point.
bool View::sort_along() {
  along_.assign(curve_.segments.size(), {});
  for (int x = 0; x < static_cast<int>(crossings_.size()); ++x)
    for (const int s : {crossings_[x].first, crossings_[x].second}) along_[s].push_back(x);
  for (int s = 0; s < static_cast<int>(along_.size()); ++s)
    if (!sort_in_doubles(s) && !sort_exactly(s)) return false;
  return true;
}

/// False, and nothing is changed, where two are too near one another.
bool View::sort_in_doubles(int s) {
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

bool View::sort_exactly(int s) {
  std::vector<std::pair<Rational, int>> places;
  for (const int x : along_[s]) places.emplace_back(exact_parameter(curve_, eye_, s, other_at(x, s)), x);
  std::sort(places.begin(), places.end());
  for (std::size_t k = 0; k < places.size(); ++k) {
    along_[s][k] = places[k].second;
    if (k == 0 || places[k].first != places[k - 1].first) continue;
    meeting_ = {crossings_[places[k].second].first, crossings_[places[k].second].second};
    return false;
  }
  return true;
}

Diagram View::diagram() const {
  return assembled(curve_, eye_, crossings_, along_);
}

} // namespace tetrarch::diagram
