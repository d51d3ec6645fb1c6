// SPDX-License-Identifier: GPL-2.0-or-later
#include "reroute.hpp"

#include "draft.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace tetrarch::diagram {
namespace {

/// A way from a node on that passes over all it meets, or under all: it starts at a dart and ends at the
/// other one, neither of them on one of the crossings between.
struct Strand {
  int start = -1;
  int end = -1;
  bool over = true;
  std::vector<int> entered; ///< the dart by which each crossing is entered
};

/// The longest such way that starts at the dart; nothing if it runs back into its own crossings.
std::optional<Strand> strand_from(const Diagram& diagram, int dart, bool over) {
  Strand strand{dart, -1, over, {}};
  int end = diagram.opposite(dart);
  while (diagram.at_crossing(end) && diagram.is_over(end) == over) {
    if (end == dart) return std::nullopt; // a circle
    strand.entered.push_back(end);
    end = diagram.opposite(diagram.turned(end, 2));
    if (strand.entered.size() > static_cast<std::size_t>(diagram.dart_count())) return std::nullopt;
  }
  strand.end = end;
  for (const int d : strand.entered)
    if (diagram.node_of(d) == diagram.node_of(dart) || diagram.node_of(d) == diagram.node_of(end))
      return std::nullopt;
  return strand;
}

/// Lays a strand along the shortest way through the regions that are there without it.
class Rerouting {
public:
  Rerouting(const Diagram& diagram, const Strand& strand) : diagram_(diagram), strand_(strand) {}

  /// Nothing if no way is shorter.
  std::optional<Diagram> run() {
    if (!lift()) return std::nullopt;
    number_regions();
    const auto way = shortest_way();
    if (!way) return std::nullopt;
    return laid(*way);
  }

private:
  /// Takes the strand away: what it crossed is joined, its two ends are left. False if a circle would have
  /// nothing left but itself.
  bool lift() {
    draft_ = Draft(diagram_);
    lifted_.assign(static_cast<std::size_t>(diagram_.dart_count()), false);
    lifted_[strand_.start] = lifted_[strand_.end] = true;
    for (const int d : strand_.entered) {
      for (int k = 0; k < 4; ++k) lifted_[diagram_.turned(d, k)] = true;
      // Others may have been joined to its darts before: follow what they are now.
      const int right = draft_.opposite[diagram_.turned(d, 1)];
      const int left = draft_.opposite[diagram_.turned(d, 3)];
      if (right == diagram_.turned(d, 3)) return false;
      draft_.join(right, left);
    }
    return true;
  }

  /// The next dart round its node, clockwise, that is not lifted.
  int turned_right(int dart) const {
    int d = diagram_.turned(dart, -1);
    while (lifted_[d] && d != dart) d = diagram_.turned(d, -1);
    return d;
  }
  /// Darts that have the corners to their left which the strand may start from: at a crossing its own. From a
  /// vertex it may rise between any two edges, since it passes over (or under) them all.
  std::vector<int> corners(int lifted) const {
    std::vector<int> darts;
    for (int d = turned_right(lifted); !lifted_[d]; d = turned_right(d)) {
      darts.push_back(d);
      if (diagram_.at_crossing(lifted) || turned_right(d) == darts.front()) break;
    }
    return darts;
  }

  void number_regions() {
    region_.assign(static_cast<std::size_t>(diagram_.dart_count()), -1);
    for (int first = 0; first < diagram_.dart_count(); ++first) {
      if (lifted_[first] || region_[first] >= 0) continue;
      for (int d = first; region_[d] < 0; d = turned_right(draft_.opposite[d])) region_[d] = regions_;
      ++regions_;
    }
  }

  /// Corners to start and to end at, and darts whose arcs are crossed from their left to their right.
  struct Way {
    int first = -1;
    int last = -1;
    std::vector<int> darts;
  };

  std::optional<Way> shortest_way() const {
    std::vector<std::vector<int>> darts(static_cast<std::size_t>(regions_));
    for (int d = 0; d < diagram_.dart_count(); ++d)
      if (!lifted_[d]) darts[region_[d]].push_back(d);
    std::vector<int> came_by(static_cast<std::size_t>(regions_), -1); // a start region: its corner
    std::vector<int> steps(static_cast<std::size_t>(regions_), -1);
    std::queue<int> front;
    for (const int d : corners(strand_.start))
      if (int& r = steps[region_[d]]; r < 0) {
        r = 0;
        came_by[region_[d]] = d;
        front.push(region_[d]);
      }
    while (!front.empty()) {
      const int r = front.front();
      front.pop();
      for (const int d : darts[r]) {
        const int beyond = region_[draft_.opposite[d]];
        if (steps[beyond] >= 0) continue;
        steps[beyond] = steps[r] + 1;
        came_by[beyond] = d;
        front.push(beyond);
      }
    }
    Way way;
    int best = static_cast<int>(strand_.entered.size());
    for (const int d : corners(strand_.end))
      if (const int far = steps[region_[d]]; far >= 0 && far < best) {
        best = far;
        way.last = d;
      }
    if (way.last < 0) return std::nullopt; // none, or another part
    int r = region_[way.last];
    for (; steps[r] > 0; r = region_[came_by[r]]) way.darts.push_back(came_by[r]);
    way.first = came_by[r];
    std::reverse(way.darts.begin(), way.darts.end());
    return way;
  }

  /// Moves an end of the strand to the corner to the left of a dart.
  void place(int end, int corner) {
    std::vector<int>& darts = draft_.nodes[diagram_.node_of(end)].darts;
    darts.erase(std::find(darts.begin(), darts.end(), end));
    darts.insert(std::find(darts.begin(), darts.end(), corner) + 1, end);
  }

  Diagram laid(const Way& way) {
    if (!diagram_.at_crossing(strand_.start)) place(strand_.start, way.first);
    if (!diagram_.at_crossing(strand_.end)) place(strand_.end, way.last);
    int loose = strand_.start;
    for (const int d : way.darts) {
      // Darts: back along the strand, to the right, on, to the left. The strand comes from the left of d, so
      // that the node of d is to its right.
      const int first = draft_.add_node(4, true, strand_.over ? 0 : 1);
      const int beyond = draft_.opposite[d];
      draft_.join(loose, first);
      draft_.join(d, first + 1);
      draft_.join(beyond, first + 3);
      loose = first + 2;
    }
    draft_.join(loose, strand_.end);
    return without_lifted();
  }

  /// Drops the crossings that the strand had.
  Diagram without_lifted() const {
    std::vector<bool> gone(draft_.nodes.size(), false);
    for (const int d : strand_.entered) gone[diagram_.node_of(d)] = true;
    Draft out;
    std::vector<int> image(draft_.opposite.size(), -1);
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      if (gone[n]) continue;
      const Node& node = draft_.nodes[n];
      int dart = out.add_node(static_cast<int>(node.darts.size()), node.crossing, node.over);
      for (const int d : node.darts) image[d] = dart++;
    }
    for (std::size_t d = 0; d < image.size(); ++d)
      if (image[d] >= 0) out.join(image[d], image[draft_.opposite[d]]);
    return std::move(out).finished();
  }

  const Diagram& diagram_;
  const Strand& strand_;
  Draft draft_;
  std::vector<bool> lifted_;
  std::vector<int> region_;
  int regions_ = 0;
};

} // namespace

std::optional<Diagram> with_shorter_strand(const Diagram& diagram, const Progress& progress) {
  for (int d = 0; d < diagram.dart_count(); ++d)
    for (const bool over : {true, false}) {
      // It starts where it cannot be longer.
      if (diagram.at_crossing(d) && diagram.is_over(d) == over) continue;
      const std::optional<Strand> strand = strand_from(diagram, d, over);
      if (!strand || strand->entered.empty()) continue;
      progress.step("crossings removed", -1);
      if (auto shorter = Rerouting(diagram, *strand).run()) return shorter;
    }
  return std::nullopt;
}

} // namespace tetrarch::diagram
