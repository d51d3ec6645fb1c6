// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/cuts.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

namespace tetrarch::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The edges, each as one of its sides.
std::vector<Side> edges(const Surface& surface) {
  std::vector<Side> result;
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.is_boundary(Side(k)) || k < surface.mate(Side(k)).value) result.emplace_back(k);
  return result;
}

/// The ends of edges at vertex v, one for each edge and twice for loops: ends[first[v]] ..
/// ends[first[v+1]-1].
struct EndsByVertex {
  std::vector<int> first;
  std::vector<SideEnd> ends;
};

EndsByVertex ends_by_vertex(const Surface& surface) {
  const std::vector<Side> all_edges = edges(surface);
  EndsByVertex out{std::vector<int>(static_cast<std::size_t>(surface.vertex_count()) + 1, 0),
                   std::vector<SideEnd>(2 * all_edges.size())};
  for (const Side s : all_edges)
    for (const bool at_start : {true, false}) ++out.first[surface.vertex({s, at_start})];
  std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
  // Filled from the back, which leaves first[v] at the start of v's range.
  for (auto s = all_edges.rbegin(); s != all_edges.rend(); ++s)
    for (const bool at_start : {false, true})
      out.ends[--out.first[surface.vertex({*s, at_start})]] = {*s, at_start};
  return out;
}

/// A forest of shortest paths.
struct Paths {
  std::vector<double> distance; ///< of each vertex from the nearest root
  std::vector<SideEnd> reached; ///< of each vertex, the end at its parent's that leads there; none at roots
};

Paths shortest_paths(const Surface& surface, const std::vector<double>& length,
                     const std::vector<int>& roots) {
  const EndsByVertex at = ends_by_vertex(surface);
  const auto vertices = static_cast<std::size_t>(surface.vertex_count());
  Paths paths{std::vector<double>(vertices, infinity), std::vector<SideEnd>(vertices)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int v : roots) {
    paths.distance[v] = 0;
    queue.emplace(0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > paths.distance[v]) continue;
    for (int k = at.first[v]; k < at.first[v + 1]; ++k) {
      const SideEnd e = at.ends[k];
      const int w = surface.vertex({e.side, !e.at_start});
      const double further = distance + length[e.side.value];
      if (further >= paths.distance[w]) continue;
      paths.distance[w] = further;
      paths.reached[w] = e;
      queue.emplace(further, w);
    }
  }
  return paths;
}

/// Edges closing loops with a forest of paths.
struct Closing {
  std::vector<Side> edges;   ///< by the length of their loops, shortest first
  double total = 0;          ///< of the lengths
  std::vector<char> crossed; ///< for each side, whether the dual tree crosses it
};

/// Crosses the edges outside the forest, those of the longest loops first, wherever that joins two parts of
/// the dual forest. Across boundary edges lies, if so wanted, one more place, outside; else they are no
/// edges.
Closing close_loops(const Surface& surface, const std::vector<double>& length, const Paths& paths,
                    bool outside) {
  std::vector<char> in_tree(static_cast<std::size_t>(surface.side_count()), 0);
  for (const SideEnd e : paths.reached)
    if (e.side.exists()) in_tree[e.side.value] = 1;
  std::vector<std::pair<double, Side>> candidates;
  for (const Side s : edges(surface)) {
    if (in_tree[s.value] || (!outside && surface.is_boundary(s))) continue;
    candidates.emplace_back(paths.distance[surface.from(s)] + length[s.value] + paths.distance[surface.to(s)],
                            s);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<int> part(static_cast<std::size_t>(surface.triangle_count()) + 1);
  std::iota(part.begin(), part.end(), 0);
  Closing closing{{}, 0, std::vector<char>(static_cast<std::size_t>(surface.side_count()), 0)};
  for (const auto& [loop, s] : candidates) {
    const Side m = surface.mate(s);
    const int here = find_root(part, s.triangle());
    const int there = find_root(part, m.exists() ? m.triangle() : surface.triangle_count());
    if (here == there) {
      closing.edges.push_back(s);
      closing.total += loop;
      continue;
    }
    part[here] = there;
    closing.crossed[s.value] = 1;
    if (m.exists()) closing.crossed[m.value] = 1;
  }
  std::reverse(closing.edges.begin(), closing.edges.end());
  return closing;
}

void check_connected(const Surface& surface) {
  if (parts(surface).count != 1) throw PreconditionError("the surface is not connected");
}

std::vector<char> boundary_vertices(const Surface& surface) {
  std::vector<char> on_boundary(static_cast<std::size_t>(surface.vertex_count()), 0);
  for (int k = 0; k < surface.side_count(); ++k)
    if (const Side s(k); surface.is_boundary(s))
      on_boundary[surface.from(s)] = on_boundary[surface.to(s)] = 1;
  return on_boundary;
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

std::vector<double> side_lengths(const MarkedSurface& surface) {
  std::vector<double> length(static_cast<std::size_t>(surface.surface.side_count()), 1.0);
  if (surface.points.empty()) return length;
  for (int k = 0; k < surface.surface.side_count(); ++k) {
    const auto& p = surface.points[surface.surface.from(Side(k))];
    const auto& q = surface.points[surface.surface.to(Side(k))];
    length[k] = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
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
      for (SideEnd e = paths.reached[v]; e.side.exists(); e = paths.reached[surface.surface.vertex(e)])
        job(e);
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

} // namespace tetrarch::mesh
