// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/canonical_loops.hpp"

#include "handle.hpp"
#include "handles.hpp"
#include "tails.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <queue>
#include <utility>

namespace tetrarch::surface {
namespace {

/// Up to this genus loops are laid one after the other: that takes a search of the whole surface for each,
/// and fewer splits. Beyond, on plates and chains of 25 and 32 triangles a handle, it takes more of both.
constexpr int few_handles = 10;

bool has_turned_mates(const Surface& surface) {
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.is_turned(Side(k))) return true;
  return false;
}

/// Renames the loops in the order in which the boundary meets them.
void rename_loops(MarkedSurface& surface) {
  const std::vector<int> word = boundary_word(surface);
  std::size_t first = 0;
  while (!is_product_of_commutators(word, first)) ++first;
  std::vector<int> name(word.size() / 2 + 1, 0);
  int letters = 0;
  for (std::size_t k = 0; k < word.size(); ++k) {
    const int letter = word[(first + k) % word.size()];
    int& n = name[static_cast<std::size_t>(std::abs(letter))];
    if (n == 0) n = letter > 0 ? ++letters : -++letters;
  }
  for (int& m : surface.mark) m = m < 0 ? -name[-m] : name[m];
}

int genus_of(const MarkedSurface& surface) {
  const SurfaceType type = type_of(surface.surface);
  if (!type.is_closed() || has_turned_mates(surface.surface) || type.genus() < 1)
    throw PreconditionError("canonical loops need a closed oriented surface of positive genus");
  return type.genus();
}

} // namespace

CanonicalLoops mark_canonical_loops(MarkedSurface& surface, int base, const Progress& progress) {
  const int genus = genus_of(surface);
  if (std::any_of(surface.mark.begin(), surface.mark.end(), [](int m) { return m != 0; }))
    throw PreconditionError("the surface is marked already");
  if (base >= surface.surface.vertex_count())
    throw PreconditionError("there is no vertex " + std::to_string(base));
  CanonicalLoops result;
  result.base = base < 0 ? root_of_short_generators(surface) : base;
  SplitCount splits;
  if (genus <= few_handles) {
    splits = lay_handles_in_turn(surface, result.base, genus, progress);
  } else {
    Handles handles = lay_handles(surface, result.base, progress);
    splits = handles.splits;
    const SplitCount more = lay_tails(surface, handles, base < 0, progress);
    splits.edges += more.edges;
    splits.faces += more.faces;
    result.base = handles.point.front();
  }
  result.edge_splits = splits.edges;
  result.face_splits = splits.faces;
  rename_loops(surface);
  result.length.assign(2 * static_cast<std::size_t>(genus), 0);
  for (const int m : surface.mark)
    if (m > 0) ++result.length[static_cast<std::size_t>(m) - 1];
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

} // namespace tetrarch::surface
