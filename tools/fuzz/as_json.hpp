// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// For formats that are only read: what was read survives writing and reading as JSON.

#include "fuzz.hpp"
#include "tetrarch/format/json.hpp"

namespace tetrarch::fuzz {

template <class Reader>
int survives_as_json(const std::uint8_t* data, std::size_t size, Reader read) {
  try {
    const format::Document document = read(as_text(data, size), "fuzz");
    const std::string text = format::write_json(document);
    require(format::read_json(text, "written").triangulation == document.triangulation,
            "read(write(document)) == document", text);
  } catch (const InputError& error) {
    require_one_line(error);
  }
  return 0;
}

} // namespace tetrarch::fuzz
