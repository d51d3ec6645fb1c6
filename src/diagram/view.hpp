// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the eye sees of a curve from one place: which segments cross, and in which order.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/numeric/predicates.hpp"

#include <optional>
#include <vector>

namespace tetrarch::diagram {

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

/// What the eye sees from one place.
class View {
public:
  View(const Curve& curve, const numeric::Point& eye) : curve_(curve), eye_(eye) {}

  /// False: something falls together; `meeting` says what.
  bool find_crossings(const Progress& progress);

  std::size_t crossing_count() const { return crossings_.size(); }
  Meeting meeting() const { return meeting_; }
  bool meets_in_space() const { return meets_in_space_; }

  Diagram diagram() const;

private:
  struct Flat {
    std::array<double, 2> low;
    std::array<double, 2> high;
  };

  const numeric::Point& from(int s) const { return curve_.points[curve_.segments[s][0]]; }
  const numeric::Point& to(int s) const { return curve_.points[curve_.segments[s][1]]; }

  void flatten();
  Flat flat_box(int s) const;
  double cell_size() const;
  std::vector<std::int64_t> cells(int s, double size) const;
  numeric::Sign turn(const numeric::Point& a, const numeric::Point& b, const numeric::Point& c) const {
    return numeric::volume_sign(eye_, a, b, c);
  }
  bool test(int s, int t);
  bool test_neighbors(int s, int t);
  bool sort_along();
  bool sort_in_doubles(int s);
  bool sort_exactly(int s);
  std::optional<double> parameter(int segment, int other) const;
  int other_at(int x, int s) const {
    return crossings_[x].first == s ? crossings_[x].second : crossings_[x].first;
  }

  const Curve& curve_;
  numeric::Point eye_;
  std::vector<std::array<double, 2>> flat_;
  std::vector<Crossing> crossings_;
  std::vector<std::vector<int>> along_; ///< of each segment, its crossings in order
  Meeting meeting_;
  bool meets_in_space_ = false;
};

/// The diagram along the segments, with the crossings in the order in which each segment meets them. Points
/// of valence 2 are no nodes, unless a circle would have none.
Diagram assembled(const Curve& curve, const numeric::Point& eye, const std::vector<Crossing>& crossings,
                  const std::vector<std::vector<int>>& along);

} // namespace tetrarch::diagram
