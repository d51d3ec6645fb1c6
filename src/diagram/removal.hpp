// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Taking nodes out of a diagram.

#include "draft.hpp"

#include <utility>
#include <vector>

namespace tetrarch::diagram {

/// The diagram without some of its crossings and points of valence 2: the strands run on as if these were not
/// there. Circles without any node left get a point.
class Removal {
public:
  Removal(const Diagram& diagram, const std::vector<int>& nodes)
      : diagram_(diagram), gone_(static_cast<std::size_t>(diagram.node_count()), false),
        image_(static_cast<std::size_t>(diagram.dart_count()), -1) {
    for (const int n : nodes) gone_[n] = true;
  }

  /// Two darts of one node change places.
  void swap(int a, int b) { swapped_ = {a, b}; }

  Diagram run() {
    for (int n = 0; n < diagram_.node_count(); ++n) {
      if (gone_[n]) continue;
      const Node& node = diagram_.node(n);
      int dart = draft_.add_node(static_cast<int>(node.darts.size()), node.crossing, node.over);
      for (const int d : node.darts) image_[swapped(d)] = dart++;
    }
    std::vector<bool> passed(image_.size(), false);
    for (int d = 0; d < diagram_.dart_count(); ++d)
      if (image_[d] >= 0) draft_.join(image_[d], image_[far_end(d, passed)]);
    for (int d = 0; d < diagram_.dart_count(); ++d) {
      if (image_[d] >= 0 || passed[d]) continue;
      for (int at = d; !passed[at]; at = onward(diagram_.opposite(at)))
        passed[at] = passed[diagram_.opposite(at)] = true;
      const int first = draft_.add_node(2, false, 0);
      draft_.join(first, first + 1);
    }
    return std::move(draft_).finished();
  }

private:
  int swapped(int dart) const {
    if (dart == swapped_.first) return swapped_.second;
    return dart == swapped_.second ? swapped_.first : dart;
  }
  int onward(int dart) const { return diagram_.turned(dart, diagram_.at_crossing(dart) ? 2 : 1); }

  int far_end(int dart, std::vector<bool>& passed) const {
    int end = diagram_.opposite(dart);
    while (image_[end] < 0) {
      passed[end] = true;
      end = onward(end);
      passed[end] = true;
      end = diagram_.opposite(end);
    }
    return end;
  }

  const Diagram& diagram_;
  std::vector<bool> gone_;
  std::vector<int> image_; ///< of each dart; -1: its crossing is gone
  std::pair<int, int> swapped_{-1, -1};
  Draft draft_;
};

/// Whether a dart stands at a vertex of the graph, of valence 3 or more.
inline bool is_vertex(const Diagram& diagram, int dart) {
  return !diagram.at_crossing(dart) && diagram.node(diagram.node_of(dart)).darts.size() > 2;
}

} // namespace tetrarch::diagram
