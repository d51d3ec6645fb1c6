// SPDX-License-Identifier: GPL-2.0-or-later
// Orb's files: what was read survives writing and reading as JSON; the drawing is read or refused.
#include "as_json.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/orb.hpp"

#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    (void)tetrarch::format::read_orb_drawing({reinterpret_cast<const char*>(data), size}, "f");
  } catch (const tetrarch::InputError&) {
  }
  return tetrarch::fuzz::survives_as_json(data, size, tetrarch::format::read_orb);
}
