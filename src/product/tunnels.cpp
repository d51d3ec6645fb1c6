// SPDX-License-Identifier: GPL-2.0-or-later
#include "tunnels.hpp"

#include "branches.hpp"
#include "patches.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

using surface::Loop;
using surface::MarkedSurface;
using surface::SideEnd;

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

/// Whether it meets neither itself nor the boundary.
bool is_simple(const MarkedSurface& surface, const std::vector<char>& on_boundary, const Loop& loop) {
  std::set<int> seen;
  for (const SideEnd e : loop)
    if (on_boundary[surface.surface.vertex(e)] != 0 || !seen.insert(surface.surface.vertex(e)).second)
      return false;
  return true;
}

double length_of(const MarkedSurface& surface, const Loop& loop) {
  double length = 0;
  for (const SideEnd e : loop)
    length += numeric::distance(surface.points[surface.surface.from(e.side)],
                                surface.points[surface.surface.to(e.side)]);
  return length;
}

/// A surface on which a loop is sought, the homology of the solid, and the loops that there are.
struct LoopSearch {
  MarkedSurface surface;
  const FirstHomology& homology;
  std::vector<FirstHomology::Element> chosen;
  std::vector<char> on_boundary;

  LoopSearch(surface::TriangleMesh cut, const FirstHomology& h, std::vector<FirstHomology::Element> c)
      : surface(std::move(cut.surface), std::move(cut.points)), homology(h), chosen(std::move(c)),
        on_boundary(static_cast<std::size_t>(surface.surface.vertex_count()), 0) {
    for (const auto& curve : surface::boundary_curves(surface.surface))
      for (const SideEnd e : curve) on_boundary[surface.surface.vertex(e)] = 1;
  }

  /// Whether the loops and this one are part of a basis.
  bool completes(const Loop& loop) const {
    std::vector<FirstHomology::Element> all = chosen;
    all.push_back(homology.of(loop));
    return homology.is_part_of_basis(all);
  }
};

/// The shortest simple loop through a root that completes the others, if it is shorter than `best`.
bool improve(const LoopSearch& search, int root, std::optional<Candidate>& best) {
  bool improved = false;
  for (const Loop& through_root : surface::generators(search.surface, root)) {
    const Loop loop = without_tail(search.surface, through_root);
    const double length = length_of(search.surface, loop);
    if (best && length >= best->length * (1 - 1e-9)) continue;
    if (!is_simple(search.surface, search.on_boundary, loop) || !search.completes(loop)) continue;
    best = {loop, length};
    improved = true;
  }
  return improved;
}

std::optional<Candidate> shortest_loop(const LoopSearch& search) {
  constexpr int tries = 16;
  constexpr int most_roots = 64;
  constexpr int most_rounds = 10;
  std::optional<Candidate> best;
  improve(search, surface::root_of_short_generators(search.surface, tries), best);
  const int vertices = search.surface.surface.vertex_count();
  for (int v = 0; v < vertices && !best; v += 1 + vertices / most_roots) improve(search, v, best);
  for (int round = 0; round < most_rounds && best; ++round) {
    const Loop loop = best->loop;
    bool improved = false;
    for (std::size_t k = 0; k < loop.size(); k += 1 + loop.size() / 8)
      improved = improve(search, search.surface.surface.vertex(loop[k]), best) || improved;
    if (!improved) break;
  }
  return best;
}

/// Cut open along the marks.
surface::TriangleMesh opened(const MarkedSurface& surface) {
  surface::TriangleMesh result{{}, surface::cut_open(surface)};
  result.points.resize(static_cast<std::size_t>(result.surface.vertex_count()));
  for (int t = 0; t < result.surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      result.points[result.surface.corners(t)[c]] = surface.points[surface.surface.corners(t)[c]];
  return result;
}

/// Far from where they are, to and fro: ways along the boundary are then longer than all others, and short
/// loops keep away from it.
void move_boundary_away(surface::TriangleMesh& cut) {
  Point low = cut.points.front();
  Point high = low;
  for (const Point& p : cut.points)
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  double far = numeric::distance(low, high);
  for (const auto& curve : surface::boundary_curves(cut.surface))
    for (const SideEnd e : curve) {
      cut.points[cut.surface.vertex(e)][0] += far;
      far = -far;
    }
}

using Banks = std::vector<std::array<std::vector<int>, 2>>;

/// Both banks of each loop, as vertices of the surface that is cut along them.
Banks banks_of(const surface::Surface& cut, const TunnelLoops& around) {
  Banks banks(around.loops.size());
  for (const auto& curve : surface::boundary_curves(cut)) {
    const int mark = around.surface[curve.front().side];
    std::vector<int>& bank = banks[std::abs(mark) - 1][mark > 0 ? 0 : 1];
    for (const SideEnd e : curve) bank.push_back(cut.vertex(e));
  }
  return banks;
}

/// For each vertex of the inner wall at a bank of loop k how far inside it is: 1 on the bank, 0 or less
/// beyond the wall. That is an eighth of the loop wide, or a row of triangles, but stays away from other
/// loops and leaves most of the way to the other bank.
std::vector<double> inside_wall(const surface::TriangleMesh& cut, const TunnelLoops& around,
                                const Banks& banks, std::size_t k, int side) {
  constexpr double to_others = 0.3; ///< in terms of the distances from there
  constexpr double to_other_bank = 0.25;
  std::vector<int> others;
  for (std::size_t j = 0; j < banks.size(); ++j)
    if (j != k)
      for (const auto& bank : banks[j]) others.insert(others.end(), bank.begin(), bank.end());
  const std::vector<double> here = distances(cut, banks[k][side]);
  double width = around.length[k] / 8;
  for (const auto& corners : cut.surface.triangles()) // a row at least
    if (std::any_of(corners.begin(), corners.end(), [&here](int v) { return here[v] == 0; }))
      for (const int v : corners) width = std::max(width, 1.01 * here[v]);
  const std::vector<double> from_others = distances(cut, others);
  const std::vector<double> from_other_bank = distances(cut, banks[k][1 - side]);
  std::vector<double> inside;
  inside.reserve(here.size());
  for (std::size_t v = 0; v < here.size(); ++v) {
    const double least = std::min({width, to_others * from_others[v], to_other_bank * from_other_bank[v]});
    inside.push_back(here[v] > 0 ? 1 - here[v] / least : 1.0);
  }
  return inside;
}

/// 0.8 and 0.2 on the trees; from 1 on and above on inner walls at banks of the first, 0 and below on those
/// of the other; harmonic elsewhere. By corners. Empty if there are no trees.
CornerValues harmonic_between_trees(const TunnelLoops& around, int branches) {
  constexpr std::array on_trees{0.8, 0.2};
  const surface::TriangleMesh cut = opened(around.surface);
  const Banks banks = banks_of(cut.surface, around);
  const auto found = opposite_trees(cut, banks, branches);
  if (!found) return {};
  std::vector<char> held(cut.points.size(), 0);
  std::vector<double> data(held.size(), 0.0);
  std::vector<int> owner(held.size(), -1);
  std::vector<double> walls(held.size(), 0.0);
  for (const int k : {0, 1})
    for (const int v : found->trees[k]) {
      held[v] = 1;
      data[v] = on_trees[k];
      owner[v] = k;
    }
  for (std::size_t loop = 0; loop < banks.size(); ++loop)
    for (const int side : {0, 1}) {
      const int k = found->is_first(banks[loop][side]) ? 0 : 1;
      const std::vector<double> inside = inside_wall(cut, around, banks, loop, side);
      for (std::size_t v = 0; v < inside.size(); ++v) {
        if (inside[v] <= 0 || owner[v] == 1 - k) continue;
        held[v] = 1;
        data[v] = k == 0 ? 1 : 0;
        walls[v] = k == 0 ? inside[v] : -inside[v];
      }
    }
  const std::vector<double> weight = surface::half_cotangents(cut);
  std::vector<double> f = surface::LaplaceSolver(cut.surface, weight, held).solve({data}).front();
  std::transform(f.begin(), f.end(), walls.begin(), f.begin(), std::plus<>());
  CornerValues values;
  values.reserve(cut.surface.triangles().size());
  for (const auto& [a, b, c] : cut.surface.triangles()) values.push_back({f[a], f[b], f[c]});
  return values;
}

/// Where the ceiling begins and ends, the floor begins and ends. What differs least from 1/2 is the outer
/// wall, until it has a fifth of the area, but nothing that trees hold.
std::array<double, 4> levels_of(const Solid& solid, const CornerValues& values) {
  constexpr double most = 0.25;
  const std::vector<Point> areas = vector_areas(solid);
  std::vector<std::pair<double, double>> by_difference; // and area
  by_difference.reserve(values.size());
  double whole = 0;
  for (std::size_t t = 0; t < values.size(); ++t) {
    const double mean = (values[t][0] + values[t][1] + values[t][2]) / 3;
    by_difference.emplace_back(std::abs(mean - 0.5), norm(areas[t]));
    whole += by_difference.back().second;
  }
  std::sort(by_difference.begin(), by_difference.end());
  double area = 0;
  double outer = 0;
  for (const auto& [difference, more] : by_difference) {
    if (area > whole / 5 || difference > most) break;
    area += more;
    outer = difference;
  }
  return {0, 0.5 - outer, 0.5 + outer, 1};
}

} // namespace

std::optional<TunnelLoops> tunnel_loops(const Solid& solid, const FirstHomology& homology) {
  std::vector<Point> points;
  points.reserve(solid.vertex.size());
  for (const int v : solid.vertex) points.push_back(solid.point(v));
  TunnelLoops found{MarkedSurface(solid.boundary, std::move(points)), {}, {}};
  std::vector<FirstHomology::Element> chosen;
  for (int k = 1; k <= genus(solid); ++k) {
    surface::TriangleMesh cut = opened(found.surface);
    std::optional<Candidate> best = shortest_loop(LoopSearch(cut, homology, chosen));
    if (!best) {
      move_boundary_away(cut);
      best = shortest_loop(LoopSearch(std::move(cut), homology, chosen));
    }
    if (!best) return {};
    for (const SideEnd e : best->loop) surface::set_mark(found.surface, e.side, e.at_start ? k : -k);
    chosen.push_back(homology.of(best->loop));
    found.loops.push_back(std::move(best->loop));
    found.length.push_back(best->length);
  }
  return found;
}

std::optional<Tunnel> tunnel(const Solid& solid, const TunnelLoops& around, int branches) {
  Tunnel found;
  found.values = harmonic_between_trees(around, branches);
  if (found.values.empty()) return {};
  found.levels = levels_of(solid, found.values);
  found.how = around.loops.size() == 1 ? "around the tunnel of the loop" : "around the tunnels of the loops";
  for (std::size_t k = 0; k < around.loops.size(); ++k)
    found.how += std::string(k == 0 ? "" : " and") + " of " + std::to_string(around.loops[k].size()) +
                 " edges through vertex " +
                 std::to_string(solid.vertex[around.surface.surface.vertex(around.loops[k].front())]);
  if (branches > 0) found.how += ", with " + std::to_string(branches) + " branches";
  return found;
}

} // namespace tetrarch::product
