// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quality.hpp"

#include "full_turn.hpp"
#include "tetrarch/mesh/laplacian.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace tetrarch::slit {
namespace {

using mesh::Side;
using Complex = std::complex<double>;

double angle_at(const numeric::FlatTriangle& p, int c) {
  const Complex a = p[(c + 1) % 3] - p[c];
  const Complex b = p[(c + 2) % 3] - p[c];
  return std::abs(std::arg(b * std::conj(a)));
}

/// Of the triangles that are not `skipped`.
template <class Image>
Distortion distortion(const mesh::TriangleMesh& mesh, const std::vector<char>& skipped, const Image& image) {
  Distortion result;
  double area = 0;
  int corners = 0;
  for (int t = 0; t < mesh.surface.triangle_count(); ++t) {
    result.quasi_conformal.push_back(0);
    result.log_factor.push_back(0);
    if (skipped[t]) {
      ++result.ears;
      continue;
    }
    const numeric::FlatTriangle p = numeric::laid_flat(mesh.points, mesh.surface.corners(t));
    const numeric::FlatTriangle q = image(t);
    const double ratio = numeric::ratio_of_axes(p, q);
    if (ratio == 0) {
      result.flipped.push_back(t);
      continue;
    }
    result.quasi_conformal.back() = ratio;
    result.max_quasi_conformal = std::max(result.max_quasi_conformal, ratio);
    result.log_factor.back() = std::log(numeric::twice_area(q) / numeric::twice_area(p)) / 2;
    result.mean_quasi_conformal += ratio * numeric::twice_area(p);
    area += numeric::twice_area(p);
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(angle_at(p, c) - angle_at(q, c));
      result.mean_angle_error += error;
      result.max_angle_error = std::max(result.max_angle_error, error);
    }
    corners += 3;
  }
  if (corners == 0) return result;
  result.mean_quasi_conformal /= area;
  result.mean_angle_error /= corners;
  return result;
}

} // namespace

std::vector<char> ears(const OneForms& forms) {
  const mesh::Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = mesh::loops_of_vertices(forms.loops(), surface);
  std::vector<char> result;
  for (const auto& v : surface.triangles())
    result.push_back(loop[v[0]] >= 0 && loop[v[0]] == loop[v[1]] && loop[v[0]] == loop[v[2]]);
  return result;
}

Distortion distortion_on_cylinder(const OneForms& forms, const SlitMap& map) {
  return distortion(forms.mesh(), ears(forms), [&](int t) {
    const auto value = [&](Side s) { return Complex(map.form.real[s.value], map.form.imaginary[s.value]); };
    return numeric::FlatTriangle{0.0, value(Side(t, 2)), -value(Side(t, 1))};
  });
}

Distortion distortion_on_ring(const OneForms& forms, const SlitMap& map) {
  return distortion(forms.mesh(), ears(forms), [&](int t) {
    const auto& v = forms.mesh().surface.corners(t);
    return numeric::FlatTriangle{map.concentric(v[0]), map.concentric(v[1]), map.concentric(v[2])};
  });
}

Distortion distortion_in_plane(const mesh::TriangleMesh& mesh, const std::vector<Complex>& position) {
  const std::vector<char> none(static_cast<std::size_t>(mesh.surface.triangle_count()), 0);
  return distortion(mesh, none, [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return numeric::FlatTriangle{position[v[0]], position[v[1]], position[v[2]]};
  });
}

Residuals residuals(const OneForms& forms, const SlitMap& map) {
  const mesh::Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = mesh::loops_of_vertices(forms.loops(), surface);
  const std::vector<double> flux = mesh::fluxes(forms.solved_on(), forms.weight(), map.log_radius);
  std::vector<double> through(static_cast<std::size_t>(forms.loop_count()), 0.0);
  Residuals result;
  for (int v = 0; v < surface.vertex_count(); ++v)
    if (loop[v] < 0)
      result.harmonic = std::max(result.harmonic, std::abs(flux[v]));
    else
      through[loop[v]] += flux[v];
  for (int k = 0; k < forms.loop_count(); ++k) {
    const double wanted = k == map.outer ? full_turn : k == map.inner ? -full_turn : 0.0;
    const double found = period(map.form.imaginary, forms.loops()[k]);
    result.period = std::max(result.period, std::abs(found - wanted));
    result.flux = std::max(result.flux, std::abs(through[k] - wanted));
    const auto radius = [&](mesh::SideEnd e) { return std::abs(map.concentric(surface.vertex(e))); };
    const auto& sides = forms.loops()[k].sides;
    for (const mesh::SideEnd e : sides)
      result.radius = std::max(result.radius, std::abs(radius(e) - radius(sides.front())));
  }
  return result;
}

} // namespace tetrarch::slit
