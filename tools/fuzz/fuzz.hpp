// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the fuzz targets share: bytes as text, and a law that aborts when it is broken.

#include "tetrarch/core/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace tetrarch::fuzz {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline void require(bool law, const char* name, std::string_view a = {}, std::string_view b = {}) {
  if (law) return;
  std::cerr << "broken law: " << name << "\n--- " << a << "\n--- " << b << "\n";
  std::abort();
}

/// Every complaint is one line of bearable length.
inline void require_one_line(const InputError& error) {
  const std::string_view what = error.what();
  require(what.find('\n') == std::string_view::npos && what.size() < 400, "an error is one short line", what);
}

} // namespace tetrarch::fuzz
