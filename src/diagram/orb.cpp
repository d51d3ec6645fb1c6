// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/orb.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/marked.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace tetrarch::diagram {
namespace {

using format::OrbDrawing;

/// A direction in the plane, y going up. Coordinates are so small that 64 bits hold all products.
struct Heading {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

std::int64_t cross(const Heading& a, const Heading& b) {
  return a.x * b.y - a.y * b.x;
}

int sign(std::int64_t x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// The drawing as a diagram. The darts 2p and 2p + 1 are the halves of piece p of a segment between two
/// crossings or ends, in order along the segments.
class Drawn {
public:
  Drawn(const OrbDrawing& drawing, const std::string& source) : drawing_(drawing), source_(source) {
    check_segments();
    cut_segments();
    join_arcs();
  }

  /// Of arcs that stay: how many there are.
  int kept_count() const { return static_cast<int>(std::count(drilled_.begin(), drilled_.end(), false)); }

  /// `orders` are those of the arcs that stay, in their order.
  MarkedDiagram finished(const std::vector<double>& orders) && {
    std::vector<Node> nodes = crossing_nodes();
    for (std::size_t p = 0; p < at_.size(); ++p)
      if (!at_[p].empty()) nodes.push_back({around(static_cast<int>(p)), false, 0});
    nodes = without_passed(std::move(nodes));
    const std::vector<int> kept = numbered_by_arcs(nodes);
    std::vector<int> opposite(kept.size());
    for (std::size_t d = 0; d < kept.size(); ++d) opposite[d] = image_[opposite_[kept[d]]];
    for (Node& n : nodes)
      for (int& d : n.darts) d = image_[d];
    if (const std::string wrong = why_not(nodes, opposite); !wrong.empty())
      throw InputError({source_, drawing_.segments.front().line}, "no diagram is drawn: " + wrong);
    MarkedDiagram out{{std::move(nodes), std::move(opposite)}, {}};
    for (const int d : kept) out.fates.push_back(fate(arc_[d], orders));
    return out;
  }

private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw InputError({source_, line}, message);
  }

  Heading between(int p, int q) const {
    const auto& a = drawing_.points[p];
    const auto& b = drawing_.points[q];
    return {std::int64_t{b[0]} - a[0], std::int64_t{a[1]} - b[1]};
  }
  Heading heading(int segment) const {
    return between(drawing_.segments[segment].from, drawing_.segments[segment].to);
  }
  int turn(int p, int q, int r) const { return sign(cross(between(p, q), between(p, r))); }

  enum class Meeting { none, crossing, other };
  /// How two segments without a common end meet.
  Meeting meeting(int s, int t) const {
    const auto& a = drawing_.segments[s];
    const auto& b = drawing_.segments[t];
    const int from_s = turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to);
    const int from_t = turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to);
    if (from_s > 0 || from_t > 0) return Meeting::none;
    if (from_s < 0 && from_t < 0) return Meeting::crossing;
    // An end of one lies on the line of the other.
    const auto box = [this](int axis, const OrbDrawing::Segment& x) {
      return std::minmax(drawing_.points[x.from][axis], drawing_.points[x.to][axis]);
    };
    for (int axis = 0; axis < 2; ++axis)
      if (box(axis, a).second < box(axis, b).first || box(axis, b).second < box(axis, a).first)
        return Meeting::none;
    return Meeting::other;
  }

  void check_segments() {
    std::map<std::pair<int, int>, int> told;
    for (const OrbDrawing::Crossing& x : drawing_.crossings)
      if (!told.emplace(std::minmax(x.over, x.under), x.line).second)
        fail(x.line,
             "segments " + std::to_string(x.over) + " and " + std::to_string(x.under) + " cross twice");
    const int count = static_cast<int>(drawing_.segments.size());
    for (int s = 0; s < count; ++s)
      for (int t = s + 1; t < count; ++t) {
        const auto& a = drawing_.segments[s];
        const auto& b = drawing_.segments[t];
        const bool touch = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
        const Meeting found = touch ? Meeting::none : meeting(s, t);
        const auto at = told.find({s, t});
        const std::string names = "segments " + std::to_string(s) + " and " + std::to_string(t);
        if (at != told.end() && found != Meeting::crossing) fail(at->second, names + " do not cross");
        if (at == told.end() && found == Meeting::crossing)
          fail(b.line, names + " cross, and no crossing says how");
        if (found == Meeting::other) fail(b.line, names + " meet in an end of one");
        if (at != told.end()) told.erase(at);
      }
    if (!told.empty()) fail(told.begin()->second, "a segment does not cross itself");
    if (count == 0) fail(0, "the drawing has no segments");
  }

  /// A passage of a segment through a crossing.
  struct Passage {
    double along = 0;
    int crossing = 0;
    bool over = false;
  };

  void cut_segments() {
    std::vector<std::vector<Passage>> passages(drawing_.segments.size());
    for (int x = 0; x < static_cast<int>(drawing_.crossings.size()); ++x) {
      const auto& c = drawing_.crossings[x];
      passages[c.over].push_back({c.along_over, x, true});
      passages[c.under].push_back({c.along_under, x, false});
    }
    at_.resize(drawing_.points.size());
    in_.resize(drawing_.crossings.size());
    int dart = 0;
    for (int s = 0; s < static_cast<int>(drawing_.segments.size()); ++s) {
      std::sort(passages[s].begin(), passages[s].end(),
                [](const Passage& a, const Passage& b) { return a.along < b.along; });
      at_[drawing_.segments[s].from].push_back({dart, s});
      for (const Passage& p : passages[s]) {
        dart += 2;
        in_[p.crossing][p.over ? 0 : 1] = dart - 1;
      }
      at_[drawing_.segments[s].to].push_back({dart + 1, s});
      for (dart += 2; static_cast<int>(opposite_.size()) < dart;) {
        const int d = static_cast<int>(opposite_.size());
        opposite_.insert(opposite_.end(), {d + 1, d});
        segment_.insert(segment_.end(), {s, s});
      }
    }
  }

  /// Arcs run through crossings and through points where two segments meet, both drilled or neither; they are
  /// numbered by their first segments.
  void join_arcs() {
    std::vector<int> parent(drawing_.segments.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const auto& ends : at_)
      if (ends.size() == 2 && same_kind(ends[0].segment, ends[1].segment))
        parent[numeric::find_root(parent, ends[0].segment)] = numeric::find_root(parent, ends[1].segment);
    std::vector<int> number(parent.size(), -1);
    std::vector<int> arc_of_segment(parent.size());
    for (int s = 0; s < static_cast<int>(parent.size()); ++s) {
      int& n = number[numeric::find_root(parent, s)];
      if (n < 0) {
        n = static_cast<int>(drilled_.size());
        drilled_.push_back(drawing_.segments[s].drilled);
      }
      arc_of_segment[s] = n;
    }
    for (const int s : segment_) arc_.push_back(arc_of_segment[s]);
  }

  bool same_kind(int s, int t) const { return drawing_.segments[s].drilled == drawing_.segments[t].drilled; }

  /// The upper strand runs from dart 0 to dart 2.
  std::vector<Node> crossing_nodes() const {
    std::vector<Node> nodes;
    for (std::size_t x = 0; x < in_.size(); ++x) {
      const auto& c = drawing_.crossings[x];
      const auto [over, under] = in_[x];
      const bool to_left = cross(heading(c.over), heading(c.under)) > 0;
      // Coming along the upper strand, what the lower one brings is on the right if it goes to the left.
      if (to_left)
        nodes.push_back({{over, under, over + 1, under + 1}, true, 0});
      else
        nodes.push_back({{over, under + 1, over + 1, under}, true, 0});
    }
    return nodes;
  }

  struct End {
    int dart = 0;
    int segment = 0;
  };

  /// The darts at a point counterclockwise: those that go up (or straight to the right) first.
  std::vector<int> around(int p) {
    std::vector<End> ends = at_[p];
    const auto out = [&](const End& e) {
      const auto& s = drawing_.segments[e.segment];
      return between(p, s.from == p ? s.to : s.from);
    };
    const auto is_up = [](const Heading& h) { return h.y > 0 || (h.y == 0 && h.x > 0); };
    std::sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
      const Heading x = out(a);
      const Heading y = out(b);
      return is_up(x) != is_up(y) ? is_up(x) : cross(x, y) > 0;
    });
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Heading x = out(ends[k]);
      const Heading y = out(ends[k + 1]);
      if (is_up(x) == is_up(y) && cross(x, y) == 0)
        fail(drawing_.segments[ends[k + 1].segment].line,
             "segments " + std::to_string(ends[k].segment) + " and " + std::to_string(ends[k + 1].segment) +
                 " leave point " + std::to_string(p) + " in one direction");
    }
    std::vector<int> darts;
    darts.reserve(ends.size());
    for (const End& e : ends) darts.push_back(e.dart);
    return darts;
  }

  /// Whether the node is a point along an arc, which is then joined there.
  bool pass_through(const Node& node) {
    if (node.crossing || node.darts.size() != 2) return false;
    const int a = node.darts[0];
    const int b = node.darts[1];
    if (!same_kind(segment_[a], segment_[b]) || opposite_[a] == b) return false;
    const int before = opposite_[a];
    const int after = opposite_[b];
    opposite_[before] = after;
    opposite_[after] = before;
    return true;
  }

  std::vector<Node> without_passed(std::vector<Node> nodes) {
    std::vector<Node> left;
    for (Node& n : nodes)
      if (!pass_through(n)) left.push_back(std::move(n));
    return left;
  }

  /// The darts of the nodes, those of the first arc first, and their new numbers.
  std::vector<int> numbered_by_arcs(const std::vector<Node>& nodes) {
    std::vector<int> kept;
    for (const Node& n : nodes) kept.insert(kept.end(), n.darts.begin(), n.darts.end());
    std::sort(kept.begin(), kept.end(),
              [this](int d, int e) { return arc_[d] != arc_[e] ? arc_[d] < arc_[e] : d < e; });
    image_.assign(opposite_.size(), -1);
    for (std::size_t k = 0; k < kept.size(); ++k) image_[kept[k]] = static_cast<int>(k);
    return kept;
  }

  Fate fate(int arc, const std::vector<double>& orders) const {
    if (drilled_[arc]) return std::nullopt;
    return orders[std::count(drilled_.begin(), drilled_.begin() + arc, false)];
  }

  const OrbDrawing& drawing_;
  const std::string& source_;
  std::vector<std::vector<End>> at_;   ///< of each point
  std::vector<std::array<int, 2>> in_; ///< of each crossing, by which the upper and the lower strand come in
  std::vector<int> opposite_;          ///< of each dart, as are
  std::vector<int> segment_;           ///< this
  std::vector<int> arc_;               ///< and this
  std::vector<int> image_;             ///< and this: the number in the end
  std::vector<bool> drilled_;          ///< of each arc
};

} // namespace

std::optional<MarkedDiagram> read_orb_diagram(std::string_view text, const std::string& source,
                                              bool drilled) {
  std::optional<OrbDrawing> drawing = format::read_orb_drawing(text, source);
  if (!drawing) return std::nullopt;
  if (drilled)
    for (OrbDrawing::Segment& s : drawing->segments) s.drilled = true;
  Drawn drawn(*drawing, source);
  const auto curves = static_cast<int>(drawing->orders.size());
  if (!drilled && drawn.kept_count() != curves)
    throw InputError({source, 0}, "the drawing has " + std::to_string(drawn.kept_count()) +
                                      " edges that are not drilled, the triangulation " +
                                      std::to_string(curves) +
                                      " singular curves: their orders cannot be told");
  return std::move(drawn).finished(drawing->orders);
}

} // namespace tetrarch::diagram
