// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace tetrarch::slit {

constexpr double full_turn = 2 * std::numbers::pi;

/// Into [0, 2 pi): rounding may bring a tiny negative angle to 2 pi itself.
inline double wrapped(double angle) {
  const double rest = angle - full_turn * std::floor(angle / full_turn);
  return rest < full_turn ? rest : 0.0;
}

} // namespace tetrarch::slit
