// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/cuts.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tree_cotree.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tetrarch::surface {
namespace {

void check_connected(const Surface& surface) {
  if (parts(surface).count != 1) throw PreconditionError("the surface is not connected");
}

/// A graph on the edges of a surface, which can be pruned.
class CutGraph {
public:
  explicit CutGraph(const MarkedSurface& surface)
      : surface_(surface.surface), at_(ends_by_vertex(surface_)), kept_(boundary_vertices(surface_)),
        degree_(kept_.size(), 0) {
    for (const SideEnd e : at_.ends)
      if (surface.is_cut(e.side)) ++degree_[surface_.vertex(e)];
  }
  /// Takes dangling marks away.
  void prune(MarkedSurface& surface) {
    for (int v = 0; v < surface_.vertex_count(); ++v)
      for (int tip = v; tip >= 0 && degree_[tip] == 1 && !kept_[tip];) tip = retract(surface, tip);
  }
  bool is_branching(int v) const { return degree_[v] != 2 || kept_[v] != 0; }

private:
  /// Takes the only marked edge at `tip` away and returns its other end.
  int retract(MarkedSurface& surface, int tip) {
    for (int k = at_.first[tip]; k < at_.first[tip + 1]; ++k) {
      const SideEnd e = at_.ends[k];
      if (!surface.is_cut(e.side)) continue;
      const int root = surface_.vertex({e.side, !e.at_start});
      set_mark(surface, e.side, 0);
      --degree_[tip];
      --degree_[root];
      return root;
    }
    return -1;
  }

  const Surface& surface_;
  EndsByVertex at_;
  std::vector<char> kept_; ///< on the boundary: never a tip
  std::vector<int> degree_;
};

/// Gives every arc its number; both its banks are runs on the boundary of the surface cut open.
int number_arcs(MarkedSurface& surface, const CutGraph& graph) {
  const Surface open = cut_open(surface);
  std::vector<char> numbered(surface.mark.size(), 0);
  int arcs = 0;
  for (auto curve : boundary_curves(open)) {
    const auto starts_arc = [&](SideEnd e) { return graph.is_branching(surface.surface.vertex(e)); };
    const auto first = std::find_if(curve.begin(), curve.end(), starts_arc);
    const int closed_at = first == curve.end() ? surface.surface.vertex(curve.front()) : -1;
    if (first != curve.end()) std::rotate(curve.begin(), first, curve.end());
    bool other_bank = false;
    for (const SideEnd e : curve) {
      if (surface.surface.is_boundary(e.side)) continue;
      if (starts_arc(e) || surface.surface.vertex(e) == closed_at) {
        other_bank = numbered[e.side.value] != 0;
        if (!other_bank) ++arcs;
      }
      if (other_bank) continue;
      set_mark(surface, e.side, arcs);
      numbered[e.side.value] = numbered[surface.surface.mate(e.side).value] = 1;
    }
  }
  return arcs;
}

} // namespace

double side_length(const MarkedSurface& surface, Side s) {
  if (surface.points.empty()) return 1.0;
  return numeric::distance(surface.points[surface.surface.from(s)], surface.points[surface.surface.to(s)]);
}

double dual_length(const MarkedSurface& surface, Side s) {
  if (surface.points.empty()) return 1.0;
  const auto center = [&](int t) {
    numeric::Point sum{};
    for (const int v : surface.surface.corners(t))
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += surface.points[v][axis] / 3;
    return sum;
  };
  return numeric::distance(center(s.triangle()), center(surface.surface.mate(s).triangle()));
}

std::vector<double> side_lengths(const MarkedSurface& surface) {
  std::vector<double> length;
  length.reserve(static_cast<std::size_t>(surface.surface.side_count()));
  for (int k = 0; k < surface.surface.side_count(); ++k) length.push_back(side_length(surface, Side(k)));
  return length;
}

int mark_uncrossed(MarkedSurface& surface, const std::vector<char>& crossed) {
  if (crossed.size() != surface.mark.size()) throw PreconditionError("each side is crossed or not");
  std::fill(surface.mark.begin(), surface.mark.end(), 0);
  for (const Side s : edges(surface.surface))
    if (!surface.surface.is_boundary(s) && !crossed[s.value]) set_mark(surface, s, 1);
  CutGraph graph(surface);
  graph.prune(surface);
  return number_arcs(surface, graph);
}

int mark_cut_graph(MarkedSurface& surface) {
  check_connected(surface.surface);
  const std::vector<double> length = side_lengths(surface);
  const std::vector<char> on_boundary = boundary_vertices(surface.surface);
  std::vector<int> roots;
  for (int v = 0; v < surface.surface.vertex_count(); ++v)
    if (on_boundary[v]) roots.push_back(v);
  const bool closed = roots.empty();
  if (closed) roots.push_back(root_of_short_generators(surface));
  const Paths paths = shortest_paths(surface.surface, length, roots);
  const int arcs = mark_uncrossed(surface, close_loops(surface.surface, length, paths, false).crossed);
  if (arcs > 0 || !closed) return arcs;
  Side shortest;
  for (const Side s : edges(surface.surface))
    if (surface.surface.from(s) != surface.surface.to(s) &&
        (!shortest.exists() || length[s.value] < length[shortest.value]))
      shortest = s;
  set_mark(surface, shortest, 1);
  return 1;
}

std::vector<Loop> generators(const MarkedSurface& surface, int root) {
  if (root < 0 || root >= surface.surface.vertex_count())
    throw PreconditionError("there is no vertex " + std::to_string(root));
  check_connected(surface.surface);
  const std::vector<double> length = side_lengths(surface);
  const Paths paths = shortest_paths(surface.surface, length, {root});
  std::vector<Loop> loops;
  for (const Side s : close_loops(surface.surface, length, paths, true).edges) {
    Loop loop;
    const auto up = [&](int v, auto job) {
      for (SideEnd e = paths.last[v]; e.side.exists(); e = paths.last[surface.surface.vertex(e)]) job(e);
    };
    up(surface.surface.from(s), [&](SideEnd e) { loop.push_back(e); });
    std::reverse(loop.begin(), loop.end());
    loop.push_back({s, true});
    up(surface.surface.to(s), [&](SideEnd e) { loop.push_back({e.side, !e.at_start}); });
    loops.push_back(std::move(loop));
  }
  return loops;
}

int root_of_short_generators(const MarkedSurface& surface, int tries) {
  check_connected(surface.surface);
  const std::vector<double> length = side_lengths(surface);
  std::vector<double> from_all(static_cast<std::size_t>(surface.surface.vertex_count()), infinity);
  int root = 0;
  std::pair<double, int> best{infinity, 0};
  for (int k = 0; k < tries && from_all[root] > 0; ++k) {
    const Paths paths = shortest_paths(surface.surface, length, {root});
    const double total = close_loops(surface.surface, length, paths, true).total;
    if (total < best.first) best = {total, root};
    for (std::size_t v = 0; v < from_all.size(); ++v) from_all[v] = std::min(from_all[v], paths.distance[v]);
    root = static_cast<int>(std::max_element(from_all.begin(), from_all.end()) - from_all.begin());
  }
  return best.second;
}

} // namespace tetrarch::surface
