// SPDX-License-Identifier: GPL-2.0-or-later
// The SnapPea reader: gluings and name survive writing and reading.
#include "fuzz.hpp"
#include "tetrarch/format/snappea.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  try {
    const format::Document document = format::read_snappea(fuzz::as_text(data, size), "fuzz");
    const std::string text = format::write_snappea(document).text;
    const format::Document back = format::read_snappea(text, "written");
    fuzz::require(back.triangulation == document.triangulation, "the gluings survive", text);
    fuzz::require(back.name == document.name, "the name survives", document.name, back.name);
    fuzz::require(format::write_snappea(back).text == text, "write(read(text)) == text", text);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
