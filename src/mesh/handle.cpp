// SPDX-License-Identifier: GPL-2.0-or-later
#include "handle.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/cuts.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace tetrarch::mesh {
namespace {

using numeric::infinity;

/// The loops have the marks 1 and 2, the arcs of the cut locus 3, 4, ...
constexpr int first_loop = 1;
constexpr int second_loop = 2;
constexpr int first_arc = 3;

/// The letters of the cut locus that alternate with another one on the boundary of the disk: x .. y .. x ..
/// y.
std::vector<int> linked_letters(const std::vector<int>& word) {
  std::map<int, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (std::abs(word[k]) >= first_arc) at[std::abs(word[k])].push_back(k);
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
SideEnd end_at(const Surface& surface, int vertex) {
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.from(Side(k)) == vertex) return {Side(k), true};
  throw PreconditionError("there is no vertex " + std::to_string(vertex));
}

class Builder {
public:
  Builder(MarkedSurface& surface, int base, const Tolls& tolls, const Progress& progress)
      : surface_(surface), base_(base), tolls_(tolls), progress_(progress) {}

  SplitCount run() && {
    split_loops_at_base();
    mark_cut_locus();
    const Crossing crossing = find_crossing();
    const int vertex = crossing.vertex < 0 ? split_arc(crossing.arc) : crossing.vertex;
    lay(
        first_loop, [&](const Surface&) { return start(); },
        [&](const Surface& open) { return copies(open, vertex, crossing.arc); });
    lay(
        -first_loop, [&](const Surface& open) { return beside_first_loop(open); },
        [&](const Surface& open) { return copies(open, vertex, -crossing.arc); });
    for (int& m : surface_.mark)
      if (std::abs(m) >= first_arc) m = 0;
    lay(
        second_loop, [&](const Surface& open) { return bank(open, first_loop); },
        [&](const Surface& open) { return bank(open, -first_loop); });
    return count_;
  }

private:
  /// Where a loop crosses the cut locus.
  struct Crossing {
    int vertex = -1; ///< inside the arc; -1 if no arc that serves has one
    int arc = 0;
    double length = infinity; ///< of the loop
  };

  /// So that the triangles around the base differ.
  void split_loops_at_base() {
    for (int k = 0; k < surface_.surface.side_count(); ++k) {
      const Side s(k);
      if (surface_.surface.from(s) != base_ || surface_.surface.to(s) != base_) continue;
      split_edge(surface_, s);
      ++count_.edges;
    }
  }
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
  bool is_at_base(const Corner& corner) const { return surface_.surface.vertex(corner.end) == base_; }
  std::vector<SideEnd> start() const { return {end_at(surface_.surface, base_)}; }
  std::vector<SideEnd> beside_first_loop(const Surface& open) const {
    return places(open, [&](const Corner& c) {
      return is_at_base(c) && (std::abs(c.before) == first_loop || std::abs(c.after) == first_loop);
    });
  }
  std::vector<SideEnd> bank(const Surface& open, int mark) const {
    return places(open,
                  [&](const Corner& c) { return is_at_base(c) && c.before == mark && c.after == mark; });
  }
  /// The copy of a vertex inside an arc on that bank of it.
  std::vector<SideEnd> copies(const Surface& open, int vertex, int mark) const {
    return places(open, [&](const Corner& c) {
      return surface_.surface.vertex(c.end) == vertex && c.before == mark && c.after == mark;
    });
  }

  std::vector<char> grow_disk() const;
  void mark_cut_locus();
  Crossing find_crossing() const;
  int split_arc(int arc);

  MarkedSurface& surface_;
  int base_;
  const Tolls& tolls_;
  const Progress& progress_;
  SplitCount count_;
};

/// The dual tree of shortest paths from the triangles around the base: for each side whether it is crossed.
std::vector<char> Builder::grow_disk() const {
  const Surface& whole = surface_.surface;
  const auto cost = [&](Side s) {
    // The triangles around the base come first, so that no arc ends there.
    return whole.from(s) == base_ || whole.to(s) == base_ ? 0.0 : dual_length(surface_, s);
  };
  const auto steps = [&](int t, const auto& visit) {
    for (const Side s : sides_of(t))
      if (!whole.is_boundary(s)) visit(whole.mate(s).triangle(), cost(s), s);
  };
  const auto paths = numeric::shortest_paths(static_cast<std::size_t>(whole.triangle_count()),
                                             {end_at(whole, base_).side.triangle()}, Side(), steps);
  std::vector<char> crossed(surface_.mark.size(), 0);
  for (const Side s : paths.last)
    if (s.exists()) crossed[s.value] = crossed[whole.mate(s).value] = 1;
  return crossed;
}

void Builder::mark_cut_locus() {
  mark_uncrossed(surface_, grow_disk());
  for (int& m : surface_.mark)
    if (m != 0) m += m > 0 ? first_arc - 1 : 1 - first_arc;
}

/// The vertex inside a linked arc through which the shortest loop goes.
Builder::Crossing Builder::find_crossing() const {
  const Surface disk = cut_open(surface_);
  const std::vector<double> length = path_lengths(surface_, disk, start(), tolls_);
  const std::vector<int> linked = linked_letters(runs(surface_, boundary_curves(disk).front()));
  if (linked.empty()) throw PreconditionError("the surface has no handle");
  // A vertex inside an arc has two copies, one on each bank.
  std::map<std::pair<int, int>, double> both;
  for (const Corner& c : corners(surface_, disk)) {
    const int arc = std::abs(c.after);
    if (c.before == c.after && std::binary_search(linked.begin(), linked.end(), arc))
      both[{surface_.surface.vertex(c.end), arc}] += length[disk.vertex(c.end)];
  }
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

} // namespace

std::vector<int> runs(const MarkedSurface& surface, const std::vector<SideEnd>& curve) {
  std::vector<int> word;
  for (const SideEnd e : curve)
    if (word.empty() || word.back() != surface[e.side]) word.push_back(surface[e.side]);
  if (word.size() > 1 && word.front() == word.back()) word.pop_back();
  return word;
}

SplitCount lay_handle(MarkedSurface& surface, int base, const Tolls& tolls, const Progress& progress) {
  return Builder(surface, base, tolls, progress).run();
}

} // namespace tetrarch::mesh
