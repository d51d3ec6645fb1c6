// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/numeric/predicates.hpp"

#include <algorithm>

namespace tetrarch::diagram {
namespace {

using numeric::Point;
using numeric::Sign;
using numeric::volume_sign;

struct Box {
  Point low;
  Point high;
};

Box box_of(const Point& a, const Point& b) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(a[i], b[i]);
    box.high[i] = std::max(a[i], b[i]);
  }
  return box;
}

Box joined(const Box& a, const Box& b) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

bool are_apart(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return true;
  return false;
}

/// Whether a segment certainly misses a triangle; false where they touch, or lie in one plane.
bool misses(const Point& d, const Point& e, const Point& a, const Point& b, const Point& c) {
  const Sign below = volume_sign(a, b, c, d);
  const Sign above = volume_sign(a, b, c, e);
  if (below == Sign::zero || above == Sign::zero) return false;
  if (below == above) return true;
  const Sign ab = volume_sign(d, e, a, b);
  const Sign bc = volume_sign(d, e, b, c);
  const Sign ca = volume_sign(d, e, c, a);
  if (ab == Sign::zero || bc == Sign::zero || ca == Sign::zero) return false;
  return ab != bc || bc != ca;
}

class Reduction {
public:
  explicit Reduction(const Curve& curve)
      : points_(curve.points), segments_(curve.segments), at_(curve.points.size()) {
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      for (const int p : segments_[s]) at_[p].push_back(static_cast<int>(s));
      boxes_.push_back(box_of(points_[segments_[s][0]], points_[segments_[s][1]]));
    }
    alive_.assign(segments_.size(), true);
  }

  Curve run(const Progress& progress) {
    for (bool again = true; again;) {
      again = false;
      for (std::size_t p = 0; p < points_.size(); ++p) {
        if (p % 64 == 0) progress.step("points removed", -1);
        again |= remove(static_cast<int>(p));
      }
      pack();
    }
    return finished();
  }

private:
  int other(int segment, int p) const {
    return segments_[segment][0] == p ? segments_[segment][1] : segments_[segment][0];
  }

  bool remove(int b) {
    if (at_[b].size() != 2) return false;
    const int first = at_[b][0];
    const int second = at_[b][1];
    const int a = other(first, b);
    const int c = other(second, b);
    if (a == c || are_joined(a, c) || !is_free(a, b, c, first, second)) return false;
    segments_[first] = {a, c};
    boxes_[first] = box_of(points_[a], points_[c]);
    alive_[second] = false;
    std::replace(at_[c].begin(), at_[c].end(), second, first);
    at_[b].clear();
    return true;
  }

  /// A triangle stays one.
  bool are_joined(int a, int c) const {
    return std::any_of(at_[a].begin(), at_[a].end(), [&](int s) { return other(s, a) == c; });
  }

  bool is_free(int a, int b, int c, int first, int second) const {
    const Point& pa = points_[a];
    const Point& pb = points_[b];
    const Point& pc = points_[c];
    const Box box = joined(boxes_[first], boxes_[second]);
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (!alive_[s] || are_apart(box, boxes_[s])) continue;
      if (static_cast<int>(s) == first || static_cast<int>(s) == second) continue;
      const auto& [d, e] = segments_[s];
      // One that starts at a corner meets the triangle there only, unless it lies in its plane.
      if (d == a || d == c || e == a || e == c) {
        const int end = d == a || d == c ? e : d;
        if (volume_sign(pa, pb, pc, points_[end]) == Sign::zero) return false;
      } else if (!misses(points_[d], points_[e], pa, pb, pc)) {
        return false;
      }
    }
    return true;
  }

  /// Forgets the segments that are gone.
  void pack() {
    std::size_t count = 0;
    for (auto& list : at_) list.clear();
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (!alive_[s]) continue;
      segments_[count] = segments_[s];
      boxes_[count] = boxes_[s];
      for (const int p : segments_[count]) at_[p].push_back(static_cast<int>(count));
      ++count;
    }
    segments_.resize(count);
    boxes_.resize(count);
    alive_.assign(count, true);
  }

  Curve finished() const {
    Curve out;
    std::vector<int> image(points_.size(), -1);
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (!at_[p].empty()) {
        image[p] = static_cast<int>(out.points.size());
        out.points.push_back(points_[p]);
      }
    for (const auto& [a, b] : segments_) out.segments.push_back({image[a], image[b]});
    return out;
  }

  std::vector<Point> points_;
  std::vector<std::array<int, 2>> segments_;
  std::vector<Box> boxes_;
  std::vector<bool> alive_;
  std::vector<std::vector<int>> at_; ///< of each point its segments
};

} // namespace

Curve reduced(const Curve& curve, const Progress& progress) {
  return Reduction(curve).run(progress);
}

} // namespace tetrarch::diagram
