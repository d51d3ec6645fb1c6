// SPDX-License-Identifier: GPL-2.0-or-later
// The JSON reader: whatever it accepts comes out canonical, and canonical text is a fixed point.
#include "fuzz.hpp"
#include "tetrarch/format/json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  try {
    const format::Document document = format::read_json(fuzz::as_text(data, size), "fuzz");
    const std::string text = format::write_json(document);
    const format::Document back = format::read_json(text, "written");
    fuzz::require(back.triangulation == document.triangulation, "the gluings survive", text);
    fuzz::require(back.name == document.name, "the name survives", document.name, back.name);
    const std::string again = format::write_json(back);
    fuzz::require(again == text, "write(read(text)) == text", text, again);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
