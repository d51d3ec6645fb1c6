// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quality.hpp"

#include "full_turn.hpp"
#include "tetrarch/mesh/laplacian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace tetrarch::slit {
namespace {

using mesh::Side;
using Complex = std::complex<double>;
using FlatTriangle = std::array<Complex, 3>;

/// A triangle of the mesh laid into the plane: corner 0 at 0, corner 1 on the positive real axis.
FlatTriangle laid_flat(const mesh::TriangleMesh& mesh, int t) {
  const auto& corners = mesh.surface.corners(t);
  const auto edge = [&](int c) {
    std::array<double, 3> e{};
    for (int k = 0; k < 3; ++k) e[k] = mesh.points[corners[c]][k] - mesh.points[corners[0]][k];
    return e;
  };
  const auto a = edge(1);
  const auto b = edge(2);
  const double length = std::hypot(a[0], a[1], a[2]);
  const double twice_area =
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return {0.0, length, {(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / length, twice_area / length}};
}

double angle_at(const FlatTriangle& p, int c) {
  const Complex a = p[(c + 1) % 3] - p[c];
  const Complex b = p[(c + 2) % 3] - p[c];
  return std::abs(std::arg(b * std::conj(a)));
}

/// The ratio of the axes of the linear map from p to q; 0 where it does not keep the orientation.
double ratio_of_axes(const FlatTriangle& p, const FlatTriangle& q) {
  // q = forward z + backward conj(z), up to a common factor and the translation.
  const Complex z1 = p[1] - p[0];
  const Complex z2 = p[2] - p[0];
  const Complex w1 = q[1] - q[0];
  const Complex w2 = q[2] - q[0];
  const double forward = std::abs(w1 * std::conj(z2) - w2 * std::conj(z1));
  const double backward = std::abs(z1 * w2 - z2 * w1);
  return forward > backward ? (forward + backward) / (forward - backward) : 0.0;
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
    const FlatTriangle p = laid_flat(mesh, t);
    const FlatTriangle q = image(t);
    const double ratio = ratio_of_axes(p, q);
    if (ratio == 0) {
      result.flipped.push_back(t);
      continue;
    }
    result.quasi_conformal.back() = ratio;
    result.max_quasi_conformal = std::max(result.max_quasi_conformal, ratio);
    const double twice_area = p[1].real() * p[2].imag();
    const double twice_image = (std::conj(q[1] - q[0]) * (q[2] - q[0])).imag();
    result.log_factor.back() = std::log(twice_image / twice_area) / 2;
    result.mean_quasi_conformal += ratio * twice_area;
    area += twice_area;
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
    return FlatTriangle{0.0, value(Side(t, 2)), -value(Side(t, 1))};
  });
}

Distortion distortion_on_ring(const OneForms& forms, const SlitMap& map) {
  return distortion(forms.mesh(), ears(forms), [&](int t) {
    const auto& v = forms.mesh().surface.corners(t);
    return FlatTriangle{map.concentric(v[0]), map.concentric(v[1]), map.concentric(v[2])};
  });
}

Distortion distortion_in_plane(const mesh::TriangleMesh& mesh, const std::vector<Complex>& position) {
  const std::vector<char> none(static_cast<std::size_t>(mesh.surface.triangle_count()), 0);
  return distortion(mesh, none, [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return FlatTriangle{position[v[0]], position[v[1]], position[v[2]]};
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
