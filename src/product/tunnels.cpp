// SPDX-License-Identifier: GPL-2.0-or-later
#include "tunnels.hpp"

#include "patches.hpp"
#include "vectors.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/cuts.hpp"
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

/// On the boundary cut along the loop, 1 on one bank and 0 on the other, by corners.
CornerValues harmonic_between_banks(MarkedSurface surface, const Loop& loop) {
  for (const SideEnd e : loop) mesh::set_mark(surface, e.side, e.at_start ? 1 : -1);
  const std::vector<double> weight = mesh::half_cotangents({surface.points, surface.surface});
  const mesh::Surface ring = mesh::cut_open(surface);
  std::vector<char> held(static_cast<std::size_t>(ring.vertex_count()), 0);
  std::vector<double> data(held.size(), 0.0);
  double value = 1;
  for (const auto& bank : mesh::boundary_curves(ring)) {
    for (const SideEnd e : bank) {
      held[ring.vertex(e)] = 1;
      data[ring.vertex(e)] = value;
    }
    value = 0;
  }
  const std::vector<double> f = mesh::LaplaceSolver(ring, weight, held).solve({data}).front();
  CornerValues values;
  values.reserve(ring.triangles().size());
  for (const auto& [a, b, c] : ring.triangles()) values.push_back({f[a], f[b], f[c]});
  return values;
}

/// The values below which these areas lie, which increase.
std::array<double, 4> quantiles(const Solid& solid, const CornerValues& values,
                                const std::array<double, 4>& areas_below) {
  const std::vector<Point> areas = vector_areas(solid);
  std::vector<std::pair<double, double>> by_value; // and area
  by_value.reserve(values.size());
  for (std::size_t t = 0; t < values.size(); ++t)
    by_value.emplace_back((values[t][0] + values[t][1] + values[t][2]) / 3, vectors::norm(areas[t]));
  std::sort(by_value.begin(), by_value.end());
  std::array<double, 4> levels{};
  double below = 0;
  std::size_t next = 0;
  for (const auto& [value, area] : by_value) {
    below += area;
    while (next < levels.size() && below > areas_below[next]) levels[next++] = value;
  }
  return levels;
}

} // namespace

std::optional<Tunnel> tunnel(const Solid& solid, const FirstHomology& homology) {
  std::vector<Point> points;
  points.reserve(solid.vertex.size());
  for (const int v : solid.vertex) points.push_back(solid.point(v));
  const MarkedSurface surface(solid.boundary, std::move(points));
  const std::optional<Candidate> best = shortest_loop(surface, homology);
  if (!best) return {};
  Tunnel found;
  found.values = harmonic_between_banks(surface, best->loop);

  double whole = 0;
  for (const Point& a : vector_areas(solid)) whole += vectors::norm(a);
  const double band = std::min(0.1 * whole, best->length * best->length / 8);
  found.levels = quantiles(solid, found.values, {band, 0.4 * whole, 0.6 * whole, whole - band});
  found.how = "around the tunnel of the loop of " + std::to_string(best->loop.size()) +
              " edges through vertex " +
              std::to_string(solid.vertex[surface.surface.vertex(best->loop.front())]);
  return found;
}

} // namespace tetrarch::product
