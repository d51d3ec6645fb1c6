// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Colours that stay apart for most eyes.

#include "tetrarch/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tetrarch::scene {

/// Source: Okabe and Ito, "Color Universal Design" (2008), without black.
inline Color qualitative(int index) {
  constexpr std::array<Color, 7> colors{{{230, 159, 0},
                                         {86, 180, 233},
                                         {0, 158, 115},
                                         {240, 228, 66},
                                         {0, 114, 178},
                                         {213, 94, 0},
                                         {204, 121, 167}}};
  const int n = static_cast<int>(colors.size());
  return colors[static_cast<std::size_t>(((index % n) + n) % n)];
}

inline Color mixed(Color a, Color b, double share_of_b) {
  const auto mix = [share_of_b](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround(x + share_of_b * (y - x)));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), a.alpha};
}

/// From warm (0) over green to blue, a step for each letter; it never ends, but steps become small.
inline Color by_word_length(int length) {
  constexpr Color warm{230, 120, 40};
  constexpr Color middle{90, 175, 120};
  constexpr Color cool{45, 75, 150};
  const double x = 1 - std::pow(0.72, length);
  return x < 0.5 ? mixed(warm, middle, 2 * x) : mixed(middle, cool, 2 * x - 1);
}

} // namespace tetrarch::scene
