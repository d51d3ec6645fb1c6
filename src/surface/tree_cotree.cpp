// SPDX-License-Identifier: GPL-2.0-or-later
#include "tree_cotree.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetrarch::surface {

std::vector<Side> edges(const Surface& surface) {
  std::vector<Side> result;
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.is_boundary(Side(k)) || k < surface.mate(Side(k)).value) result.emplace_back(k);
  return result;
}

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

std::vector<double> lengths_off(const Surface& surface, std::vector<double> length,
                                const std::vector<char>& is_barred) {
  for (int k = 0; k < surface.side_count(); ++k)
    if (is_barred[surface.from(Side(k))] || is_barred[surface.to(Side(k))]) length[k] = numeric::infinity;
  return length;
}

Paths shortest_paths(const Surface& surface, const std::vector<double>& length,
                     const std::vector<int>& roots) {
  const EndsByVertex at = ends_by_vertex(surface);
  const auto steps = [&](int v, const auto& visit) {
    for (int k = at.first[v]; k < at.first[v + 1]; ++k) {
      const SideEnd e = at.ends[k];
      visit(surface.vertex({e.side, !e.at_start}), length[e.side.value], e);
    }
  };
  return numeric::shortest_paths(static_cast<std::size_t>(surface.vertex_count()), roots, SideEnd(), steps);
}

Closing close_loops(const Surface& surface, const std::vector<double>& length, const Paths& paths,
                    bool outside) {
  std::vector<char> in_tree(static_cast<std::size_t>(surface.side_count()), 0);
  for (const SideEnd e : paths.last)
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
    const int here = numeric::find_root(part, s.triangle());
    const int there = numeric::find_root(part, m.exists() ? m.triangle() : surface.triangle_count());
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

std::vector<char> boundary_vertices(const Surface& surface) {
  std::vector<char> on_boundary(static_cast<std::size_t>(surface.vertex_count()), 0);
  for (int k = 0; k < surface.side_count(); ++k)
    if (const Side s(k); surface.is_boundary(s))
      on_boundary[surface.from(s)] = on_boundary[surface.to(s)] = 1;
  return on_boundary;
}

} // namespace tetrarch::surface
