// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using Complex = std::complex<double>;

double angle_at(const numeric::FlatTriangle& p, int c) {
  const Complex a = p[(c + 1) % 3] - p[c];
  const Complex b = p[(c + 2) % 3] - p[c];
  return std::abs(std::arg(b * std::conj(a)));
}

/// The greatest extent along an axis.
double extent(const std::vector<std::array<double, 3>>& points) {
  double result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double least = INFINITY;
    double most = -INFINITY;
    for (const auto& p : points) {
      least = std::min(least, p[axis]);
      most = std::max(most, p[axis]);
    }
    result = std::max(result, most - least);
  }
  return result > 0 ? result : 1;
}

/// The same shape with its longer sides about 1 long, and how long they were: squares of e^-300
/// underflow.
std::pair<numeric::FlatTriangle, double> of_size_one(numeric::FlatTriangle q) {
  double size = 0;
  for (const std::size_t c : {1, 2})
    size = std::max({size, std::abs((q[c] - q[0]).real()), std::abs((q[c] - q[0]).imag())});
  return {{0.0, (q[1] - q[0]) / size, (q[2] - q[0]) / size}, size};
}

/// From the log factors of the triangles that count, and their areas.
void measure_areas(Distortion& d, const std::vector<double>& area) {
  double greatest = -INFINITY;
  for (std::size_t t = 0; t < area.size(); ++t)
    if (area[t] > 0) greatest = std::max(greatest, d.log_factor[t]);
  double whole = 0;
  double image = 0; // divided by the square of the greatest factor, as squares of e^-300 underflow
  for (std::size_t t = 0; t < area.size(); ++t)
    if (area[t] > 0) {
      whole += area[t];
      image += area[t] * std::exp(2 * (d.log_factor[t] - greatest));
    }
  const double of_whole = std::log(image / whole) + 2 * greatest;
  for (std::size_t t = 0; t < area.size(); ++t)
    if (area[t] > 0) {
      const double error = std::abs(2 * d.log_factor[t] - of_whole);
      d.mean_area_error += error * area[t] / whole;
      d.max_area_error = numeric::maximum(d.max_area_error, error);
    }
}

/// Of the triangles that are not `skipped`.
template <class Image>
Distortion distortion(const surface::TriangleMesh& mesh, const std::vector<char>& skipped,
                      const Image& image) {
  Distortion result;
  std::vector<double> shares(static_cast<std::size_t>(mesh.surface.triangle_count()), 0.0);
  double area = 0;
  const double unit = extent(mesh.points);
  int corners = 0;
  for (int t = 0; t < mesh.surface.triangle_count(); ++t) {
    result.quasi_conformal.push_back(0);
    result.log_factor.push_back(0);
    if (skipped[t]) {
      ++result.ears;
      continue;
    }
    const auto [p, size] = of_size_one(numeric::laid_flat(mesh.points, mesh.surface.corners(t)));
    const auto [q, image_size] = of_size_one(image(t));
    const double ratio = numeric::ratio_of_axes(p, q);
    if (!(ratio > 0)) {
      result.flipped.push_back(t);
      continue;
    }
    result.quasi_conformal.back() = ratio;
    result.max_quasi_conformal = numeric::maximum(result.max_quasi_conformal, ratio);
    result.log_factor.back() =
        std::log(numeric::twice_area(q) / numeric::twice_area(p)) / 2 + std::log(image_size) - std::log(size);
    const double share = numeric::twice_area(p) * (size / unit) * (size / unit);
    result.mean_quasi_conformal += ratio * share;
    area += share;
    shares[t] = share;
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(angle_at(p, c) - angle_at(q, c));
      result.mean_angle_error += error;
      result.max_angle_error = numeric::maximum(result.max_angle_error, error);
    }
    corners += 3;
  }
  if (corners == 0) return result;
  result.mean_quasi_conformal /= area;
  result.mean_angle_error /= corners;
  measure_areas(result, shares);
  return result;
}

/// Those of all loops but one.
std::vector<char> ears_of(const surface::Surface& surface, const std::vector<int>& loop, int but) {
  std::vector<char> result;
  for (const auto& v : surface.triangles())
    result.push_back(static_cast<char>(loop[v[0]] >= 0 && loop[v[0]] != but && loop[v[0]] == loop[v[1]] &&
                                       loop[v[0]] == loop[v[2]]));
  return result;
}

} // namespace

std::vector<char> ears(const OneForms& forms) {
  return ears_of(forms.mesh().surface, surface::loops_of_vertices(forms.loops(), forms.mesh().surface), -1);
}

std::vector<char> ears_in_disk(const surface::TriangleMesh& mesh, const CircularMap& map) {
  const auto loops = surface::boundary_loops(mesh);
  return ears_of(mesh.surface, surface::loops_of_vertices(loops, mesh.surface), map.loop.at(0));
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

namespace {

Distortion distortion_in_plane(const surface::TriangleMesh& mesh, const std::vector<char>& skipped,
                               const std::vector<Complex>& position) {
  return distortion(mesh, skipped, [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return numeric::FlatTriangle{position[v[0]], position[v[1]], position[v[2]]};
  });
}

} // namespace

Distortion distortion_in_plane(const surface::TriangleMesh& mesh, const std::vector<Complex>& position) {
  return distortion_in_plane(mesh, std::vector<char>(static_cast<std::size_t>(mesh.surface.triangle_count())),
                             position);
}

Distortion distortion_in_disk(const surface::TriangleMesh& mesh, const CircularMap& map) {
  return distortion_in_plane(mesh, ears_in_disk(mesh, map), map.position);
}

Residuals residuals(const OneForms& forms, const SlitMap& map) {
  const surface::Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  const std::vector<double> flux = surface::fluxes(forms.solved_on(), forms.weight(), map.log_radius);
  std::vector<double> through(static_cast<std::size_t>(forms.loop_count()), 0.0);
  Residuals result;
  for (int v = 0; v < surface.vertex_count(); ++v)
    if (loop[v] < 0)
      result.harmonic = numeric::maximum(result.harmonic, std::abs(flux[v]));
    else
      through[loop[v]] += flux[v];
  for (int k = 0; k < forms.loop_count(); ++k) {
    const double wanted = k == map.outer ? full_turn : k == map.inner ? -full_turn : 0.0;
    const double found = period(map.form.imaginary, forms.loops()[k]);
    result.period = numeric::maximum(result.period, std::abs(found - wanted));
    result.flux = numeric::maximum(result.flux, std::abs(through[k] - wanted));
    const auto radius = [&](surface::SideEnd e) { return std::abs(map.concentric(surface.vertex(e))); };
    const auto& sides = forms.loops()[k].sides;
    for (const surface::SideEnd e : sides)
      result.radius = numeric::maximum(result.radius, std::abs(radius(e) - radius(sides.front())));
  }
  return result;
}

} // namespace tetrarch::slit
