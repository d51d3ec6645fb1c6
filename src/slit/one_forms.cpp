// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/one_forms.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/laplacian.hpp"

#include <string>
#include <utility>

namespace tetrarch::slit {
namespace {

using mesh::Side;
using mesh::Surface;

void check_topology(const Surface& surface) {
  const SurfaceType type = mesh::type_of(surface);
  // Crosscaps count as genus.
  if (type.genus() != 0)
    throw InputError("slit maps need a sphere with holes, but this surface has type " + type.str());
  if (type.boundary_curves < 2)
    throw InputError("slit maps need two boundary loops at least, and this surface has " +
                     std::to_string(type.boundary_curves));
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

} // namespace

OneForms::OneForms(mesh::TriangleMesh mesh, const Progress& progress) : mesh_(std::move(mesh)) {
  check_topology(mesh_.surface);
  loops_ = mesh::boundary_loops(mesh_);
  weight_ = mesh::half_cotangents(mesh_);
  progress.step("harmonic functions", 0);
  solve_potentials();
  progress.step("harmonic functions", 0.5);
  find_strips();
  solve_lags();
  progress.step("harmonic functions", 1);
}

void OneForms::solve_potentials() {
  const auto vertices = static_cast<std::size_t>(mesh_.surface.vertex_count());
  std::vector<char> held(vertices, 0);
  mesh::LaplaceSolver::Columns data(loops_.size() - 1, std::vector<double>(vertices, 0.0));
  for (std::size_t k = 0; k < loops_.size(); ++k)
    for (const mesh::SideEnd e : loops_[k].sides) {
      held[mesh_.surface.vertex(e)] = 1;
      if (k > 0) data[k - 1][mesh_.surface.vertex(e)] = 1;
    }
  potential_ = mesh::LaplaceSolver(mesh_.surface, weight_, std::move(held)).solve(data);
  std::vector<double> rest(vertices, 1.0);
  for (const auto& f : potential_)
    for (std::size_t v = 0; v < vertices; ++v) rest[v] -= f[v];
  potential_.insert(potential_.begin(), std::move(rest));

  flux_.assign(loops_.size(), std::vector<double>(loops_.size(), 0.0));
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    const std::vector<double> out = mesh::fluxes(mesh_.surface, weight_, potential_[k]);
    for (std::size_t j = 0; j < loops_.size(); ++j)
      for (const mesh::SideEnd e : loops_[j].sides) flux_[j][k] += out[mesh_.surface.vertex(e)];
  }
}

/// A tree of triangles, as low as can be, from the first side of loop 0; each loop is reached by the first
/// side that the tree comes to.
void OneForms::find_strips() {
  const Surface& surface = mesh_.surface;
  std::vector<int> loop_of(static_cast<std::size_t>(surface.side_count()), -1);
  for (int k = 0; k < loop_count(); ++k)
    for (const mesh::SideEnd e : loops_[k].sides) loop_of[e.side.value] = k;
  const Side start = loops_[0].sides.front().side;
  std::vector<Side> entered(static_cast<std::size_t>(surface.triangle_count()));
  std::vector<int> queue{start.triangle()};
  entered[start.triangle()] = start;
  strip_.resize(loops_.size());
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const Side s : mesh::sides_of(queue[next])) {
      if (const Side m = surface.mate(s); m.exists()) {
        if (entered[m.triangle()].exists()) continue;
        entered[m.triangle()] = m;
        queue.push_back(m.triangle());
      } else if (const int k = loop_of[s.value]; k > 0 && strip_[k].empty()) {
        for (Side leave = s; leave.exists(); leave = surface.mate(entered[leave.triangle()]))
          strip_[k].push_back(leave);
      }
    }
}

/// tau = jump + d(lag) is orthogonal to the differential of every function, so the lag is loaded with minus
/// what the jump pairs to with the hat function of each vertex.
void OneForms::solve_lags() {
  const auto vertices = static_cast<std::size_t>(mesh_.surface.vertex_count());
  mesh::LaplaceSolver::Columns loads(loops_.size() - 1, std::vector<double>(vertices, 0.0));
  for (std::size_t k = 0; k < loads.size(); ++k)
    for_each_jump(mesh_.surface, loops_[0].sides.front().side, strip_[k + 1], [&](Side s, int jump) {
      loads[k][mesh_.surface.to(s)] -= weight_[s.value] * jump;
      loads[k][mesh_.surface.from(s)] += weight_[s.value] * jump;
    });
  std::vector<char> held(vertices, 0);
  held[0] = 1;
  for (auto& load : loads) load[0] = 0;
  lag_ = mesh::LaplaceSolver(mesh_.surface, weight_, std::move(held)).solve(loads);
  lag_.insert(lag_.begin(), std::vector<double>(vertices, 0.0));
}

OneForm OneForms::tau(int loop) const {
  OneForm form = differential(mesh_.surface, lag(loop));
  for_each_jump(mesh_.surface, loops_[0].sides.front().side, strip_[loop],
                [&](Side s, int jump) { form[s.value] += jump; });
  return form;
}

} // namespace tetrarch::slit
