// SPDX-License-Identifier: GPL-2.0-or-later
// Orb's files: what was read survives writing and reading as JSON.
#include "fuzz.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/orb.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  try {
    const format::Document document = format::read_orb(fuzz::as_text(data, size), "fuzz");
    const std::string text = format::write_json(document);
    fuzz::require(format::read_json(text, "written").triangulation == document.triangulation,
                  "read(write(document)) == document", text);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
