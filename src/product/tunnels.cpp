// SPDX-License-Identifier: GPL-2.0-or-later
#include "tunnels.hpp"

#include "branches.hpp"
#include "patches.hpp"
#include "vectors.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/distance.hpp"
#include "tetrarch/mesh/laplacian.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::product {
namespace {

using mesh::Loop;
using mesh::MarkedSurface;
using mesh::SideEnd;

struct Candidate {
  Loop loop;
  double length = 0;
};

/// Without the way from the root to the loop and back.
Loop without_tail(const MarkedSurface& surface, Loop loop) {
  const auto is_back = [&](SideEnd out, SideEnd in) {
    return out.side == in.side || surface.surface.mate(out.side) == in.side;
  };
  while (loop.size() > 2 && is_back(loop.front(), loop.back())) {
    loop.pop_back();
    loop.erase(loop.begin());
  }
  return loop;
}

bool is_simple(const MarkedSurface& surface, const Loop& loop) {
  std::set<int> seen;
  for (const SideEnd e : loop) seen.insert(surface.surface.vertex(e));
  return seen.size() == loop.size();
}

double length_of(const MarkedSurface& surface, const Loop& loop) {
  double length = 0;
  for (const SideEnd e : loop)
    length += mesh::distance(surface.points[surface.surface.from(e.side)],
                             surface.points[surface.surface.to(e.side)]);
  return length;
}

/// The shortest simple loop through a root that generates the homology, if it is shorter than `best`.
bool improve(const MarkedSurface& surface, const FirstHomology& homology, int root,
             std::optional<Candidate>& best) {
  bool improved = false;
  for (const Loop& through_root : mesh::generators(surface, root)) {
    const Loop loop = without_tail(surface, through_root);
    const double length = length_of(surface, loop);
    if (best && length >= best->length * (1 - 1e-9)) continue;
    if (!is_simple(surface, loop) || !homology.generated_by({homology.of(loop)})) continue;
    best = {loop, length};
    improved = true;
  }
  return improved;
}

std::optional<Candidate> shortest_loop(const MarkedSurface& surface, const FirstHomology& homology) {
  constexpr int tries = 16;
  constexpr int most_rounds = 10;
  std::optional<Candidate> best;
  improve(surface, homology, mesh::root_of_short_generators(surface, tries), best);
  for (int round = 0; round < most_rounds && best; ++round) {
    const Loop loop = best->loop;
    bool improved = false;
    for (std::size_t k = 0; k < loop.size(); k += 1 + loop.size() / 8)
      improved = improve(surface, homology, surface.surface.vertex(loop[k]), best) || improved;
    if (!improved) break;
  }
  return best;
}

/// The boundary cut open along the loop.
mesh::TriangleMesh ring_of(const TunnelLoop& around) {
  MarkedSurface surface = around.surface;
  for (const SideEnd e : around.loop) mesh::set_mark(surface, e.side, e.at_start ? 1 : -1);
  mesh::TriangleMesh ring{{}, mesh::cut_open(surface)};
  ring.points.resize(static_cast<std::size_t>(ring.surface.vertex_count()));
  for (int t = 0; t < ring.surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      ring.points[ring.surface.corners(t)[c]] = surface.points[surface.surface.corners(t)[c]];
  return ring;
}

/// 1 on one bank and 0 on the other; along the trees that start there it goes down to 0.8 and up to 0.2
/// within half a loop's length; harmonic elsewhere. By corners.
CornerValues harmonic_between_trees(const mesh::TriangleMesh& ring, double length, int branches) {
  constexpr double on_trees = 0.2; ///< from the value on their bank
  std::array<std::vector<int>, 2> banks;
  const auto curves = mesh::boundary_curves(ring.surface);
  for (const int k : {0, 1})
    for (const SideEnd e : curves[k]) banks[k].push_back(ring.surface.vertex(e));
  const std::array<std::vector<int>, 2> trees = opposite_trees(ring, banks, branches);
  std::vector<char> held(ring.points.size(), 0);
  std::vector<double> data(held.size(), 0.0);
  for (const int k : {0, 1}) {
    const std::vector<double> distance = distances(ring, banks[k]);
    for (const int v : trees[k]) {
      const double away = on_trees * std::min(1.0, distance[v] / (length / 2));
      held[v] = 1;
      data[v] = k == 0 ? 1 - away : away;
    }
  }
  const std::vector<double> weight = mesh::half_cotangents(ring);
  const std::vector<double> f = mesh::LaplaceSolver(ring.surface, weight, held).solve({data}).front();
  CornerValues values;
  values.reserve(ring.surface.triangles().size());
  for (const auto& [a, b, c] : ring.surface.triangles()) values.push_back({f[a], f[b], f[c]});
  return values;
}

/// Of each triangle its value and its area, by value.
std::vector<std::pair<double, double>> sorted_by_value(const Solid& solid, const CornerValues& values) {
  const std::vector<Point> areas = vector_areas(solid);
  std::vector<std::pair<double, double>> sorted;
  sorted.reserve(values.size());
  for (std::size_t t = 0; t < values.size(); ++t)
    sorted.emplace_back((values[t][0] + values[t][1] + values[t][2]) / 3, vectors::norm(areas[t]));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// The least area of so many triangles at the beginning.
double area_of(int count, auto first, auto end) {
  double area = 0;
  for (; count > 0 && first != end; --count, ++first) area += first->second;
  return area;
}

/// Where the inner wall ends, the outer begins and ends, the inner begins.
std::array<double, 4> levels_of(const Solid& solid, const CornerValues& values, double length) {
  constexpr int fewest =
      40; ///< triangles of the inner wall along each bank, so that it has a rim to speak of
  const auto sorted = sorted_by_value(solid, values);
  double whole = 0;
  for (const auto& [value, area] : sorted) whole += area;
  const auto band = [&](double least) { return std::min(0.1 * whole, std::max(least, length * length / 8)); };
  const std::array<double, 4> areas_below{band(area_of(fewest, sorted.begin(), sorted.end())), 0.4 * whole,
                                          0.6 * whole,
                                          whole - band(area_of(fewest, sorted.rbegin(), sorted.rend()))};
  std::array<double, 4> levels{};
  double below = 0;
  std::size_t next = 0;
  for (const auto& [value, area] : sorted) {
    below += area;
    while (next < levels.size() && below > areas_below[next]) levels[next++] = value;
  }
  return levels;
}

} // namespace

std::optional<TunnelLoop> tunnel_loop(const Solid& solid, const FirstHomology& homology) {
  std::vector<Point> points;
  points.reserve(solid.vertex.size());
  for (const int v : solid.vertex) points.push_back(solid.point(v));
  MarkedSurface surface(solid.boundary, std::move(points));
  const std::optional<Candidate> best = shortest_loop(surface, homology);
  if (!best) return {};
  return TunnelLoop{std::move(surface), best->loop, best->length};
}

Tunnel tunnel(const Solid& solid, const TunnelLoop& around, int branches) {
  Tunnel found;
  found.values = harmonic_between_trees(ring_of(around), around.length, branches);
  found.levels = levels_of(solid, found.values, around.length);
  found.how = "around the tunnel of the loop of " + std::to_string(around.loop.size()) +
              " edges through vertex " +
              std::to_string(solid.vertex[around.surface.surface.vertex(around.loop.front())]) +
              (branches > 0 ? ", with " + std::to_string(branches) + " branches" : "");
  return found;
}

} // namespace tetrarch::product
