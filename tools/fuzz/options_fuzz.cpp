// SPDX-License-Identifier: GPL-2.0-or-later
// A command line, a word a line: it is a job, a text such as a help page, or one line of error. Nothing is
// run.
#include "../tetrarch/command.hpp"
#include "../tetrarch/parse.hpp"
#include "fuzz.hpp"

#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetrarch;
  const std::string_view text = fuzz::as_text(data, size);
  if (text.find('/') != std::string_view::npos) return 0; // outputs are tried: none outside of this folder
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  try {
    const program::Parsed parsed =
        program::parse(words, program::commands(), "tetrarch", program::usual_options());
    fuzz::require(parsed.job.has_value() != !parsed.text.empty(), "a job or a text");
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos, "an error is one line",
                  error.what());
  }
  return 0;
}
