// SPDX-License-Identifier: GPL-2.0-or-later
#include "log_extension.hpp"

#include "full_turn.hpp"
#include "log_curve.hpp"
#include "periodic.hpp"
#include "slit_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;

/// Of each vertex of a loop the parameter on its curve.
std::vector<double> parameters(const OneForms& forms, const SlitMap& map, int loop) {
  if (loop != map.outer && loop != map.inner) return slit_curve(forms, map.form.imaginary, loop).parameter;
  std::vector<double> t;
  for (const surface::SideEnd e : forms.loops()[loop].sides)
    t.push_back(map.angle[forms.mesh().surface.vertex(e)]);
  return t;
}

Complex log_of_ring(const SlitMap& map, int v) {
  return {map.log_radius[v], map.angle[v]};
}

/// A curve between its samples, and what was added to it.
class CarriedCurve {
public:
  CarriedCurve(const LogCurve& from, const LogCurve& onto, bool goes_round)
      : goes_round_(goes_round), center_(onto.center), offset_(offsets(onto, goes_round)),
        added_(differences(from, onto)) {}

  Complex at(double t) const { return center_ + offset_(t) + Complex(0, goes_round_ ? t : 0); }
  Complex added(double t) const { return added_(t); }

private:
  static Periodic offsets(const LogCurve& curve, bool goes_round) {
    std::vector<Complex> result;
    for (std::size_t j = 0; j < curve.size(); ++j) {
      const double t = full_turn * static_cast<double>(j) / static_cast<double>(curve.size());
      result.push_back(curve.offset[j] - Complex(0, goes_round ? t : 0));
    }
    return Periodic(result);
  }
  static Periodic differences(const LogCurve& from, const LogCurve& onto) {
    std::vector<Complex> result;
    for (std::size_t j = 0; j < from.size(); ++j) result.push_back(onto.at(j) - from.at(j));
    return Periodic(result);
  }

  bool goes_round_;
  Complex center_;
  Periodic offset_;
  Periodic added_;
};

/// A circle on a branch, with its own logs.
struct Branch {
  Complex center;
  std::vector<Complex> log; ///< of each vertex: log(z - center)
};

double distance_to_others(const std::vector<Circle>& circles, std::size_t k) {
  const Complex c = circles[k].center;
  double least = std::min(1 - std::abs(c), std::abs(c) - circles[1].radius);
  for (std::size_t j = 2; j < circles.size(); ++j)
    if (j != k) least = std::min(least, std::abs(circles[j].center - c) - circles[j].radius);
  return least;
}

std::vector<std::size_t> small_circles(const std::vector<Circle>& circles) {
  constexpr double small = 0.05;
  constexpr std::size_t most = 16;
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t k = 2; k < circles.size(); ++k)
    if (const double size = circles[k].radius / distance_to_others(circles, k); size < small)
      found.emplace_back(size, k);
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), most));
  std::vector<std::size_t> result;
  result.reserve(found.size());
  for (const auto& [size, k] : found) result.push_back(k);
  return result;
}

/// arg(z - center) minus the angle of a slit map, continued from vertex `start` along the mesh.
std::vector<double> continued_turn(const surface::Surface& surface, const SlitMap& map,
                                   const std::vector<Complex>& z, Complex center, int start) {
  std::vector<std::vector<Side>> from(z.size());
  for (int s = 0; s < surface.side_count(); ++s) {
    from[surface.from(Side(s))].push_back(Side(s));
    if (surface.is_boundary(Side(s))) from[surface.to(Side(s))].push_back(Side(s));
  }
  std::vector<double> turn(z.size(), 0.0);
  std::vector<char> met(z.size(), 0);
  std::vector<int> queue{start};
  met[start] = 1;
  turn[start] = std::arg(z[start] - center) - map.angle[start];
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int u = queue[next];
    for (const Side s : from[u]) {
      const int v = surface.from(s) == u ? surface.to(s) : surface.from(s);
      if (std::exchange(met[v], 1)) continue;
      const double along = map.form.imaginary[s.value] * (surface.from(s) == u ? 1 : -1);
      turn[v] = turn[u] + std::remainder(std::arg((z[v] - center) / (z[u] - center)) - along, full_turn);
      queue.push_back(v);
    }
  }
  return turn;
}

Complex flux_through(const OneForms& forms, const std::vector<int>& loop_of, int loop,
                     const std::vector<Complex>& f) {
  const surface::Surface& surface = forms.solved_on();
  Complex sum = 0;
  for (int s = 0; s < surface.side_count(); ++s) {
    const int v = surface.from(Side(s));
    const int u = surface.to(Side(s));
    const Complex flow = forms.weight()[s] * (f[v] - f[u]);
    if (loop_of[v] == loop) sum += flow;
    if (loop_of[u] == loop) sum -= flow;
  }
  return sum;
}

/// On its own loop log(z - center) differs from that of the ring map by little but a constant. The harmonic
/// function with this constant free has no flux there, which tells its sheet; of a slit so short that its
/// angles are rounding errors, it tells the constant too.
Branch branch(const OneForms& forms, const SlitMap& map, const CircularMap& circular, std::size_t k,
              const std::vector<int>& loop_of) {
  constexpr double short_slit = 1e-3;
  const Circle& circle = circular.domain.circles[k];
  const int loop = circular.loop[k];
  const SlitMap own = slit_map(forms, map.outer, loop);
  const std::vector<Complex>& z = circular.position;
  const surface::Surface& surface = forms.mesh().surface;
  const int start = surface.vertex(forms.loops()[map.outer].sides.front());
  const std::vector<double> turn = continued_turn(surface, own, z, circle.center, start);
  std::vector<Complex> f(z.size());
  for (std::size_t v = 0; v < z.size(); ++v)
    if (loop_of[v] >= 0 && loop_of[v] != loop)
      f[v] = Complex(std::log(std::abs(z[v] - circle.center)) - own.log_radius[v], turn[v]);
  const Slit& slit = map.slits[k - 2];
  const bool is_short = slit.end - slit.start < short_slit;
  double first = 0;
  double before = 0;
  for (const surface::SideEnd e : forms.loops()[loop].sides) {
    const int v = surface.vertex(e);
    const double raw = std::arg(z[v] - circle.center) - own.angle[v];
    if (e == forms.loops()[loop].sides.front()) before = first = raw;
    before += std::remainder(raw - before, full_turn);
    if (!is_short) f[v] = Complex(0, before - first);
  }
  f = forms.extended(f);
  Complex constant = -flux_through(forms, loop_of, loop, f) / forms.flux(loop, loop);
  constant.real(std::log(circle.radius) + own.modulus);
  if (!is_short) constant.imag(constant.imag() + std::remainder(first - constant.imag(), full_turn));
  Branch result{circle.center, {}};
  for (std::size_t v = 0; v < z.size(); ++v)
    result.log.push_back(Complex(own.log_radius[v], own.angle[v]) + f[v] +
                         constant * forms.potential(loop)[v]);
  return result;
}

} // namespace

std::vector<Complex> extended_in_logs(const OneForms& forms, const SlitMap& map, const std::vector<int>& loop,
                                      const LogCurves& from, const LogCurves& onto) {
  const std::size_t vertices = forms.mesh().points.size();
  std::vector<Complex> f(vertices);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const CarriedCurve curve(from[k], onto[k], k < 2);
    const std::vector<double> t = parameters(forms, map, loop[k]);
    for (std::size_t j = 0; j < t.size(); ++j) {
      const int v = forms.mesh().surface.vertex(forms.loops()[loop[k]].sides[j]);
      const double near = curve.added(t[j]).imag();
      f[v] = curve.at(t[j]) - log_of_ring(map, v);
      f[v].imag(near + std::remainder(f[v].imag() - near, full_turn));
    }
  }
  if (loop.size() > 2) f = forms.extended(f); // with two loops f is 0
  for (std::size_t v = 0; v < vertices; ++v) f[v] = std::exp(f[v] + log_of_ring(map, static_cast<int>(v)));
  return f;
}

void refine_branches(const OneForms& forms, const SlitMap& map, CircularMap& circular) {
  const std::vector<std::size_t> small = small_circles(circular.domain.circles);
  if (small.empty()) return;
  const std::vector<int> loop_of = surface::loops_of_vertices(forms.loops(), forms.mesh().surface);
  std::vector<Branch> branches(1);
  for (const Complex z : circular.position) branches[0].log.push_back(std::log(z));
  for (const std::size_t k : small) branches.push_back(branch(forms, map, circular, k, loop_of));
  std::vector<char> is_small(forms.loops().size(), 0);
  for (const std::size_t k : small) is_small[circular.loop[k]] = 1;
  for (std::size_t v = 0; v < circular.position.size(); ++v) {
    if (loop_of[v] >= 0 && is_small[loop_of[v]] == 0) continue;
    const auto nearest =
        std::min_element(branches.begin(), branches.end(),
                         [&](const auto& a, const auto& b) { return a.log[v].real() < b.log[v].real(); });
    Complex sum = 0;
    double weights = 0;
    for (const Branch& b : branches) {
      const double weight = std::exp(2 * (nearest->log[v].real() - b.log[v].real()));
      sum += weight * (b.center - nearest->center + std::exp(b.log[v]));
      weights += weight;
    }
    circular.position[v] = nearest->center + sum / weights;
  }
}

} // namespace tetrarch::slit
