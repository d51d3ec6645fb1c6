// SPDX-License-Identifier: GPL-2.0-or-later
#include "lay_path.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/surface/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

namespace tetrarch::surface {
namespace {

using numeric::infinity;
/// The cost of crossing a chord, in edges of mean length: a split is worth a detour, but not any detour.
constexpr double chord_cost = 10.0;
/// The cost of a vertex next to one that is not free, likewise: a path that keeps off leaves room for others.
constexpr double crowd_cost = 1.0;
/// Each step costs this much more, in the same unit, so that two steps through one triangle are never as
/// short as one.
constexpr double step_cost = 1e-3;

/// Dijkstra's search through the vertices of a surface and the middles of its chords. Within a triangle, all
/// of these are neighbours, except along a boundary side. The search goes on from free vertices, middles and
/// where it started.
class Search {
public:
  Search(const MarkedSurface& surface, const Surface& open, const Tolls& tolls);
  /// Stops when a vertex of `to` is reached, and returns it; -1 if none can be, or `to` is empty.
  int run(const std::vector<SideEnd>& from, const std::vector<SideEnd>& to);

  std::vector<double> vertex_distances() const {
    return {distance_.begin(), distance_.begin() + open_.vertex_count()};
  }
  /// The chords on the way to a vertex, each as one of its sides, and the edges on it, last first: those of
  /// the first surface; the diagonals, in runs between vertices.
  std::vector<Side> chords_to(int vertex) const;
  std::vector<std::vector<Side>> diagonals_to(int vertex) const;
  std::vector<SideEnd> edges_to(int vertex) const;

private:
  struct Step {
    int from = -1;
    SideEnd along; ///< from vertex to vertex
  };
  bool is_middle(int node) const { return node >= open_.vertex_count(); }
  Side chord(int node) const { return Side(node - open_.vertex_count()); }
  int middle_of(Side s) const { return open_.vertex_count() + std::min(s.value, open_.mate(s).value); }
  bool is_chord(Side s) const {
    return !open_.is_boundary(s) && !is_free_[open_.from(s)] && !is_free_[open_.to(s)];
  }
  /// An edge that only splits have put into a triangle of the first surface.
  bool is_diagonal(Side s) const {
    const int here = s.triangle();
    const int there = open_.mate(s).triangle();
    return here != there && surface_.origin[here] == surface_.origin[there];
  }
  std::array<double, 3> place(int node) const;
  double surcharge(int node) const;
  double cost(int a, int b) const;
  void expand(int node);
  void enter_triangle(int node, int triangle, int corner);
  void relax(int node, int next, SideEnd along, double toll);

  const MarkedSurface& surface_;
  const Surface& open_;
  const Tolls& tolls_;
  double unit_ = 1;
  std::vector<SideEnd> end_of_; ///< of each vertex, some end there
  std::vector<char> is_free_;
  std::vector<char> is_crowded_; ///< next to a vertex that is not free
  std::vector<double> distance_;
  std::vector<Step> step_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue_;
};

Search::Search(const MarkedSurface& surface, const Surface& open, const Tolls& tolls)
    : surface_(surface), open_(open), tolls_(tolls), end_of_(static_cast<std::size_t>(open.vertex_count())),
      is_free_(end_of_.size(), 1), is_crowded_(end_of_.size(), 0),
      distance_(end_of_.size() + surface.mark.size(), infinity), step_(distance_.size()) {
  const std::vector<double> length = side_lengths(surface);
  const double mean = std::accumulate(length.begin(), length.end(), 0.0) / static_cast<double>(length.size());
  if (mean > 0 && mean < infinity) unit_ = mean;
  for (int k = 0; k < open.side_count(); ++k) {
    const Side s(k);
    end_of_[open.from(s)] = {s, true};
    if (open.is_boundary(s)) is_free_[open.from(s)] = is_free_[open.to(s)] = 0;
  }
  for (int k = 0; k < open.side_count(); ++k) {
    const Side s(k);
    if (!is_free_[open.from(s)]) is_crowded_[open.to(s)] = 1;
    if (!is_free_[open.to(s)]) is_crowded_[open.from(s)] = 1;
  }
}

std::array<double, 3> Search::place(int node) const {
  const auto point = [&](SideEnd e) { return surface_.points[surface_.surface.vertex(e)]; };
  if (!is_middle(node)) return point(end_of_[node]);
  std::array<double, 3> p = point({chord(node), true});
  const std::array<double, 3> q = point({chord(node), false});
  for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] + q[k]) / 2;
  return p;
}

double Search::surcharge(int node) const {
  if (is_middle(node)) return is_diagonal(chord(node)) ? 0 : chord_cost;
  return is_crowded_[node] ? crowd_cost : 0;
}

double Search::cost(int a, int b) const {
  const double extra = (surcharge(b) + step_cost) * unit_;
  if (surface_.points.empty()) return unit_ + extra;
  return numeric::distance(place(a), place(b)) + extra;
}

int Search::run(const std::vector<SideEnd>& from, const std::vector<SideEnd>& to) {
  std::vector<char> is_source(end_of_.size(), 0);
  std::vector<char> is_target(end_of_.size(), 0);
  for (const SideEnd e : to) is_target[open_.vertex(e)] = 1;
  for (const SideEnd e : from) {
    is_source[open_.vertex(e)] = 1;
    distance_[open_.vertex(e)] = 0;
    queue_.emplace(0, open_.vertex(e));
  }
  while (!queue_.empty()) {
    const auto [distance, node] = queue_.top();
    queue_.pop();
    if (distance > distance_[node]) continue;
    if (!is_middle(node) && is_target[node]) return node;
    if (is_middle(node) || is_free_[node] || is_source[node]) expand(node);
  }
  return -1;
}

void Search::expand(int node) {
  if (is_middle(node)) {
    for (const Side s : {chord(node), open_.mate(chord(node))}) enter_triangle(node, s.triangle(), -1);
  } else {
    for (const SideEnd e : fan(open_, end_of_[node])) enter_triangle(node, e.side.triangle(), e.corner());
  }
}

/// `corner` is where in the triangle the node is; -1 for a middle.
void Search::enter_triangle(int node, int triangle, int corner) {
  const auto toll_along = [&](Side s) {
    return tolls_.between(surface_.origin[triangle], surface_.origin[open_.mate(s).triangle()]);
  };
  const double through = tolls_.through(surface_.origin[triangle]);
  for (const Side s : sides_of(triangle)) {
    if (is_chord(s) && middle_of(s) != node) relax(node, middle_of(s), {}, through);
    if (corner < 0) {
      relax(node, open_.apex(s), {}, through);
    } else if (s.corner() != corner && !open_.is_boundary(s)) {
      const bool at_start = SideEnd{s, true}.corner() == corner;
      relax(node, open_.vertex({s, !at_start}), {s, at_start}, toll_along(s));
    }
  }
}

void Search::relax(int node, int next, SideEnd along, double toll) {
  const double further = distance_[node] + cost(node, next) + toll * unit_;
  if (further >= distance_[next]) return;
  distance_[next] = further;
  step_[next] = {node, along};
  queue_.emplace(further, next);
}

std::vector<Side> Search::chords_to(int vertex) const {
  std::vector<Side> chords;
  for (int node = vertex; node >= 0; node = step_[node].from)
    if (is_middle(node) && !is_diagonal(chord(node))) chords.push_back(chord(node));
  return chords;
}

std::vector<std::vector<Side>> Search::diagonals_to(int vertex) const {
  std::vector<std::vector<Side>> runs(1);
  for (int node = step_[vertex].from; node >= 0; node = step_[node].from) {
    if (is_middle(node))
      runs.back().push_back(chord(node));
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

std::vector<SideEnd> Search::edges_to(int vertex) const {
  std::vector<SideEnd> steps;
  for (int node = vertex; step_[node].from >= 0; node = step_[node].from) steps.push_back(step_[node].along);
  return steps;
}

/// Splits edges inside; a split moves at most the next sides of the two it halves into new triangles.
void split_all(MarkedSurface& surface, const std::vector<Side>& chords) {
  std::vector<Side> to_do = chords;
  for (std::size_t k = 0; k < to_do.size(); ++k) {
    const Side s = to_do[k];
    const Side m = surface.surface.mate(s);
    const int added = surface.surface.triangle_count();
    split_edge(surface, s);
    for (std::size_t l = k + 1; l < to_do.size(); ++l) {
      if (to_do[l] == s.next())
        to_do[l] = Side(added, s.next().corner());
      else if (to_do[l] == m.next())
        to_do[l] = Side(added + 1, m.next().corner());
    }
  }
}

/// Flips the diagonals that a path crosses between two vertices out of its way, one after the other, each
/// from the triangle whose apex is the first vertex. Between two flips the path starts across the next
/// diagonal.
void flip_all(MarkedSurface& surface, const std::vector<Side>& diagonals) {
  const Surface& whole = surface.surface;
  const auto touches = [&](Side s, int triangle) {
    return s.triangle() == triangle || whole.mate(s).triangle() == triangle;
  };
  Side s = diagonals.front();
  if (diagonals.size() > 1 && touches(diagonals[1], s.triangle())) s = whole.mate(s);
  for (std::size_t k = 0; k < diagonals.size(); ++k) {
    const Side m = whole.mate(s);
    // An earlier flip may have given the side to another edge; only what splits have made may go.
    if (!m.exists() || surface.is_cut(s) || m.triangle() == s.triangle() ||
        surface.origin[s.triangle()] != surface.origin[m.triangle()])
      return;
    const bool is_last = k + 1 == diagonals.size();
    if (!is_last && !touches(diagonals[k + 1], m.triangle())) return; // a path found anew will tell
    const bool moves = !is_last && (diagonals[k + 1] == m.next() || whole.mate(diagonals[k + 1]) == m.next());
    flip_edge(surface, s);
    if (!moves) s = m.previous();
  }
}

/// Where two places are corners of a triangle that is a part by itself, only its inside is left to go
/// through.
bool split_face_between(MarkedSurface& surface, const Surface& open, const std::vector<SideEnd>& from,
                        const std::vector<SideEnd>& to) {
  for (const SideEnd a : from)
    for (const SideEnd b : to)
      if (a.side.triangle() == b.side.triangle() && open.vertex(a) != open.vertex(b)) {
        split_face(surface, a.side.triangle());
        return true;
      }
  return false;
}

} // namespace

std::vector<Corner> corners(const MarkedSurface& surface, const Surface& open) {
  std::vector<Corner> result;
  std::vector<int> before(surface.mark.size(), 0);
  for (int k = 0; k < open.side_count(); ++k)
    if (const Side s(k); open.is_boundary(s))
      before[next_on_boundary(open, {s, false}).side.value] = surface[s];
  for (int k = 0; k < open.side_count(); ++k)
    if (const Side s(k); open.is_boundary(s)) result.push_back({{s, true}, before[k], surface[s]});
  return result;
}

/// Where edges have none, any path is a shortest one, also one that parts the surface.
static bool has_edge_without_length(const MarkedSurface& surface) {
  for (int k = 0; k < surface.surface.side_count(); ++k)
    if (!(side_length(surface, Side(k)) > 0)) return true;
  return false;
}

std::vector<double> path_lengths(const MarkedSurface& surface, const Surface& open,
                                 const std::vector<SideEnd>& from, const Tolls& tolls) {
  Search search(surface, open, tolls);
  search.run(from, {});
  return search.vertex_distances();
}

SplitCount lay_path(MarkedSurface& surface, int m, const Places& from, const Places& to,
                    const Progress& progress, const Tolls& tolls) {
  SplitCount count;
  // Once chords are split, the search finds the way over their middles, or a cheaper one; likewise once
  // diagonals are flipped. Every round crosses fewer; the budget is for mistakes of ours.
  constexpr int most_rounds = 100'000;
  for (int round = 0; round < most_rounds; ++round) {
    if (progress.stop_requested()) throw Stopped();
    const Surface open = cut_open(surface);
    Search search(surface, open, tolls);
    const int end = search.run(from(open), to(open));
    if (end < 0) {
      if (!split_face_between(surface, open, from(open), to(open))) {
        if (!has_edge_without_length(surface))
          throw PreconditionError("no path leads there: the surface is cut in two");
        throw InputError("no path leads there without crossing another: edges without length mislead the "
                         "search for short ones");
      }
      ++count.faces;
      continue;
    }
    const std::vector<Side> chords = search.chords_to(end);
    const std::vector<std::vector<Side>> diagonals = search.diagonals_to(end);
    if (chords.empty() && diagonals.empty()) {
      for (const SideEnd e : search.edges_to(end)) set_mark(surface, e.side, e.at_start ? m : -m);
      return count;
    }
    if (chords.empty())
      for (const auto& run : diagonals) flip_all(surface, run);
    split_all(surface, chords);
    count.edges += static_cast<int>(chords.size());
  }
  throw PreconditionError("no path was found in " + std::to_string(most_rounds) + " rounds");
}

} // namespace tetrarch::surface
