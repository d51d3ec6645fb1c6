// SPDX-License-Identifier: GPL-2.0-or-later
// Orb's files: what was read survives writing and reading as JSON.
#include "as_json.hpp"
#include "tetrarch/format/orb.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tetrarch::fuzz::survives_as_json(data, size, tetrarch::format::read_orb);
}
