// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/moves.hpp"

#include "draft.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <set>
#include <string>

namespace tetrarch::diagram {
namespace {

/// The dart is one of three at a vertex.
bool at_trivalent_vertex(const Diagram& diagram, int dart) {
  const Node& node = diagram.node(diagram.node_of(dart));
  return !node.crossing && node.darts.size() == 3;
}

/// The diagram as seen from a dart: nodes in the order in which a walk meets them. Everything else follows.
std::string seen_from(const Diagram& diagram, int root) {
  std::vector<int> entry(static_cast<std::size_t>(diagram.node_count()),
                         -1); // the dart by which each was met
  std::vector<int> number(entry.size(), -1);
  std::vector<int> order;
  const auto meet = [&](int dart) {
    const int n = diagram.node_of(dart);
    if (number[n] >= 0) return;
    number[n] = static_cast<int>(order.size());
    entry[n] = dart;
    order.push_back(n);
  };
  std::string text;
  meet(root);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int n = order[k];
    const int valence = static_cast<int>(diagram.node(n).darts.size());
    text += !diagram.node(n).crossing ? 'v' : diagram.is_over(entry[n]) ? 'o' : 'u';
    for (int step = 0; step < valence; ++step) {
      const int far = diagram.opposite(diagram.turned(entry[n], step));
      meet(far);
      const int there = diagram.node_of(far);
      const int size = static_cast<int>(diagram.node(there).darts.size());
      const int place = (diagram.place_of(far) - diagram.place_of(entry[there]) + size) % size;
      text += std::to_string(number[there]) + "." + std::to_string(place) + ",";
    }
  }
  return text;
}

/// Equal exactly for diagrams (in one part) that a homeomorphism of the sphere takes to one another.
/// O(darts^2).
std::string canonical_code(const Diagram& diagram) {
  std::string best;
  for (int d = 0; d < diagram.dart_count(); ++d) {
    std::string text = seen_from(diagram, d);
    if (best.empty() || text < best) best = std::move(text);
  }
  return best;
}

/// The IH move along the whole edge that starts with the dart, with a twist of the two other edges before it.
std::optional<Diagram> slid(const Diagram& diagram, int dart, int twist) {
  constexpr int most_passed = 2;
  Diagram out = diagram;
  for (int passed = 0; out.at_crossing(out.opposite(dart)); ++passed) {
    if (passed == most_passed) return std::nullopt;
    out = with_vertex_passed(out, dart);
  }
  if (!is_ih(out, dart)) return std::nullopt;
  if (twist != 0) out = with_twist(out, out.turned(dart, 1), twist > 0);
  // The twist exchanges the two other darts' arcs and leaves this one alone.
  return is_ih(out, dart) ? std::optional(with_ih(out, dart)) : std::nullopt;
}

class HandlebodySearch {
public:
  explicit HandlebodySearch(const Progress& progress) : progress_(progress) {}

  Diagram run(Diagram start) {
    restart(std::move(start));
    for (int expanded = 0; !queue_.empty() && expanded < most_expanded;) {
      const Diagram here = queue_.front();
      queue_.pop_front();
      ++expanded;
      if (expand(here)) expanded = 0;
      if (crossing_count(best_) == 0) break;
    }
    return best_;
  }

private:
  void restart(Diagram from) {
    queue_.clear();
    seen_.clear();
    seen_.insert(canonical_code(from));
    queue_.push_back(from);
    best_ = std::move(from);
  }

  /// True if something better was found, from which the search has begun anew.
  bool expand(const Diagram& here) {
    for (int d = 0; d < here.dart_count(); ++d) {
      if (!at_trivalent_vertex(here, d)) continue;
      for (const int twist : {0, 1, -1}) {
        progress_.step("sliding edges");
        const std::optional<Diagram> other = slid(here, d, twist);
        if (!other) continue;
        Diagram small = simplified(*other, progress_.silent());
        if (parts(small).count != 1) continue;
        if (crossing_count(small) < crossing_count(best_)) {
          restart(std::move(small));
          return true;
        }
        if (crossing_count(small) == crossing_count(best_) && seen_.insert(canonical_code(small)).second)
          queue_.push_back(std::move(small));
      }
    }
    return false;
  }

  static constexpr int most_expanded = 60;
  const Progress& progress_;
  Diagram best_;
  std::deque<Diagram> queue_;
  std::set<std::string> seen_;
};

} // namespace

Diagram with_vertex_passed(const Diagram& diagram, int dart) {
  if (dart < 0 || dart >= diagram.dart_count() || !at_trivalent_vertex(diagram, dart) ||
      !diagram.at_crossing(diagram.opposite(dart)))
    throw PreconditionError("no vertex of valence 3 comes to a crossing along this dart");
  // The edge runs east to a crossing, whose darts are west, south, east, north. At the vertex the other darts
  // are the left one and the right one.
  const int west = diagram.opposite(dart);
  const int south = diagram.turned(west, 1);
  const int east = diagram.turned(west, 2);
  const int north = diagram.turned(west, 3);
  const int left = diagram.turned(dart, 1);
  const int right = diagram.turned(dart, 2);
  Draft draft(diagram);
  // The crossing that there is becomes that of the left edge; a new one to its south is that of the right
  // edge.
  const int lower = draft.add_node(4, true, diagram.is_over(west) ? 0 : 1);
  // What led into the picture, and by which dart it comes in afterwards.
  const std::array<std::pair<int, int>, 5> ports{
      {{left, west}, {right, lower}, {north, north}, {south, lower + 1}, {east, dart}}};
  for (const auto& [before, after] : ports) {
    int far = diagram.opposite(before);
    for (const auto& [other, image] : ports)
      if (far == other) {
        far = image;
        break;
      }
    draft.join(after, far);
  }
  draft.join(east, left);
  draft.join(lower + 2, right);
  draft.join(south, lower + 3);
  return std::move(draft).finished();
}

bool is_ih(const Diagram& diagram, int dart) {
  const int far = diagram.opposite(dart);
  return at_trivalent_vertex(diagram, dart) && at_trivalent_vertex(diagram, far) &&
         diagram.node_of(dart) != diagram.node_of(far);
}

Diagram with_ih(const Diagram& diagram, int dart) {
  if (dart < 0 || dart >= diagram.dart_count() || !is_ih(diagram, dart))
    throw PreconditionError("the dart's arc joins no two vertices of valence 3");
  const int far = diagram.opposite(dart);
  const int a = diagram.turned(dart, 1);
  const int b = diagram.turned(dart, 2);
  const int c = diagram.turned(far, 1);
  const int f = diagram.turned(far, 2);
  Draft draft(diagram);
  draft.nodes[diagram.node_of(dart)].darts = {dart, b, c};
  draft.nodes[diagram.node_of(far)].darts = {far, f, a};
  return std::move(draft).finished();
}

Diagram simplified_handlebody(const Diagram& diagram, const Progress& progress) {
  Diagram start = simplified(diagram, progress);
  if (parts(start).count != 1) return start;
  return HandlebodySearch(progress).run(std::move(start));
}

} // namespace tetrarch::diagram
