// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Domains with known slit maps, and how far a computed map is from the known one.

#include "support/planar_domains.hpp"
#include "tetrarch/slit/quality.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

namespace tetrarch::slit {

using Complex = std::complex<double>;

constexpr double full_turn = 2 * std::numbers::pi;

/// A map of the unit disk to itself.
inline Complex moebius(Complex z) {
  return (z + 0.4) / (1.0 + 0.4 * z);
}

/// A ring of modulus 1 with two slits of a quarter turn: at height 1/4 from sector 2, at 1/2 from sector 9.
inline support::CylinderGrid two_slits() {
  support::CylinderGrid grid;
  grid.sectors = 16;
  grid.cracks = {{1, 2, 4}, {2, 9, 4}};
  return grid;
}

inline int outer_loop(const OneForms& forms, const support::CrackedCylinder& domain) {
  return surface::loop_through(forms.loops(), forms.mesh().surface, domain.outer_vertex);
}
inline int inner_loop(const OneForms& forms, const support::CrackedCylinder& domain) {
  return surface::loop_through(forms.loops(), forms.mesh().surface, domain.inner_vertex);
}

/// The angle from a to b, in [-pi, pi].
inline double angle_between(double a, double b) {
  return std::remainder(b - a, full_turn);
}

/// Greatest errors of a map.
struct Errors {
  double modulus = 0;
  double bracket = 0;         ///< modulus_bound - modulus
  double height = 0;          ///< over all vertices
  double angle = 0;           ///< over all vertices, after the best rotation
  double slits = 0;           ///< of radii, starts and ends, less the rotation
  double quasi_conformal = 0; ///< mean excess over 1, on the cylinder
  double angles = 0;          ///< mean angle error, on the cylinder
  double wedges = 0;          ///< between the two routes to the conjugates, in L^2, of the slit form
  double holomorphic = 0;
};

/// Source: the domain's own `at`, if `exact` is the identity; its modulus is `height`.
inline Errors errors(
    const support::CrackedCylinder& domain, double height,
    const std::function<support::OnCylinder(support::OnCylinder)>& exact = [](support::OnCylinder p) {
      return p;
    }) {
  const OneForms forms(domain.mesh);
  const SlitMap map = slit_map(forms, outer_loop(forms, domain), inner_loop(forms, domain));
  Errors e;
  e.modulus = std::abs(map.modulus - height);
  e.bracket = map.modulus_bound - map.modulus;
  Complex rotation = 0;
  for (std::size_t v = 0; v < domain.at.size(); ++v)
    rotation += std::polar(1.0, map.angle[v] - exact(domain.at[v]).angle);
  const double turn = std::arg(rotation);
  const auto angle_error = [&](double found, double known) {
    return std::abs(angle_between(known + turn, found));
  };
  for (std::size_t v = 0; v < domain.at.size(); ++v) {
    const support::OnCylinder known = exact(domain.at[v]);
    e.height = std::max(e.height, std::abs(-map.log_radius[v] - known.height));
    e.angle = std::max(e.angle, angle_error(map.angle[v], known.angle));
  }
  for (const auto& [start, end] : domain.tips) {
    const int loop = surface::loop_through(forms.loops(), domain.mesh.surface, start);
    const auto slit =
        std::find_if(map.slits.begin(), map.slits.end(), [&](const Slit& s) { return s.loop == loop; });
    const support::OnCylinder first = exact(domain.at[start]);
    e.slits = std::max({e.slits, std::abs(slit->radius - std::exp(-first.height)),
                        angle_error(slit->start, first.angle),
                        angle_error(slit->end, exact(domain.at[end]).angle)});
  }
  const Distortion distortion = distortion_on_cylinder(forms, map);
  e.quasi_conformal = distortion.mean_quasi_conformal - 1;
  e.angles = distortion.mean_angle_error;
  const auto by_wedges = conjugates_by_wedges(forms);
  for (int k = 0; k < forms.loop_count(); ++k) {
    OneForm difference = combination(forms, by_wedges[k]);
    const OneForm by_periods = combination(forms, conjugate_by_periods(forms, k));
    for (std::size_t s = 0; s < difference.size(); ++s) difference[s] -= by_periods[s];
    e.wedges = std::max(e.wedges, std::sqrt(inner_product(forms.weight(), difference, difference)));
  }
  e.holomorphic = distance_from_holomorphic(forms, map.form);
  return e;
}

} // namespace tetrarch::slit
