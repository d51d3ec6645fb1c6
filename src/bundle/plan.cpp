// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/plan.hpp"

#include "tetrarch/bundle/twist.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/canonical_loops.hpp"
#include "tetrarch/surface/cuts.hpp"
#include "tetrarch/surface/equator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace tetrarch::bundle {
namespace {

using surface::MarkedSurface;
using Method = Plan::Method;

/// The power of two that makes the greatest coordinate about 1, if it is so large or small that lengths,
/// middles of edges or their sums would leave the range of doubles; else 0, so that nothing is rounded.
int exponent_of(const std::vector<std::array<double, 3>>& points) {
  double greatest = 0;
  for (const auto& p : points)
    for (const double x : p) greatest = std::max(greatest, std::fabs(x));
  constexpr int harmless = 300; // of 1023: squares and sums of many are in range
  const int exponent = greatest > 0 && std::isfinite(greatest) ? std::ilogb(greatest) : 0;
  return std::abs(exponent) > harmless ? exponent : 0;
}

void scale(std::vector<std::array<double, 3>>& points, int exponent) {
  if (exponent == 0) return;
  for (auto& p : points)
    for (double& x : p) x = std::scalbn(x, exponent);
}

class Planner {
public:
  Planner(MarkedSurface surface, const PlanOptions& options, const Progress& progress)
      : options_(options), progress_(progress) {
    plan_.cut = std::move(surface);
    exponent_ = exponent_of(plan_.cut.points);
    scale(plan_.cut.points, -exponent_);
    std::fill(plan_.cut.mark.begin(), plan_.cut.mark.end(), 0);
    type_ = surface::type_of(plan_.cut.surface);
    if (options_.fiber < 1) throw PreconditionError("a fiber needs at least one edge");
    if (options_.euler && !type_.is_closed())
      throw PreconditionError("a surface with boundary has no Euler number");
    if (options_.boundary && type_.is_closed()) throw PreconditionError("a closed surface has no boundary");
    plan_.euler = type_.is_closed() ? options_.euler.value_or(type_.euler) : 0;
    total_ = plan_.euler * options_.fiber;
  }

  std::variant<Plan, Obstruction> run() && {
    if (type_.orientable) orient_parts(plan_.cut);
    const int root = make_cut();
    if (!type_.orientable) orient_parts(plan_.cut);
    std::vector<int> twist = twists();
    if (total_ != 0 && static_cast<int>(cut_edges(plan_.cut).size()) == std::abs(total_)) {
      // Every value on the boundary of a covering disk is the same: it needs a vertex inside.
      if (give_inner_vertices(plan_.cut) > 0) twist = spread_twist(plan_.cut, total_);
    }
    std::vector<Shift> shift = shifts_of(plan_.cut, twist, root);
    Values values = values_of(plan_.cut, twist, options_.boundary);
    if (values.obstruction) return *std::move(values.obstruction);
    scale(plan_.cut.points, exponent_);
    plan_.recipe = {plan_.cut.surface, options_.fiber, std::move(shift), std::move(values.value)};
    return std::move(plan_);
  }

private:
  /// Marks the cut; returns a vertex on it.
  int make_cut() {
    const bool by_text = options_.cut == PlanOptions::Cut::dissertation;
    if (type_.is_disk()) return 0;
    if (by_text && type_.is_sphere()) {
      plan_.method = Method::equator;
      constexpr int seeds = 8;
      surface::mark_equator(plan_.cut, std::max(3, std::abs(total_)), seeds, progress_);
    } else if (by_text && type_.is_closed() && type_.orientable) {
      plan_.method = Method::canonical_loops;
      const surface::CanonicalLoops loops = surface::mark_canonical_loops(plan_.cut, -1, progress_);
      lengthen_loops();
      return loops.base;
    } else {
      plan_.method = Method::cut_graph;
      surface::mark_cut_graph(plan_.cut);
    }
    split_cut_edges(plan_.cut, std::abs(total_));
    return root();
  }

  /// Where shifts may jump by whole turns: a vertex at which a curve of the cut begins, if there is one.
  int root() const {
    const auto edges = cut_edges(plan_.cut);
    std::vector<int> degree(static_cast<std::size_t>(plan_.cut.surface.vertex_count()), 0);
    for (const Side s : edges)
      for (const int v : {plan_.cut.surface.from(s), plan_.cut.surface.to(s)}) ++degree[v];
    for (const Side s : edges)
      for (const int v : {plan_.cut.surface.from(s), plan_.cut.surface.to(s)})
        if (degree[v] != 2) return v;
    return plan_.cut.surface.from(edges.front());
  }

  bool twists_by_text() const {
    return plan_.method == Method::canonical_loops && plan_.euler == type_.euler;
  }

  void lengthen_loops() {
    if (twists_by_text())
      for (int k = 3; k <= 2 * type_.genus(); ++k) surface::lengthen(plan_.cut, k, options_.fiber);
    else
      split_cut_edges(plan_.cut, std::abs(total_));
  }

  std::vector<int> twists() const {
    if (!twists_by_text()) return spread_twist(plan_.cut, total_);
    std::vector<int> twist(static_cast<std::size_t>(plan_.cut.surface.side_count()), 0);
    std::vector<int> left(static_cast<std::size_t>(2 * type_.genus()) + 1, options_.fiber);
    for (const Side s : cut_edges(plan_.cut))
      if (plan_.cut[s] >= 3 && left[plan_.cut[s]]-- > 0)
        twist[s.value] = twist[plan_.cut.surface.mate(s).value] = 1;
    return twist;
  }

  const PlanOptions& options_;
  const Progress& progress_;
  SurfaceType type_;
  Plan plan_;
  int total_ = 0;    ///< the twist in all
  int exponent_ = 0; ///< of two, by which the points are divided meanwhile
};

} // namespace

std::variant<Plan, Obstruction> plan(MarkedSurface surface, const PlanOptions& options,
                                     const Progress& progress) {
  return Planner(std::move(surface), options, progress).run();
}

} // namespace tetrarch::bundle
