// SPDX-License-Identifier: GPL-2.0-or-later
#include "draft.hpp"
#include "view.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::diagram {
namespace {

using namespace numeric;

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

} // namespace

Diagram assembled(const Curve& curve, const Point& eye, const std::vector<Crossing>& crossings,
                  const std::vector<std::vector<int>>& along) {
  return Assembly(curve, eye, crossings, along).finished();
}

} // namespace tetrarch::diagram
