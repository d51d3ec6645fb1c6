// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One writer a format, for scenes that are sound, and what the binary ones share.

#include "tetrarch/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace tetrarch::scene {

std::string write_ply(const Scene& scene);
std::string write_obj(const Scene& scene);
std::string write_glb(const Scene& scene);
std::string write_vtu(const Scene& scene);

/// The bytes of `value`, the least significant first.
template <class T>
void append_little(std::string& out, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  out.append(raw.data(), raw.size());
}

} // namespace tetrarch::scene
