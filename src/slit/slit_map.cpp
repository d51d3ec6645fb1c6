// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/slit_map.hpp"

#include "full_turn.hpp"
#include "slit_curve.hpp"
#include "tetrarch/core/error.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>

namespace tetrarch::slit {
namespace {

using surface::Side;
using surface::SideEnd;

/// The values of log r on the loops for which the fluxes are 2 pi, -2 pi and 0 (equation 2.1).
std::vector<double> heights(const OneForms& forms, int outer, int inner) {
  const int n = forms.loop_count();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(n);
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) matrix(j, k) = j == outer || k == outer ? j == k : forms.flux(j, k);
  wanted[inner] = -full_turn;
  // Without the outer loop, the symmetric matrix of energies is positive definite.
  const Eigen::VectorXd solution = matrix.ldlt().solve(wanted);
  return {solution.data(), solution.data() + n};
}

/// The angle at each start of the sides of a loop, from 0 on.
std::vector<double> unrolled(const OneForm& angle, const surface::BoundaryLoop& loop) {
  std::vector<double> at{0.0};
  for (const SideEnd e : loop.sides) at.push_back(at.back() + angle[e.side.value]);
  at.pop_back();
  return at;
}

/// How often the direction changes on the way round; steps of 0 have none.
int turns(const std::vector<double>& at) {
  std::vector<bool> forward;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (const double step = at[(k + 1) % at.size()] - at[k]; step != 0) forward.push_back(step > 0);
  int count = 0;
  for (std::size_t k = 0; k < forward.size(); ++k)
    if (forward[k] != forward[(k + 1) % forward.size()]) ++count;
  return count;
}

Slit slit(const OneForms& forms, const SlitMap& map, int loop) {
  const auto& sides = forms.loops()[loop].sides;
  const std::vector<double> at = unrolled(map.form.imaginary, forms.loops()[loop]);
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  const SlitCurve curve = slit_curve(forms, map.form.imaginary, loop);
  Slit result;
  result.loop = loop;
  result.start_vertex = forms.mesh().surface.vertex(sides[low - at.begin()]);
  result.end_vertex = forms.mesh().surface.vertex(sides[high - at.begin()]);
  result.radius = std::exp(map.log_radius[result.start_vertex]);
  result.start = wrapped(map.angle[forms.mesh().surface.vertex(sides.front())] + curve.lowest);
  result.end = result.start + (curve.highest - curve.lowest);
  result.turns = turns(at);
  return result;
}

void rotate_to(SlitMap& map, double origin) {
  for (double& angle : map.angle) angle = wrapped(angle - origin);
}

} // namespace

std::complex<double> SlitMap::concentric(int vertex) const {
  return std::polar(std::exp(log_radius[vertex]), angle[vertex]);
}

std::array<double, 3> SlitMap::cylindric(int vertex) const {
  return {std::cos(angle[vertex]), std::sin(angle[vertex]), -log_radius[vertex]};
}

SlitMap slit_map(const OneForms& forms, int outer, int inner) {
  for (const int loop : {outer, inner})
    if (loop < 0 || loop >= forms.loop_count())
      throw InputError("there is no loop " + std::to_string(loop) + ", only 0 to " +
                       std::to_string(forms.loop_count() - 1));
  if (outer == inner)
    throw InputError("the outer and the inner loop must differ, but both are " + std::to_string(outer));
  const surface::Surface& surface = forms.mesh().surface;
  SlitMap map;
  map.outer = outer;
  map.inner = inner;
  const std::vector<double> height = heights(forms, outer, inner);
  map.modulus = -height[inner];
  const auto vertices = static_cast<std::size_t>(surface.vertex_count());
  map.log_radius.assign(vertices, 0.0);
  for (int k = 0; k < forms.loop_count(); ++k)
    for (std::size_t v = 0; v < vertices; ++v) map.log_radius[v] += height[k] * forms.potential(k)[v];

  const OneForm out = forms.tau(outer);
  const OneForm in = forms.tau(inner);
  map.form.real = differential(surface, map.log_radius);
  map.form.imaginary.resize(out.size());
  for (std::size_t s = 0; s < out.size(); ++s) map.form.imaginary[s] = full_turn * (out[s] - in[s]);
  map.modulus_bound = full_turn * (forms.tau_product(outer, outer) - 2 * forms.tau_product(outer, inner) +
                                   forms.tau_product(inner, inner));
  // The jumps are whole turns, so the lags are the angle: nothing is integrated.
  map.angle.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    map.angle[v] = full_turn * (forms.lag(outer)[v] - forms.lag(inner)[v]);

  rotate_to(map, map.angle[surface.vertex(forms.loops()[outer].sides.front())]);
  for (int k = 0; k < forms.loop_count(); ++k)
    if (k != outer && k != inner) map.slits.push_back(slit(forms, map, k));
  if (map.slits.empty()) return map;
  const double origin = map.slits.front().start;
  rotate_to(map, origin);
  for (Slit& s : map.slits) {
    const double length = s.end - s.start;
    s.start = wrapped(s.start - origin);
    s.end = s.start + length;
  }
  return map;
}

void require_radii(const SlitMap& map) {
  constexpr double greatest = 700;
  if (map.modulus < greatest) return;
  throw InputError("the inner radius, e^-" + std::to_string(map.modulus) +
                   ", is too small for a double; the surface is too long and thin for this domain (the "
                   "cylindric and the parallel domain have room for it)");
}

LoopPair farthest_loops(const OneForms& forms) {
  // The modulus is 2 pi times the effective resistance. Constants are the kernel of the fluxes; with a 1
  // there the inverse gives resistances.
  const int n = forms.loop_count();
  Eigen::MatrixXd matrix(n, n);
  double scale = 0;
  for (int j = 0; j < n; ++j) scale = std::max(scale, forms.flux(j, j));
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) matrix(j, k) = forms.flux(j, k) + scale / n;
  const Eigen::MatrixXd inverse = matrix.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  LoopPair best;
  double greatest = -1;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < j; ++k)
      if (const double resistance = inverse(j, j) + inverse(k, k) - 2 * inverse(j, k);
          resistance > greatest) {
        greatest = resistance;
        best = forms.flux(j, j) > forms.flux(k, k) ? LoopPair{j, k} : LoopPair{k, j};
      }
  return best;
}

ParallelDomain parallel_domain(const surface::Surface& surface, const SlitMap& map) {
  ParallelDomain domain;
  domain.corners.resize(static_cast<std::size_t>(surface.triangle_count()));
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const auto& vertex = surface.corners(t);
    std::array<double, 3> angle{};
    angle[0] = map.angle[vertex[0]];
    angle[1] = angle[0] + map.form.imaginary[Side(t, 2).value];
    angle[2] = angle[0] - map.form.imaginary[Side(t, 1).value];
    const double centroid = (angle[0] + angle[1] + angle[2]) / 3;
    const double shift = -full_turn * std::floor(centroid / full_turn);
    for (int c = 0; c < 3; ++c) domain.corners[t][c] = {angle[c] + shift, -map.log_radius[vertex[c]]};
  }
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    const Side m = surface.mate(s);
    if (!m.exists()) continue;
    const double here = domain.corners[s.triangle()][s.next().corner()][0];
    const double there = domain.corners[m.triangle()][m.previous().corner()][0];
    if (std::abs(here - there) > full_turn / 2) domain.seam.push_back(s);
  }
  return domain;
}

} // namespace tetrarch::slit
