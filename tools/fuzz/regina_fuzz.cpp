// SPDX-License-Identifier: GPL-2.0-or-later
// Regina's files, plain and compressed: what was read survives writing and reading as JSON.
#include "as_json.hpp"
#include "tetrarch/format/regina.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tetrarch::fuzz::survives_as_json(data, size, tetrarch::format::read_regina);
}
