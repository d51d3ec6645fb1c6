// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/circular_map.hpp"

#include "full_turn.hpp"
#include "log_extension.hpp"
#include "tetrarch/core/error.hpp"

#include <cmath>
#include <string>

namespace tetrarch::slit {
namespace {

/// Angles are known to about 1e-15, so of a slit this short the last digits only.
constexpr double shortest_slit = 1e-12;

[[noreturn]] void refuse_surface(const std::string& fault, const std::string& way_out) {
  throw InputError(fault + "; the surface is too long and thin for this domain" + way_out);
}

std::vector<int> samples_of(const LogCurves& curves) {
  std::vector<int> result;
  for (const LogCurve& curve : curves) result.push_back(static_cast<int>(curve.size()));
  return result;
}

/// Samples are off their circles by as much as they do not resolve, and vertices between them with them.
void put_on_circles(const OneForms& forms, CircularMap& map) {
  for (std::size_t k = 0; k < map.loop.size(); ++k)
    for (const surface::SideEnd e : forms.loops()[map.loop[k]].sides) {
      std::complex<double>& z = map.position[forms.mesh().surface.vertex(e)];
      const Circle& circle = map.domain.circles[k];
      const std::complex<double> arm = z - circle.center;
      z = circle.center + arm / std::abs(arm) * circle.radius;
    }
}

} // namespace

SlitRing slit_ring(const SlitMap& map) {
  require_radii(map);
  SlitRing ring{std::exp(-map.modulus), {}};
  for (const Slit& s : map.slits) {
    const std::string slit = "the slit of loop " + std::to_string(s.loop);
    const std::string way_out = "; --outer " + std::to_string(map.outer) + " --inner " +
                                std::to_string(s.loop) + " makes that loop the inner circle";
    if (!(ring.inner < s.radius && s.radius < 1))
      refuse_surface(slit + " lies on a circle of the ring, up to rounding", way_out);
    if (!(s.end - s.start < full_turn)) refuse_surface(slit + " is a full circle, up to rounding", way_out);
    if (!(s.end - s.start > shortest_slit)) refuse_surface(slit + " is a point, up to rounding", way_out);
    ring.slits.push_back({s.radius, s.start, s.end});
  }
  return ring;
}

CircularMap circular_map(const OneForms& forms, const SlitMap& map, const CircularOptions& options,
                         const Progress& progress) {
  CircularMap result;
  result.loop = {map.outer, map.inner};
  for (const Slit& s : map.slits) result.loop.push_back(s.loop);
  const SlitRing ring = slit_ring(map);
  result.domain = circular_domain(ring, options, progress);
  const LogCurves from = opened_slits(ring, samples_of(result.domain.curves), 0);
  result.position = extended_in_logs(forms, map, result.loop, from, result.domain.curves);
  refine_branches(forms, map, result);
  if (result.domain.found) put_on_circles(forms, result);
  return result;
}

std::vector<std::complex<double>> opening_stage(const OneForms& forms, const SlitMap& map,
                                                const CircularMap& circular, std::size_t stage) {
  if (stage > map.slits.size()) throw PreconditionError("there is no such stage");
  const std::vector<int> samples = samples_of(circular.domain.curves);
  const SlitRing ring = slit_ring(map);
  return extended_in_logs(forms, map, circular.loop, opened_slits(ring, samples, 0),
                          opened_slits(ring, samples, stage));
}

} // namespace tetrarch::slit
