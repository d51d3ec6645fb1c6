// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_curve.hpp"

#include "full_turn.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::slit {
namespace {

/// An end of a slit: the top of the parabola through the vertex next to it and the two beside that one.
struct End {
  double angle = 0;
  bool is_after = false; ///< that vertex, on the way round
};

/// Next to vertex j, which has the greatest sign * angle.
End end_beside(const std::vector<double>& psi, const std::vector<double>& angle, std::size_t j, double sign) {
  const std::size_t n = angle.size();
  const std::size_t before = (j + n - 1) % n;
  const std::size_t after = (j + 1) % n;
  const double left = wrapped(psi[j] - psi[before]);
  const double right = wrapped(psi[after] - psi[j]);
  const double down_left = sign * (angle[before] - angle[j]);
  const double down_right = sign * (angle[after] - angle[j]);
  const double slope = (down_right / right * left - down_left / left * right) / (left + right);
  const double bend = (down_right / right + down_left / left) / (left + right);
  if (!(bend < 0)) return {angle[j], false};
  // No farther than the lower neighbour is on the other side: vertices lie too unevenly for more to be known.
  const double beyond = std::min(-slope * slope / (4 * bend), std::max(-down_left, -down_right));
  return {angle[j] + sign * beyond, slope > 0};
}

} // namespace

SlitCurve slit_curve(const OneForms& forms, const OneForm& angle, int loop) {
  const std::vector<double> flow = forms.conjugate_along(loop);
  std::vector<double> psi; // rises along the loop
  std::vector<double> at{0.0};
  for (const surface::SideEnd e : forms.loops()[loop].sides) {
    psi.push_back(full_turn * flow[psi.size()] / flow.back());
    at.push_back(at.back() + angle[e.side.value]);
  }
  at.pop_back();
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  SlitCurve result;
  const End start = end_beside(psi, at, static_cast<std::size_t>(low - at.begin()), -1);
  const End end = end_beside(psi, at, static_cast<std::size_t>(high - at.begin()), 1);
  result.lowest = start.angle;
  result.highest = end.angle;

  // From the lowest to the highest point the surface, to the left, is nearer the origin.
  const double middle = (result.lowest + result.highest) / 2;
  const double half = (result.highest - result.lowest) / 2;
  const auto n = static_cast<std::ptrdiff_t>(at.size());
  const std::ptrdiff_t to_highest = (high - low + n) % n;
  for (std::ptrdiff_t j = 0; j < n; ++j) {
    const std::ptrdiff_t from_lowest = (j - (low - at.begin()) + n) % n;
    const bool is_inner_bank = from_lowest == 0            ? !start.is_after
                               : from_lowest == to_highest ? end.is_after
                                                           : from_lowest < to_highest;
    const double t = std::acos(std::clamp((at[static_cast<std::size_t>(j)] - middle) / half, -1.0, 1.0));
    result.parameter.push_back(is_inner_bank || t == 0 ? t : full_turn - t);
  }
  return result;
}

} // namespace tetrarch::slit
