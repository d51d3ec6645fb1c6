// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/direct.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <numeric>

namespace tetrarch::bundle {
namespace {

/// Triangles breadth first over the dual graph, each with its side towards the roots; roots have none.
struct DualForest {
  std::vector<int> order;
  std::vector<Side> back;
};

DualForest grow(const Disk& disk, const std::vector<int>& roots) {
  DualForest forest{roots, std::vector<Side>(static_cast<std::size_t>(disk.triangle_count()))};
  std::vector<char> seen(forest.back.size(), 0);
  for (const int t : roots) seen[t] = 1;
  for (std::size_t k = 0; k < forest.order.size(); ++k) {
    const int t = forest.order[k]; // by value: the list grows
    for (const Side s : sides_of(t)) {
      const Side beyond = disk.mate(s);
      if (!beyond.exists() || seen[beyond.triangle()]) continue;
      seen[beyond.triangle()] = 1;
      forest.back[beyond.triangle()] = beyond;
      forest.order.push_back(beyond.triangle());
    }
  }
  return forest;
}

/// Orients a dual cycle among the triangles around the interior vertex that side s starts from. Turning about
/// the vertex, the first triangle to come a second time closes it: no triangle is on it twice.
std::vector<int> orient_cycle(const Disk& disk, Side s, CuttingPattern& pattern) {
  std::vector<Side> exits;
  std::vector<int> place(static_cast<std::size_t>(disk.triangle_count()), -1);
  for (; place[s.triangle()] < 0; s = disk.mate(s).next()) {
    place[s.triangle()] = static_cast<int>(exits.size());
    exits.push_back(s);
  }
  exits.erase(exits.begin(), exits.begin() + place[s.triangle()]);
  std::vector<int> cycle;
  for (const Side exit : exits) {
    pattern.set(disk, exit, 1);
    cycle.push_back(exit.triangle());
  }
  return cycle;
}

/// Orients the dual path between two boundary sides, of value -1 and +1: in through the first, out through
/// the second.
std::vector<int> orient_path(const Disk& disk, Side in, Side out, CuttingPattern& pattern) {
  const DualForest forest = grow(disk, {in.triangle()});
  std::vector<int> path{out.triangle()};
  while (path.back() != in.triangle()) {
    const Side back = forest.back[path.back()];
    pattern.set(disk, back, -1);
    path.push_back(disk.mate(back).triangle());
  }
  return path;
}

/// The core's triangles, oriented; none if there is no core.
std::vector<int> orient_core(const Disk& disk, CuttingPattern& pattern) {
  const std::vector<char> on_boundary = disk.boundary_vertices();
  for (int t = 0; t < disk.triangle_count(); ++t)
    for (const Side s : sides_of(t))
      if (!on_boundary[disk.from(s)]) return orient_cycle(disk, s, pattern);
  const auto find = [&](int value) {
    const auto& boundary = disk.boundary();
    const auto at =
        std::find_if(boundary.begin(), boundary.end(), [&](Side s) { return pattern[s] == value; });
    return at == boundary.end() ? Side() : *at;
  };
  const Side in = find(-1);
  const Side out = find(1);
  if (!in.exists() || !out.exists()) return {};
  return orient_path(disk, in, out, pattern);
}

} // namespace

CuttingPattern cut_by_order(const Disk& disk, const std::vector<int>& rank) {
  if (rank.size() != static_cast<std::size_t>(disk.vertex_count()))
    throw PreconditionError("one rank for each vertex is needed");
  CuttingPattern pattern(disk);
  for (int t = 0; t < disk.triangle_count(); ++t)
    for (const Side s : sides_of(t)) {
      const int from = rank[disk.from(s)];
      const int to = rank[disk.to(s)];
      if (from == to) throw PreconditionError("both ends of an edge have rank " + std::to_string(from));
      pattern.set(disk, s, from < to ? 1 : -1);
    }
  return pattern;
}

CuttingResult cut_by_dual_graph(const Disk& disk, const BoundaryValues& boundary) {
  CuttingPattern pattern = with_boundary(disk, boundary);
  const std::vector<int> core = orient_core(disk, pattern);
  if (core.empty()) {
    Obstruction whole{std::vector<int>(static_cast<std::size_t>(disk.triangle_count())), boundary.front()};
    std::iota(whole.triangles.begin(), whole.triangles.end(), 0);
    return whole;
  }
  const DualForest forest = grow(disk, core);
  for (auto t = forest.order.rbegin(); t != forest.order.rend(); ++t) {
    const Side back = forest.back[*t];
    for (const Side s : sides_of(*t))
      if (s != back && pattern.is_open(s)) pattern.set(disk, s, 1);
    if (back.exists()) pattern.set(disk, back, -pattern[back.next()]);
  }
  return pattern;
}

} // namespace tetrarch::bundle
