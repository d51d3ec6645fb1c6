// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/canonical_loops.hpp"

#include "lay_path.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/cuts.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

namespace tetrarch::mesh {
namespace {

using numeric::infinity;

/// The marks along a boundary curve, one for each run.
std::vector<int> runs(const MarkedSurface& surface, const std::vector<SideEnd>& curve) {
  std::vector<int> word;
  for (const SideEnd e : curve)
    if (word.empty() || word.back() != surface[e.side]) word.push_back(surface[e.side]);
  if (word.size() > 1 && word.front() == word.back()) word.pop_back();
  return word;
}

/// Whether the cyclic word, read from letter `start` on, is p q -p -q r s -r -s ...
bool is_product_of_commutators(const std::vector<int>& word, std::size_t start) {
  const auto letter = [&](std::size_t k) { return word[(start + k) % word.size()]; };
  if (word.size() % 4 != 0) return false;
  for (std::size_t k = 0; k < word.size(); k += 4)
    if (letter(k) != -letter(k + 2) || letter(k + 1) != -letter(k + 3)) return false;
  return true;
}

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
SideEnd end_at(const Surface& surface, int vertex) {
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.from(Side(k)) == vertex) return {Side(k), true};
  throw PreconditionError("there is no vertex " + std::to_string(vertex));
}

class Builder {
public:
  Builder(MarkedSurface& surface, int base, CanonicalLoops& result, const Progress& progress)
      : surface_(surface), base_(base), result_(result), progress_(progress) {}

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

  /// Renames the loops in the order in which the boundary meets them.
  void rename() {
    const std::vector<int> word = boundary_word(surface_);
    std::size_t first = 0;
    while (!is_product_of_commutators(word, first)) ++first;
    std::vector<int> name(word.size() / 2 + 1, 0);
    int letters = 0;
    for (std::size_t k = 0; k < word.size(); ++k) {
      const int letter = word[(first + k) % word.size()];
      int& n = name[static_cast<std::size_t>(std::abs(letter))];
      if (n == 0) n = letter > 0 ? ++letters : -++letters;
    }
    for (int& m : surface_.mark) m = m < 0 ? -name[-m] : name[m];
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
    const SplitCount count = lay_path(surface_, m, from, to, progress_);
    result_.edge_splits += count.edges;
    result_.face_splits += count.faces;
  }
  template <class Wanted>
  std::vector<SideEnd> places(const Surface& open, Wanted wanted) const {
    std::vector<SideEnd> ends;
    for (const Corner& corner : corners(surface_, open))
      if (wanted(corner)) ends.push_back(corner.end);
    return ends;
  }
  std::vector<SideEnd> start(const Surface& open) const {
    if (handles_ == 1) return {end_at(surface_.surface, base_)};
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
  CanonicalLoops& result_;
  const Progress& progress_;
  int handles_ = 0;
  int before_ = 0; ///< the marks around the corner where the next handle starts
  int after_ = 0;
  std::map<std::pair<int, int>, double> bounds_; ///< of the lengths of loops that start at these marks
};

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
  const auto centre = [&](int t, std::size_t axis) {
    double sum = 0;
    for (const int v : surface_.surface.corners(t)) sum += surface_.points[v][axis] / 3;
    return sum;
  };
  const auto cost = [&](Side s) {
    // The triangles around the start come first, so that no arc ends there.
    if (open.from(s) == open.vertex(x) || open.to(s) == open.vertex(x)) return 0.0;
    if (surface_.points.empty()) return 1.0;
    const auto gap = [&](std::size_t axis) {
      return centre(s.triangle(), axis) - centre(open.mate(s).triangle(), axis);
    };
    return std::hypot(gap(0), gap(1), gap(2));
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
  const std::vector<double> length = path_lengths(surface_, disk, start(disk));
  const std::vector<int> linked = linked_letters(runs(surface_, boundary_curves(disk).front()), first_arc());
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
  ++result_.edge_splits;
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

bool has_turned_mates(const Surface& surface) {
  const std::vector<int> sign = orientation(surface);
  return sign.empty() || std::find(sign.begin(), sign.end(), -1) != sign.end();
}

int genus_of(const MarkedSurface& surface) {
  const SurfaceType type = type_of(surface.surface);
  if (!type.is_closed() || has_turned_mates(surface.surface) || type.genus() < 1)
    throw PreconditionError("canonical loops need a closed oriented surface of positive genus");
  return type.genus();
}

/// The given vertex or a good one, and such that no edge at it is a loop: the triangles around it differ.
int prepare_base(MarkedSurface& surface, int base, CanonicalLoops& result) {
  if (base < 0)
    base = root_of_short_generators(surface);
  else
    static_cast<void>(end_at(surface.surface, base));
  for (int k = 0; k < surface.surface.side_count(); ++k) {
    const Side s(k);
    if (surface.surface.from(s) != base || surface.surface.to(s) != base) continue;
    split_edge(surface, s);
    ++result.edge_splits;
  }
  return base;
}

} // namespace

CanonicalLoops mark_canonical_loops(MarkedSurface& surface, int base, const Progress& progress) {
  const int genus = genus_of(surface);
  if (std::any_of(surface.mark.begin(), surface.mark.end(), [](int m) { return m != 0; }))
    throw PreconditionError("the surface is marked already");
  CanonicalLoops result;
  result.base = prepare_base(surface, base, result);
  Builder builder(surface, result.base, result, progress);
  for (int k = 0; k < genus; ++k) {
    progress.step("laying loops", static_cast<double>(k) / genus);
    builder.add_handle();
  }
  builder.rename();
  for (int k = 1; k <= 2 * genus; ++k) result.length.push_back(length_of(surface, k));
  return result;
}

std::vector<int> boundary_word(const MarkedSurface& surface) {
  const auto curves = boundary_curves(cut_open(surface));
  if (curves.size() != 1) throw PreconditionError("the surface cut open has no single boundary curve");
  if (has_turned_mates(surface.surface)) throw PreconditionError("the surface has turned mates");
  std::vector<int> word = runs(surface, curves.front());
  auto first = word.begin();
  for (auto letter = word.begin(); letter != word.end(); ++letter)
    if (*letter > 0 && (*first <= 0 || *letter < *first)) first = letter;
  std::rotate(word.begin(), first, word.end());
  return word;
}

int length_of(const MarkedSurface& surface, int mark) {
  return static_cast<int>(std::count(surface.mark.begin(), surface.mark.end(), mark));
}

int lengthen(MarkedSurface& surface, int mark, int edges) {
  // Without points, an edge is half as long for each time it was halved, which its ends remember.
  std::vector<int> halvings(static_cast<std::size_t>(surface.surface.vertex_count()), 0);
  const auto depth = [&](Side s) {
    return std::max(halvings[surface.surface.from(s)], halvings[surface.surface.to(s)]);
  };
  const auto length = [&](Side s) {
    return std::ldexp(side_length(surface, s), surface.points.empty() ? -depth(s) : 0);
  };
  using Entry = std::pair<double, int>; // minus the length, the side
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto push = [&](Side s) {
    if (surface[s] == mark) queue.emplace(-length(s), s.value);
  };
  for (int k = 0; k < surface.surface.side_count(); ++k) push(Side(k));
  if (mark == 0 || queue.empty()) throw PreconditionError("there is no curve " + std::to_string(mark));
  int splits = 0;
  for (int now = static_cast<int>(queue.size()); now < edges; ++now, ++splits) {
    // A split may move a side, so entries may be out of date; what it moves and makes is entered anew.
    while (surface[Side(queue.top().second)] != mark ||
           -length(Side(queue.top().second)) != queue.top().first)
      queue.pop();
    const Side s(queue.top().second);
    const int other = surface.surface.mate(s).triangle();
    const int added = surface.surface.triangle_count();
    halvings.push_back(depth(s) + 1);
    split_edge(surface, s);
    for (const int t : {s.triangle(), other, added, added + 1})
      for (const Side touched : sides_of(t)) push(touched);
  }
  return splits;
}

std::string why_not_canonical(const MarkedSurface& surface) {
  const SurfaceType whole = type_of(surface.surface);
  if (!whole.is_closed() || whole.genus() < 1 || has_turned_mates(surface.surface))
    return "this is no closed oriented surface of positive genus";
  const Surface open = cut_open(surface);
  if (parts(open).count != 1 || !type_of(open).is_disk()) return "the surface cut open is no disk";
  const std::vector<int> word = boundary_word(surface);
  const std::size_t sides = 4 * static_cast<std::size_t>(whole.genus());
  for (std::size_t k = 0; k < std::max(word.size(), sides); ++k) {
    const int letter = static_cast<int>(2 * (k / 4) + 1 + k % 2);
    if (k >= std::min(word.size(), sides) || word[k] != (k % 4 < 2 ? letter : -letter))
      return "the boundary word is not canonical at letter " + std::to_string(k + 1);
  }
  // The ends of marked edges at each vertex.
  std::vector<int> degree(static_cast<std::size_t>(surface.surface.vertex_count()), 0);
  for (int k = 0; k < surface.surface.side_count(); ++k)
    if (surface[Side(k)] > 0)
      for (const bool at_start : {true, false}) ++degree[surface.surface.vertex({Side(k), at_start})];
  const auto branching = std::count_if(degree.begin(), degree.end(), [](int d) { return d != 0 && d != 2; });
  if (branching > 1) return "loops meet at " + std::to_string(branching) + " points";
  return "";
}

} // namespace tetrarch::mesh
