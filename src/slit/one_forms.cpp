// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/one_forms.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using surface::Surface;
using Columns = surface::LaplaceSolver::Columns;

/// The loops of a sphere with holes. A mesh is connected, and only what cannot be oriented has turned sides.
std::vector<surface::BoundaryLoop> loops_of(const surface::TriangleMesh& mesh) {
  const Surface& surface = mesh.surface;
  std::vector<surface::BoundaryLoop> loops = surface::boundary_loops(mesh);
  int sides = surface.side_count();
  for (const auto& loop : loops) sides += static_cast<int>(loop.sides.size());
  SurfaceType type;
  type.euler = surface.vertex_count() - sides / 2 + surface.triangle_count();
  type.boundary_curves = static_cast<int>(loops.size());
  for (int k = 0; k < surface.side_count() && type.orientable; ++k)
    type.orientable = !surface.is_turned(Side(k));
  // Crosscaps count as genus.
  if (type.genus() != 0)
    throw InputError("slit maps need a sphere with holes, but this surface has type " + type.str());
  if (type.boundary_curves < 2)
    throw InputError("slit maps need at least two boundary loops, but this surface has " +
                     std::to_string(type.boundary_curves));
  return loops;
}

/// What is 1 on loop k and 0 on the others.
std::vector<double> indicator(const std::vector<int>& loop_of, int k) {
  std::vector<double> values(loop_of.size(), 0.0);
  for (std::size_t v = 0; v < loop_of.size(); ++v)
    if (loop_of[v] == k) values[v] = 1;
  return values;
}

/// Said before any work begins: each loop but one takes two functions.
void require_memory(std::size_t loops, int vertices) {
  constexpr double budget = 16e9;
  const double bytes = 8.0 * static_cast<double>(loops) *
                       (2.0 * static_cast<double>(vertices) + 2.0 * static_cast<double>(loops));
  if (bytes > budget)
    throw InputError("slit maps of " + std::to_string(loops) + " boundary loops and " +
                     std::to_string(vertices) + " vertices take " +
                     std::to_string(std::llround(bytes / 1e9)) +
                     " GB, two functions for each loop; at most 16 are allowed (fill small holes first)");
}

/// The solutions for right-hand sides 1 to n - 1, some at a time, so that a job can be stopped in between and
/// no more of the right-hand sides than that are there at once. Number 0 is left empty.
template <class RightSide>
Columns solved_in_batches(const surface::LaplaceSolver& solver, std::size_t n, const RightSide& right,
                          const Progress& progress, double from, double to) {
  constexpr std::size_t batch = 16;
  Columns result(1);
  for (std::size_t first = 1; first < n; first += batch) {
    progress.step("harmonic functions",
                  from + (to - from) * static_cast<double>(first) / static_cast<double>(n));
    Columns data;
    for (std::size_t k = first; k < std::min(first + batch, n); ++k) data.push_back(right(k));
    for (auto& column : solver.solve(data)) result.push_back(std::move(column));
  }
  return result;
}

/// Of each function and each loop, the flux out through the loop. One pass over the sides, whatever the
/// number of functions.
std::vector<std::vector<double>> fluxes_through_loops(const Surface& surface,
                                                      const std::vector<double>& weight,
                                                      const std::vector<int>& loop_of,
                                                      const Columns& functions) {
  std::vector<std::vector<double>> flux(functions.size(), std::vector<double>(functions.size(), 0.0));
  for (int s = 0; s < surface.side_count(); ++s) {
    const int v = surface.from(Side(s));
    const int u = surface.to(Side(s));
    if (loop_of[v] == loop_of[u]) continue;
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const double flow = weight[s] * (functions[k][v] - functions[k][u]);
      if (loop_of[v] >= 0) flux[loop_of[v]][k] += flow;
      if (loop_of[u] >= 0) flux[loop_of[u]][k] -= flow;
    }
  }
  return flux;
}

/// Calls job(side, value) for the jump of a strip: 1 on the sides by which it leaves triangles, -1 on those
/// by which it enters them, the first of which is `start`.
template <class Job>
void for_each_jump(const Surface& surface, Side start, const std::vector<Side>& strip, const Job& job) {
  if (strip.empty()) return;
  job(start, -1);
  for (const Side s : strip) {
    job(s, 1);
    if (!surface.is_boundary(s)) job(surface.mate(s), -1);
  }
}

/// For each loop but 0 a strip of triangles from the first side of loop 0, `start`: along a tree of
/// triangles, as low as can be, in which the loop is reached by the first side that the tree comes to.
std::vector<std::vector<Side>> strips(const Surface& surface, const std::vector<int>& loop_of,
                                      std::size_t loops, Side start) {
  std::vector<Side> entered(static_cast<std::size_t>(surface.triangle_count()));
  std::vector<int> queue{start.triangle()};
  entered[start.triangle()] = start;
  std::vector<std::vector<Side>> strip(loops);
  std::size_t found = 1;
  for (std::size_t next = 0; found < loops; ++next)
    for (const Side s : surface::sides_of(queue[next])) {
      if (const Side m = surface.mate(s); m.exists()) {
        if (entered[m.triangle()].exists()) continue;
        entered[m.triangle()] = m;
        queue.push_back(m.triangle());
      } else if (const int k = loop_of[surface.from(s)]; k > 0 && strip[k].empty()) {
        for (Side leave = s; leave.exists(); leave = surface.mate(entered[leave.triangle()]))
          strip[k].push_back(leave);
        ++found;
      }
    }
  return strip;
}

/// The jumps of all strips as numbers of the sides.
std::vector<std::vector<int>> jumps(const Surface& surface, Side start,
                                    const std::vector<std::vector<Side>>& strip) {
  std::vector<std::vector<int>> result(strip.size(), std::vector<int>(surface.side_count(), 0));
  for (std::size_t k = 0; k < strip.size(); ++k)
    for_each_jump(surface, start, strip[k], [&](Side s, int jump) { result[k][s.value] += jump; });
  return result;
}

/// Where a form jumps, and by how much.
using Jumps = std::vector<std::pair<Side, int>>;

/// tau = jump + d(lag) is orthogonal to the differential of every function, so the lag is loaded with minus
/// what the jump pairs to with the hat function of each vertex.
std::vector<double> load_of(const Surface& surface, const std::vector<double>& weight, const Jumps& jumps) {
  std::vector<double> load(static_cast<std::size_t>(surface.vertex_count()), 0.0);
  for (const auto& [s, jump] : jumps) {
    load[surface.to(s)] -= weight[s.value] * jump;
    load[surface.from(s)] += weight[s.value] * jump;
  }
  load[0] = 0; // held there
  return load;
}

/// <tau, tau'> = <jump, tau'>, as d(lag) is orthogonal to tau'.
double product(const Surface& surface, const std::vector<double>& weight, const Jumps& jumps,
               const std::vector<double>& lag, const Jumps& other) {
  double sum = 0;
  for (const auto& [s, jump] : jumps)
    sum += weight[s.value] * jump * (lag[surface.to(s)] - lag[surface.from(s)]);
  std::map<int, int> values;
  for (const auto& [s, jump] : other) values[s.value] += jump;
  for (const auto& [s, jump] : jumps)
    if (const auto found = values.find(s.value); found != values.end())
      sum += weight[s.value] * jump * found->second;
  return sum;
}

} // namespace

OneForms::OneForms(surface::TriangleMesh mesh, const Progress& progress, Edges edges)
    : mesh_(std::move(mesh)), loops_(loops_of(mesh_)) {
  require_memory(loops_.size(), mesh_.surface.vertex_count());
  const std::vector<int> loop_of = surface::loops_of_vertices(loops_, mesh_.surface);
  strip_ = strips(mesh_.surface, loop_of, loops_.size(), start());
  std::vector<Jumps> jumping(loops_.size());
  if (edges == Edges::intrinsic_delaunay) {
    auto carried = jumps(mesh_.surface, start(), strip_);
    intrinsic_ = surface::intrinsic_delaunay(mesh_, &carried);
    weight_ = surface::half_cotangents(*intrinsic_);
    for (std::size_t k = 0; k < carried.size(); ++k)
      for (std::size_t s = 0; s < carried[k].size(); ++s)
        if (carried[k][s] != 0) jumping[k].emplace_back(Side(static_cast<int>(s)), carried[k][s]);
  } else {
    weight_ = surface::half_cotangents(mesh_);
    for (std::size_t k = 0; k < strip_.size(); ++k)
      for_each_jump(mesh_.surface, start(), strip_[k],
                    [&](Side s, int jump) { jumping[k].emplace_back(s, jump); });
  }

  progress.step("harmonic functions", 0);
  std::vector<char> held(loop_of.size(), 0);
  held[0] = 1;
  solver_.emplace(solved_on(), weight_, held);
  lag_ = solved_in_batches(
      *solver_, loops_.size(), [&](std::size_t k) { return load_of(solved_on(), weight_, jumping[k]); },
      progress, 0.2, 0.5);
  lag_[0].assign(loop_of.size(), 0.0);
  tau_product_.assign(loops_.size(), std::vector<double>(loops_.size(), 0.0));
  for (std::size_t j = 1; j < loops_.size(); ++j, progress.step("harmonic functions", 0.5))
    for (std::size_t k = 1; k < loops_.size(); ++k)
      tau_product_[j][k] = product(solved_on(), weight_, jumping[j], lag_[k], jumping[k]);

  progress.step("harmonic functions", 0.5);
  for (std::size_t v = 0; v < held.size(); ++v) held[v] = static_cast<char>(loop_of[v] >= 0);
  solver_->hold(held);
  potential_ = solved_in_batches(
      *solver_, loops_.size(), [&](std::size_t k) { return indicator(loop_of, static_cast<int>(k)); },
      progress, 0.7, 1);
  std::vector<double> rest(loop_of.size(), 1.0);
  for (std::size_t k = 1; k < potential_.size(); ++k)
    for (std::size_t v = 0; v < rest.size(); ++v) rest[v] -= potential_[k][v];
  potential_[0] = std::move(rest);
  flux_ = fluxes_through_loops(solved_on(), weight_, loop_of, potential_);
  progress.step("harmonic functions", 1);
}

Columns OneForms::extended(const Columns& values) const {
  // Inside, the solver reads loads.
  Columns data;
  for (const auto& given : values) {
    if (given.size() != mesh_.points.size()) throw PreconditionError("each vertex needs a value");
    data.emplace_back(given.size(), 0.0);
    for (const auto& loop : loops_)
      for (const surface::SideEnd e : loop.sides)
        data.back()[mesh_.surface.vertex(e)] = given[mesh_.surface.vertex(e)];
  }
  return solver_->solve(data);
}

std::vector<std::complex<double>> OneForms::extended(const std::vector<std::complex<double>>& values) const {
  Columns parts(2);
  for (const std::complex<double>& z : values) {
    parts[0].push_back(z.real());
    parts[1].push_back(z.imag());
  }
  parts = extended(parts);
  std::vector<std::complex<double>> result;
  for (std::size_t v = 0; v < values.size(); ++v) result.emplace_back(parts[0][v], parts[1][v]);
  return result;
}

std::vector<double> OneForms::conjugate_along(int loop) const {
  const auto& sides = loops_[loop].sides;
  std::vector<double> result{0.0};
  for (const surface::SideEnd e : sides) {
    double step = 0;
    // Strips cross the boundary at their two ends only.
    for (int i = 1; i < loop_count(); ++i)
      step += flux(i, loop) * (lag(i)[mesh_.surface.to(e.side)] - lag(i)[mesh_.surface.from(e.side)] +
                               (e.side == strip_[i].front() ? 1 : 0) - (e.side == start() ? 1 : 0));
    result.push_back(result.back() + step);
  }
  return result;
}

OneForm OneForms::tau(int loop) const {
  OneForm form = differential(mesh_.surface, lag(loop));
  for_each_jump(mesh_.surface, start(), strip_[loop], [&](Side s, int jump) { form[s.value] += jump; });
  return form;
}

} // namespace tetrarch::slit
