// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/open_handles.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/cuts.hpp"
#include "tree_cotree.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::surface {
namespace {

/// Roots far from each other that are tried for each loop.
constexpr int far_roots = 6;

/// The edges of a closed walk, each as its first end.
struct Candidate {
  Loop loop;
  double length = infinity;
};

/// Searches one surface for a short loop that does not separate it and keeps off its boundary.
class LoopSearch {
public:
  LoopSearch(const Surface& open, const std::vector<double>& length)
      : open_(open), is_barred_(boundary_vertices(open)), length_(lengths_off(open, length, is_barred_)) {}
  /// The loop is empty if none was found.
  Candidate best(const Progress& progress);

private:
  void try_root(int root);
  Candidate closed_by(Side s, const Paths& paths) const;

  const Surface& open_;
  std::vector<char> is_barred_;
  std::vector<double> length_;
  Candidate best_;
  std::vector<double> from_roots_; ///< the distance of each vertex from all roots tried
};

Candidate LoopSearch::best(const Progress& progress) {
  from_roots_.assign(is_barred_.size(), infinity);
  for (std::size_t v = 0; v < is_barred_.size(); ++v)
    if (is_barred_[v]) from_roots_[v] = 0; // never a root
  for (int k = 0; k < far_roots; ++k) {
    progress.step("loops");
    const auto farthest = std::max_element(from_roots_.begin(), from_roots_.end());
    if (farthest == from_roots_.end() || *farthest == 0) break;
    try_root(static_cast<int>(farthest - from_roots_.begin()));
  }
  for (double before = infinity; best_.length < before;) {
    progress.step("loops");
    before = best_.length;
    // Across from where the loop was last rooted.
    try_root(open_.vertex(best_.loop[best_.loop.size() / 2]));
  }
  return best_;
}

void LoopSearch::try_root(int root) {
  const Paths paths = shortest_paths(open_, length_, {root});
  for (std::size_t v = 0; v < from_roots_.size(); ++v)
    from_roots_[v] = std::min(from_roots_[v], paths.distance[v]);
  for (const Side s : close_loops(open_, length_, paths, false).edges) {
    if (paths.distance[open_.from(s)] + length_[s.value] + paths.distance[open_.to(s)] == infinity) break;
    Candidate candidate = closed_by(s, paths);
    if (candidate.length < best_.length) best_ = std::move(candidate);
  }
}

/// Side s and the paths to its ends, less what these have in common.
Candidate LoopSearch::closed_by(Side s, const Paths& paths) const {
  const auto up = [&](int v) {
    Loop steps;
    for (SideEnd e = paths.last[v]; e.side.exists(); e = paths.last[open_.vertex(e)]) steps.push_back(e);
    return steps;
  };
  Loop there = up(open_.from(s));
  Loop back = up(open_.to(s));
  while (!there.empty() && !back.empty() && there.back() == back.back()) {
    there.pop_back();
    back.pop_back();
  }
  Candidate candidate{std::move(there), 0};
  std::reverse(candidate.loop.begin(), candidate.loop.end());
  candidate.loop.push_back({s, true});
  for (const SideEnd e : back) candidate.loop.push_back({e.side, !e.at_start});
  for (const SideEnd e : candidate.loop) candidate.length += length_[e.side.value];
  return candidate;
}

/// Splits the edges inside, off the loops, whose ends are both on boundary or loops. Returns how many.
int split_chords(MarkedSurface& surface) {
  const Surface& whole = surface.surface;
  std::vector<char> is_barred = boundary_vertices(whole);
  for (int k = 0; k < whole.side_count(); ++k)
    if (const Side s(k); surface.is_cut(s)) is_barred[whole.from(s)] = is_barred[whole.to(s)] = 1;
  // A split moves sides to new triangles only, which are still to come.
  int splits = 0;
  for (int k = 0; k < whole.side_count(); ++k) {
    const Side s(k);
    if (whole.is_boundary(s) || surface.is_cut(s) || !is_barred[whole.from(s)] || !is_barred[whole.to(s)])
      continue;
    split_edge(surface, s);
    is_barred.push_back(0);
    ++splits;
  }
  return splits;
}

Candidate find_loop(const MarkedSurface& surface, const Progress& progress) {
  const Surface open = cut_open(surface);
  return LoopSearch(open, side_lengths(surface)).best(progress);
}

} // namespace

OpenedHandles open_handles(const OpenedMesh& opened, const Progress& progress) {
  const SurfaceType type = type_of(opened.mesh.surface);
  if (!type.orientable) throw InputError("the surface is not orientable: it has no handles to open");
  MarkedSurface marked(opened.mesh.surface, opened.mesh.points);
  OpenedHandles out;
  for (int k = 1; k <= type.genus(); ++k) {
    progress.step("loops", (k - 1.0) / type.genus());
    Candidate found = find_loop(marked, progress.silent());
    if (found.loop.empty()) {
      out.edge_splits += split_chords(marked);
      found = find_loop(marked, progress.silent());
    }
    if (found.loop.empty()) throw InputError("no loop around a handle has a finite length");
    for (const SideEnd e : found.loop) set_mark(marked, e.side, e.at_start ? k : -k);
    out.loops.push_back({static_cast<int>(found.loop.size()), found.length});
  }
  out.opened = cut_along(opened, marked);
  return out;
}

} // namespace tetrarch::surface
