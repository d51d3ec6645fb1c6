// SPDX-License-Identifier: GPL-2.0-or-later
#include "tails.hpp"

#include "bundled_strands.hpp"
#include "corner_sides.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/surface/cuts.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::surface {
namespace {

using numeric::infinity;
using Ways = numeric::ShortestPaths<Side>;

/// The corners of the triangles at a copy of a vertex of the surface cut open, from right to left, where
/// the right side of the first is on the boundary.
std::vector<SideEnd> sector(const Surface& open, SideEnd first) {
  std::vector<SideEnd> corners{first};
  for (Side s = left_of(first); !open.is_boundary(s); s = left_of(corners.back()))
    corners.push_back(start_of(open.mate(s)));
  return corners;
}

class Gatherer {
public:
  Gatherer(MarkedSurface& surface, std::vector<int> points, const Progress& progress)
      : surface_(surface), point_(std::move(points)), progress_(progress),
        handle_at_(static_cast<std::size_t>(surface.surface.vertex_count()), -1), gate_(point_.size()) {
    for (std::size_t k = 1; k < point_.size(); ++k) handle_at_[point_[k]] = static_cast<int>(k);
  }

  /// The handle near the middle of the ways.
  int middle();

  SplitCount run() && {
    choose_start();
    while (open_gates()) progress_.step("leading loops to the base");
    const Surface open = cut_open(surface_);
    const std::vector<SideEnd> start = starts(open);
    const Ways ways = ways_from(open, start);
    progress_.step("leading loops to the base");
    count_.edges += lay_bundled_strands(surface_, start, ways.last, {gate_.begin() + 1, gate_.end()});
    return count_;
  }

private:
  /// A corner at the point of a handle.
  struct Target {
    SideEnd corner;
    double length = infinity; ///< of the way there
  };

  /// The handle, if it is not at the base, whose point is vertex v; -1: none.
  int handle_at(int v) const { return v < static_cast<int>(handle_at_.size()) ? handle_at_[v] : -1; }
  std::vector<SideEnd> starts(const Surface& open) const;
  Ways ways_from(const Surface& open, const std::vector<SideEnd>& start) const;
  std::vector<Target> targets(const Ways& ways) const;
  int nearest_handle(const Surface& open, int triangle) const;
  void choose_start();
  bool open_gates();
  void open_gate(int handle, SideEnd corner);

  MarkedSurface& surface_;
  std::vector<int> point_;
  const Progress& progress_;
  std::vector<int> handle_at_;
  std::vector<Side> gate_; ///< of each handle, the side to go in by, seen from inside
  SplitCount count_;
  std::pair<int, int> start_; ///< the marks around the copy of the base where the ways start
};

/// The corners at the copy of the base where the ways start.
std::vector<SideEnd> Gatherer::starts(const Surface& open) const {
  for (const Corner& c : corners(surface_, open))
    if (surface_.surface.vertex(c.end) == point_[0] && std::pair(c.before, c.after) == start_)
      return sector(open, c.end);
  throw PreconditionError("the base has no such copy");
}

/// Through the triangles; the last steps are the sides crossed, seen from before.
Ways Gatherer::ways_from(const Surface& open, const std::vector<SideEnd>& start) const {
  std::vector<char> is_shut(surface_.mark.size(), 0);
  for (const Side gate : gate_)
    if (gate.exists())
      for (const Side s : {gate.next(), gate.previous()})
        is_shut[s.value] = is_shut[surface_.surface.mate(s).value] = 1;
  std::vector<int> roots;
  roots.reserve(start.size());
  for (const SideEnd c : start) roots.push_back(c.side.triangle());
  const auto steps = [&](int t, const auto& visit) {
    for (const Side s : sides_of(t))
      if (!open.is_boundary(s) && !is_shut[s.value])
        visit(open.mate(s).triangle(), dual_length(surface_, s), s);
  };
  return numeric::shortest_paths(static_cast<std::size_t>(open.triangle_count()), roots, Side(), steps);
}

/// The nearest corner at the point of each handle.
auto Gatherer::targets(const Ways& ways) const -> std::vector<Target> {
  std::vector<Target> nearest(point_.size());
  for (int t = 0; t < surface_.surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int handle = handle_at(surface_.surface.corners(t)[c]);
      if (handle >= 0 && ways.distance[t] < nearest[handle].length)
        nearest[handle] = {corner_at(t, c), ways.distance[t]};
    }
  return nearest;
}

/// The copy of the base from which the ways are shortest in total.
void Gatherer::choose_start() {
  const Surface open = cut_open(surface_);
  std::pair<int, int> best;
  double least = infinity;
  for (const Corner& c : corners(surface_, open)) {
    if (surface_.surface.vertex(c.end) != point_[0]) continue;
    progress_.step("leading loops to the base");
    double total = 0;
    const std::vector<Target> nearest = targets(ways_from(open, sector(open, c.end)));
    for (std::size_t k = 1; k < nearest.size(); ++k) total += nearest[k].length;
    if (total < least) {
      least = total;
      best = {c.before, c.after};
    }
  }
  start_ = best;
}

int Gatherer::middle() {
  choose_start();
  const Surface open = cut_open(surface_);
  const Ways ways = ways_from(open, starts(open));
  std::vector<int> by_distance(ways.distance.size());
  std::iota(by_distance.begin(), by_distance.end(), 0);
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [&](int a, int b) { return ways.distance[a] > ways.distance[b]; });
  std::vector<std::size_t> handles_beyond(by_distance.size(), 0);
  const std::vector<Target> all = targets(ways);
  for (std::size_t k = 1; k < all.size(); ++k) ++handles_beyond[all[k].corner.side.triangle()];
  for (const int t : by_distance) {
    if (2 * handles_beyond[t] > point_.size()) return nearest_handle(open, t);
    if (ways.last[t].exists()) handles_beyond[ways.last[t].triangle()] += handles_beyond[t];
  }
  return 0;
}

int Gatherer::nearest_handle(const Surface& open, int triangle) const {
  const Ways ways = ways_from(open, {corner_at(triangle, 0)});
  const std::vector<Target> all = targets(ways);
  const auto nearest = std::min_element(all.begin() + 1, all.end(),
                                        [](const Target& a, const Target& b) { return a.length < b.length; });
  double to_base = infinity;
  for (int t = 0; t < open.triangle_count(); ++t)
    for (const int v : surface_.surface.corners(t))
      if (v == point_[0]) to_base = std::min(to_base, ways.distance[t]);
  return to_base <= nearest->length ? 0 : static_cast<int>(nearest - all.begin());
}

/// Opens the gates that are still missing where the ways arrive, at most one in a triangle. Returns whether
/// one is missing still.
bool Gatherer::open_gates() {
  const Surface open = cut_open(surface_);
  const std::vector<Target> nearest = targets(ways_from(open, starts(open)));
  std::set<int> taken;
  bool is_missing = false;
  for (std::size_t k = 1; k < point_.size(); ++k) {
    if (gate_[k].exists()) continue;
    if (taken.insert(nearest[k].corner.side.triangle()).second)
      open_gate(static_cast<int>(k), nearest[k].corner);
    else
      is_missing = true;
  }
  return is_missing;
}

///        corner              Two vertices z and w are put into the triangle; the gate leads in across zw.
///         /|\ .
///        / | \  .            None of its corners but one is on a loop, so strands that turn around that one
///       /  z--w   .          meet no end of another strand in it.
///      / .  `  `.   .
///     a ---------------b
void Gatherer::open_gate(int handle, SideEnd corner) {
  const int first_new = surface_.surface.triangle_count();
  const int c = corner.corner();
  split_face(surface_, corner.side.triangle());
  ++count_.faces;
  // The part without a, opposite of which is the new vertex: `Surface::split_face`.
  const int part = c == 2 ? corner.side.triangle() : first_new + c;
  split_edge(surface_, Side(part, c));
  ++count_.edges;
  gate_[handle] = Side(part, c);
}

} // namespace

SplitCount lay_tails(MarkedSurface& surface, Handles& handles, bool base_is_free, const Progress& progress) {
  if (handles.point.size() < 2) return {};
  if (base_is_free)
    std::swap(handles.point[0], handles.point[Gatherer(surface, handles.point, progress).middle()]);
  return Gatherer(surface, handles.point, progress).run();
}

} // namespace tetrarch::surface
