// SPDX-License-Identifier: GPL-2.0-or-later
// Isomorphism signatures, through the door by which files come in.
#include "fuzz.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  try {
    const format::Document document = format::read_any(fuzz::as_text(data, size), "fuzz.sig");
    const std::string text = signature(document.triangulation);
    const Triangulation back = from_signature(text);
    fuzz::require(back.size() == document.triangulation.size(), "the size survives", text);
    fuzz::require(signature(back) == text, "a signature is a fixed point", text);
  } catch (const InputError& error) {
    fuzz::require_one_line(error);
  }
  return 0;
}
