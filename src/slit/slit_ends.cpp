// SPDX-License-Identifier: GPL-2.0-or-later
#include "full_turn.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/slit/balance.hpp"
#include "tetrarch/unfold/relax.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using surface::SideEnd;
using surface::Surface;
using Complex = std::complex<double>;
using numeric::FlatTriangle;
using unfold::FlatFreedom;
using Kind = FlatFreedom::Kind;

/// Triangles so many steps around are moved.
constexpr int relaxed_rings = 3;
/// Ratio of axes from which on it is worth it.
constexpr double much = 10;

SideEnd end_at(int triangle, int corner) {
  return {Side(triangle, (corner + 2) % 3), true};
}

/// The triangles at most `relaxed_rings` steps from a vertex.
std::vector<int> around(const Surface& surface, SideEnd at) {
  std::map<int, bool> triangles;
  std::map<int, bool> met{{surface.vertex(at), true}};
  std::vector<SideEnd> front{at};
  for (int ring = 0; ring < relaxed_rings; ++ring) {
    std::vector<SideEnd> next;
    for (const SideEnd center : front)
      for (const SideEnd e : surface::fan(surface, center)) {
        const int t = e.side.triangle();
        if (!triangles.emplace(t, true).second) continue;
        for (int c = 0; c < 3; ++c)
          if (met.emplace(surface.corners(t)[c], true).second) next.push_back(end_at(t, c));
      }
    front = std::move(next);
  }
  std::vector<int> result;
  result.reserve(triangles.size());
  for (const auto& [t, is_there] : triangles) result.push_back(t);
  return result;
}

/// What a domain has to say: where triangles lie, where vertices may go, and how they are moved.
struct Domain {
  std::function<FlatTriangle(int)> image;
  std::function<FlatFreedom(int)> freedom; ///< of a vertex on a loop
  std::function<Complex(int, Complex)> log_shift;
};

double greatest_ratio(const OneForms& forms, const std::vector<int>& triangles, const Domain& domain) {
  double result = 0;
  for (const int t : triangles)
    result = numeric::maximum(
        result,
        numeric::ratio_of_axes(numeric::laid_flat(forms.mesh().points, forms.mesh().surface.corners(t)),
                               domain.image(t)));
  return result;
}

/// A few triangles with vertices numbered anew.
class Patch {
public:
  Patch(const OneForms& forms, const std::vector<int>& loop, const std::vector<int>& triangles, int end,
        const Domain& domain)
      : surface_(forms.mesh().surface) {
    std::map<int, int> number;
    std::vector<double> log_factors;
    std::vector<int> left_out;
    for (const int t : triangles) {
      const auto& corner = surface_.corners(t);
      const FlatTriangle p = numeric::laid_flat(forms.mesh().points, corner);
      const FlatTriangle q = domain.image(t);
      unfold::FlatElement e;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [found, is_new] = number.try_emplace(corner[c], static_cast<int>(vertex_.size()));
        if (is_new) {
          vertex_.push_back(corner[c]);
          at_.push_back(end_at(t, static_cast<int>(c)));
        }
        e.corner[c] = found->second;
      }
      if (!(numeric::ratio_of_axes(p, q) > 0)) {
        left_out.insert(left_out.end(), e.corner.begin(), e.corner.end());
        continue;
      }
      e.wanted = {p[1] - p[0], p[2] - p[0]};
      e.now = {q[1] - q[0], q[2] - q[0]};
      elements_.push_back(e);
      log_factors.push_back(std::log(numeric::twice_area(q) / numeric::twice_area(p)) / 2);
    }
    if (elements_.empty()) return;
    std::nth_element(log_factors.begin(),
                     log_factors.begin() + static_cast<std::ptrdiff_t>(log_factors.size() / 2),
                     log_factors.end());
    const double scale = std::exp(log_factors[log_factors.size() / 2]);
    for (unfold::FlatElement& e : elements_)
      for (Complex& edge : e.wanted) edge *= scale;
    for (std::size_t k = 0; k < vertex_.size(); ++k) {
      const int v = vertex_[k];
      const std::vector<SideEnd> own = fan(k);
      const bool is_inside = std::all_of(own.begin(), own.end(), [&](SideEnd e) {
        return std::binary_search(triangles.begin(), triangles.end(), e.side.triangle());
      });
      FlatFreedom f = loop[v] < 0 ? FlatFreedom{} : domain.freedom(v);
      if (!is_inside || v == end) f.kind = Kind::fixed;
      freedom_.push_back(f);
    }
    for (const int k : left_out) freedom_[static_cast<std::size_t>(k)].kind = Kind::fixed;
  }

  /// First towards sizes that are all alike, then towards the sizes reached: angles alone count in the end.
  std::vector<std::pair<int, Complex>> moves() {
    std::vector<Complex> shift(vertex_.size(), 0.0);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && !elements_.empty(); ++round) {
      if (round > 0)
        for (unfold::FlatElement& e : elements_) {
          const double grown =
              std::sqrt(numeric::cross(e.now[0], e.now[1]) / numeric::cross(e.wanted[0], e.wanted[1]));
          for (Complex& edge : e.wanted) edge *= grown;
        }
      // By rounding, where sizes differ by as much as doubles tell.
      if (!std::all_of(elements_.begin(), elements_.end(), unfold::is_counterclockwise)) break;
      const unfold::Relaxed done = unfold::relaxed(elements_, freedom_);
      for (unfold::FlatElement& e : elements_)
        for (const std::size_t c : {0, 1}) e.now[c] += done.shift[e.corner[c + 1]] - done.shift[e.corner[0]];
      for (std::size_t k = 0; k < shift.size(); ++k) {
        shift[k] += done.shift[k];
        if (freedom_[k].kind == Kind::circle) freedom_[k].arm += done.shift[k];
      }
    }
    std::vector<std::pair<int, Complex>> result;
    for (std::size_t k = 0; k < shift.size(); ++k)
      if (shift[k] != 0.0) result.emplace_back(static_cast<int>(k), shift[k]);
    return result;
  }

  int vertex(int k) const { return vertex_[static_cast<std::size_t>(k)]; }
  std::vector<SideEnd> fan(std::size_t k) const { return surface::fan(surface_, at_[k]); }

private:
  const Surface& surface_;
  std::vector<int> vertex_;
  std::vector<SideEnd> at_;
  std::vector<unfold::FlatElement> elements_;
  std::vector<FlatFreedom> freedom_;
};

/// Moves one vertex of the map by a shift of w.
void shift(SlitMap& map, int v, const std::vector<SideEnd>& fan, Complex by) {
  map.log_radius[v] += by.real();
  map.angle[v] = wrapped(map.angle[v] + by.imag());
  for (const SideEnd e : fan) {
    const Side opposite(e.side.triangle(), e.corner());
    map.form.real[opposite.next().value] += by.real(); // ends at v
    map.form.imaginary[opposite.next().value] += by.imag();
    map.form.real[opposite.previous().value] -= by.real(); // starts there
    map.form.imaginary[opposite.previous().value] -= by.imag();
  }
}

void soften(const OneForms& forms, SlitMap& map, const std::vector<int>& loop, SideEnd end,
            const Domain& domain, Softened& result) {
  const Surface& surface = forms.mesh().surface;
  const std::vector<int> triangles = around(surface, end);
  const double before = greatest_ratio(forms, triangles, domain);
  if (!(before > much)) return;
  Patch patch(forms, loop, triangles, surface.vertex(end), domain);
  std::vector<std::pair<int, Complex>> moves;
  for (const auto& [k, step] : patch.moves()) {
    Complex by = domain.log_shift(patch.vertex(k), step);
    if (loop[patch.vertex(k)] >= 0) by.real(0);
    moves.emplace_back(k, by);
  }
  // To be put back to the last digit where it does not help.
  std::map<int, Complex> sides;
  std::map<int, Complex> vertices;
  for (const int t : triangles)
    for (const Side side : surface::sides_of(t)) {
      const int v = surface.from(side);
      sides[side.value] = {map.form.real[side.value], map.form.imaginary[side.value]};
      vertices[v] = {map.log_radius[v], map.angle[v]};
    }
  for (const auto& [k, by] : moves) shift(map, patch.vertex(k), patch.fan(static_cast<std::size_t>(k)), by);
  const double after = greatest_ratio(forms, triangles, domain);
  if (!(after < before)) {
    for (const auto& [side, was] : sides) {
      map.form.real[side] = was.real();
      map.form.imaginary[side] = was.imag();
    }
    for (const auto& [v, was] : vertices) {
      map.log_radius[v] = was.real();
      map.angle[v] = was.imag();
    }
    return;
  }
  result.moved += static_cast<int>(moves.size());
  result.before = numeric::maximum(result.before, before);
  result.after = numeric::maximum(result.after, after);
}

Softened soften_all(const OneForms& forms, SlitMap& map, const std::vector<int>& loop, const Domain& domain) {
  Softened result;
  for (const Slit& slit : map.slits) {
    const auto& sides = forms.loops()[slit.loop].sides;
    std::vector<double> at{0.0};
    for (const SideEnd e : sides) at.push_back(at.back() + map.form.imaginary[e.side.value]);
    at.pop_back();
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    for (const auto where : {low - at.begin(), high - at.begin()})
      soften(forms, map, loop, sides[static_cast<std::size_t>(where)], domain, result);
  }
  return result;
}

} // namespace

Softened soften_ends_on_cylinder(const OneForms& forms, SlitMap& map) {
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), forms.mesh().surface);
  Domain domain;
  domain.image = [&](int t) {
    const auto value = [&](Side s) { return Complex(map.form.real[s.value], map.form.imaginary[s.value]); };
    return FlatTriangle{0.0, value(Side(t, 2)), -value(Side(t, 1))};
  };
  domain.freedom = [](int) { return FlatFreedom{Kind::line, Complex(0, 1)}; };
  domain.log_shift = [](int, Complex step) { return step; };
  return soften_all(forms, map, loop, domain);
}

Softened soften_ends_on_ring(const OneForms& forms, SlitMap& map) {
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), forms.mesh().surface);
  Domain domain;
  domain.image = [&](int t) {
    const auto& v = forms.mesh().surface.corners(t);
    return FlatTriangle{map.concentric(v[0]), map.concentric(v[1]), map.concentric(v[2])};
  };
  domain.freedom = [&](int v) { return FlatFreedom{Kind::circle, map.concentric(v)}; };
  domain.log_shift = [&](int v, Complex step) { return std::log(1.0 + step / map.concentric(v)); };
  return soften_all(forms, map, loop, domain);
}

} // namespace tetrarch::slit
