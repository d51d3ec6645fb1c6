// SPDX-License-Identifier: GPL-2.0-or-later
#include "handle.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/surface/canonical_loops.hpp"
#include "tetrarch/surface/cuts.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace tetrarch::surface {
namespace {

using numeric::infinity;

/// The letters of a cut graph that alternate with another one on the boundary of the disk: x .. y .. x .. y.
std::vector<int> linked_letters(const std::vector<int>& word, int first_letter) {
  std::map<int, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (std::abs(word[k]) >= first_letter) at[std::abs(word[k])].push_back(k);
  const auto alternate = [](const auto& x, const auto& y) {
    const auto inside = std::count_if(y.begin(), y.end(), [&](auto k) { return x[0] < k && k < x[1]; });
    return inside == 1;
  };
  std::vector<int> linked;
  for (const auto& [letter, x] : at)
    if (std::any_of(at.begin(), at.end(), [&, &own = x](const auto& y) { return alternate(own, y.second); }))
      linked.push_back(letter);
  return linked;
}

/// Some end at a vertex.
SideEnd some_end_at(const Surface& surface, int vertex) {
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.from(Side(k)) == vertex) return {Side(k), true};
  throw PreconditionError("there is no vertex " + std::to_string(vertex));
}

class Builder {
public:
  Builder(MarkedSurface& surface, int base, const Tolls& tolls, const Progress& progress)
      : surface_(surface), base_(base), tolls_(tolls), progress_(progress) {
    split_loops_at_base();
  }

  SplitCount count() const { return count_; }

  void add_handle() {
    ++handles_;
    choose_start();
    mark_cut_locus();
    const Crossing crossing = find_crossing();
    const int vertex = crossing.vertex < 0 ? split_arc(crossing.arc) : crossing.vertex;
    const int a = 2 * handles_ - 1;
    lay(
        a, [&](const Surface& open) { return start(open); },
        [&](const Surface& open) { return copies(open, vertex, crossing.arc); });
    lay(
        -a, [&](const Surface& open) { return beside(open, a); },
        [&](const Surface& open) { return copies(open, vertex, -crossing.arc); });
    unmark_cut_locus();
    lay_second_loop(a);
  }

private:
  /// Where a loop crosses the cut locus.
  struct Crossing {
    int vertex = -1; ///< inside the arc; -1 if no arc that serves has one
    int arc = 0;
    double length = infinity; ///< of the loop
  };

  /// The arcs of the cut locus get this number and the following.
  int first_arc() const { return 2 * handles_ + 1; }
  bool is_at_base(const Corner& corner) const { return surface_.surface.vertex(corner.end) == base_; }
  void lay(int m, const Places& from, const Places& to) {
    const SplitCount count = lay_path(surface_, m, from, to, progress_, tolls_);
    count_.edges += count.edges;
    count_.faces += count.faces;
  }
  template <class Wanted>
  std::vector<SideEnd> places(const Surface& open, Wanted wanted) const {
    std::vector<SideEnd> ends;
    for (const Corner& corner : corners(surface_, open))
      if (wanted(corner)) ends.push_back(corner.end);
    return ends;
  }
  std::vector<SideEnd> start(const Surface& open) const {
    if (handles_ == 1) return {some_end_at(surface_.surface, base_)};
    return places(open,
                  [&](const Corner& c) { return is_at_base(c) && c.before == before_ && c.after == after_; });
  }
  /// The corners at the base from which loop m goes out or comes in.
  std::vector<SideEnd> beside(const Surface& open, int m) const {
    return places(open, [&](const Corner& c) {
      return is_at_base(c) && (std::abs(c.before) == m || std::abs(c.after) == m);
    });
  }
  /// The copy of a vertex inside an arc on that bank of it.
  std::vector<SideEnd> copies(const Surface& open, int vertex, int mark) const {
    return places(open, [&](const Corner& c) {
      return surface_.surface.vertex(c.end) == vertex && c.before == mark && c.after == mark;
    });
  }

  void split_loops_at_base();
  void choose_start();
  std::vector<char> grow_disk(const Surface& open) const;
  void mark_cut_locus();
  void unmark_cut_locus() {
    for (int& m : surface_.mark)
      if (std::abs(m) >= first_arc()) m = 0;
  }
  Crossing find_crossing() const;
  int split_arc(int arc);
  void lay_second_loop(int a);

  MarkedSurface& surface_;
  int base_;
  const Tolls& tolls_;
  const Progress& progress_;
  SplitCount count_;
  int handles_ = 0;
  int before_ = 0; ///< the marks around the corner where the next handle starts
  int after_ = 0;
  std::map<std::pair<int, int>, double> bounds_; ///< of the lengths of loops that start at these marks
};

/// So that the triangles around the base differ.
void Builder::split_loops_at_base() {
  for (int k = 0; k < surface_.surface.side_count(); ++k) {
    const Side s(k);
    if (surface_.surface.from(s) != base_ || surface_.surface.to(s) != base_) continue;
    split_edge(surface_, s);
    ++count_.edges;
  }
}

/// The corner between two commutators from which the next loop is shortest. Always taking the first, say,
/// lets loops follow earlier ones, and their lengths grow exponentially with the genus.
///
/// Cuts make no loop shorter, so that a length found for an earlier handle is a bound from below. Only where
/// the bound is the least is the length found anew: a few corners for each handle and not all of them.
void Builder::choose_start() {
  if (handles_ == 1) return;
  const std::vector<int> word = boundary_word(surface_);
  std::size_t first = 0;
  while (!is_product_of_commutators(word, first)) ++first;
  // The bound, the order on the boundary from the first letter of the word on, and the marks.
  using Start = std::tuple<double, std::size_t, std::pair<int, int>>;
  std::priority_queue<Start, std::vector<Start>, std::greater<>> queue;
  std::map<std::pair<int, int>, double> bounds; // of the corners that there still are
  // A single commutator may be read from each of its letters on.
  const std::size_t step = word.size() == 4 ? 1 : 4;
  for (std::size_t k = first % step; k < word.size(); k += step) {
    const std::pair marks(word[(k + word.size() - 1) % word.size()], word[k]);
    const auto known = bounds_.find(marks);
    bounds[marks] = known == bounds_.end() ? -1 : known->second;
    queue.emplace(bounds[marks], k, marks);
  }
  bounds_ = std::move(bounds);
  std::map<std::pair<int, int>, char> is_exact;
  for (;;) {
    const auto [bound, order, marks] = queue.top();
    queue.pop();
    std::tie(before_, after_) = marks;
    if (std::exchange(is_exact[marks], 1)) return;
    if (progress_.stop_requested()) throw Stopped();
    mark_cut_locus();
    const double length = find_crossing().length;
    unmark_cut_locus();
    bounds_[marks] = length;
    queue.emplace(length, order, marks);
  }
}

/// The dual tree of shortest paths from the triangles around the start: for each side whether it is crossed.
std::vector<char> Builder::grow_disk(const Surface& open) const {
  const SideEnd x = start(open).front();
  const auto cost = [&](Side s) {
    // The triangles around the start come first, so that no arc ends there.
    if (open.from(s) == open.vertex(x) || open.to(s) == open.vertex(x)) return 0.0;
    return dual_length(surface_, s);
  };
  const auto steps = [&](int t, const auto& visit) {
    for (const Side s : sides_of(t))
      if (!open.is_boundary(s)) visit(open.mate(s).triangle(), cost(s), s);
  };
  const auto paths = numeric::shortest_paths(static_cast<std::size_t>(open.triangle_count()),
                                             {x.side.triangle()}, Side(), steps);
  std::vector<char> crossed(surface_.mark.size(), 0);
  for (const Side s : paths.last)
    if (s.exists()) crossed[s.value] = crossed[open.mate(s).value] = 1;
  return crossed;
}

void Builder::mark_cut_locus() {
  MarkedSurface open(cut_open(surface_));
  mark_uncrossed(open, grow_disk(open.surface));
  for (std::size_t k = 0; k < open.mark.size(); ++k) {
    const int arc = open.mark[k];
    if (arc != 0) surface_.mark[k] = arc > 0 ? first_arc() - 1 + arc : -(first_arc() - 1 - arc);
  }
}

/// The vertex inside a linked arc through which the shortest loop goes.
Builder::Crossing Builder::find_crossing() const {
  const Surface disk = cut_open(surface_);
  const std::vector<double> length = path_lengths(surface_, disk, start(disk), tolls_);
  const std::vector<int> linked = linked_letters(runs(surface_, boundary_curves(disk).front()), first_arc());
  // A vertex inside an arc has two copies, one on each bank.
  std::map<std::pair<int, int>, double> both;
  for (const Corner& c : corners(surface_, disk)) {
    const int arc = std::abs(c.after);
    if (c.before == c.after && std::binary_search(linked.begin(), linked.end(), arc))
      both[{surface_.surface.vertex(c.end), arc}] += length[disk.vertex(c.end)];
  }
  if (linked.empty()) throw PreconditionError("the surface has no handle");
  Crossing best{-1, linked.front(), infinity};
  for (const auto& [place, sum] : both)
    if (sum < best.length) best = {place.first, place.second, sum};
  return best;
}

/// Splits an arc that is a single edge.
int Builder::split_arc(int arc) {
  ++count_.edges;
  const auto edge = std::find(surface_.mark.begin(), surface_.mark.end(), arc);
  return split_edge(surface_, Side(static_cast<int>(edge - surface_.mark.begin())));
}

/// From the boundary curve that is one bank of loop a alone to a corner of the other bank.
void Builder::lay_second_loop(int a) {
  const auto is_alone = [&](const Corner& c, int m) {
    return is_at_base(c) && c.before == m && c.after == m;
  };
  const auto alone = [&](const Surface& open, int m) {
    return places(open, [&](const Corner& c) { return is_alone(c, m); });
  };
  const int bank = alone(cut_open(surface_), a).empty() ? -a : a;
  lay(
      a + 1, [&](const Surface& open) { return alone(open, bank); },
      [&](const Surface& open) {
        return places(
            open, [&](const Corner& c) { return is_at_base(c) && (c.before == -bank || c.after == -bank); });
      });
}

} // namespace

std::vector<int> runs(const MarkedSurface& surface, const std::vector<SideEnd>& curve) {
  std::vector<int> word;
  for (const SideEnd e : curve)
    if (word.empty() || word.back() != surface[e.side]) word.push_back(surface[e.side]);
  if (word.size() > 1 && word.front() == word.back()) word.pop_back();
  return word;
}

bool is_product_of_commutators(const std::vector<int>& word, std::size_t start) {
  const auto letter = [&](std::size_t k) { return word[(start + k) % word.size()]; };
  if (word.size() % 4 != 0) return false;
  for (std::size_t k = 0; k < word.size(); k += 4)
    if (letter(k) != -letter(k + 2) || letter(k + 1) != -letter(k + 3)) return false;
  return true;
}

SplitCount lay_handle(MarkedSurface& surface, int base, const Tolls& tolls, const Progress& progress) {
  Builder builder(surface, base, tolls, progress);
  builder.add_handle();
  return builder.count();
}

SplitCount lay_handles_in_turn(MarkedSurface& surface, int base, int handles, const Progress& progress) {
  const Tolls none;
  Builder builder(surface, base, none, progress);
  for (int k = 0; k < handles; ++k) {
    progress.step("laying loops", static_cast<double>(k) / handles);
    builder.add_handle();
  }
  return builder.count();
}

} // namespace tetrarch::surface
