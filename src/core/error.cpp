// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch {
namespace {

std::string placed(const Place& place, const std::string& message) {
  std::string text = place.source;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  return text + message;
}

constexpr bool is_within(unsigned char c, unsigned low, unsigned high) {
  return c >= low && c <= high;
}

/// How many bytes the printable character at the start of `text` has: of well-formed UTF-8 (Unicode 15, table
/// 3-7), and no control character; 0 if there is none such.
std::size_t printable_length(std::string_view text) {
  const auto byte = [&text](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = byte(0);
  if (first < 0x80) return is_within(first, 0x20, 0x7e) ? 1 : 0;
  const std::size_t length = is_within(first, 0xc2, 0xdf)   ? 2
                             : is_within(first, 0xe0, 0xef) ? 3
                             : is_within(first, 0xf0, 0xf4) ? 4
                                                            : 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!is_within(byte(k), 0x80, 0xbf)) return 0;
  const unsigned char second = byte(1);
  const bool control = first == 0xc2 && second < 0xa0;
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_scalar = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return control || overlong || no_scalar ? 0 : length;
}

} // namespace

std::string_view code_of(Cause cause) {
  switch (cause) {
  case Cause::value:
    return "bad_value";
  case Cause::option:
    return "bad_option";
  case Cause::name:
    return "unknown_name";
  case Cause::kind:
    return "wrong_kind";
  case Cause::file:
    return "bad_file";
  case Cause::memory:
    return "no_memory";
  case Cause::content:
    break;
  }
  return "bad_content";
}

InputError::InputError(const std::string& said, Cause why)
    : std::runtime_error(said), message(said), cause(why) {}

InputError::InputError(const Place& at, const std::string& said, Cause why)
    : std::runtime_error(placed(at, said)), place(at), message(said), cause(why) {}

std::string printable(std::string_view text, Lines lines) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    const bool stays = lines == Lines::many && (text.front() == '\n' || text.front() == '\t');
    const std::size_t length = stays ? 1 : printable_length(text);
    clean += length > 0 ? text.substr(0, length) : "?";
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return clean;
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  constexpr std::size_t most_bytes = 2 * longest; // so that lines stay short in any script
  std::string text = "'";
  for (std::size_t shown = 0; !token.empty() && shown < longest && text.size() <= most_bytes; ++shown) {
    const std::size_t length = printable_length(token);
    text += length > 0 ? token.substr(0, length) : "?";
    token.remove_prefix(length > 0 ? length : 1);
  }
  if (!token.empty()) text += "...";
  return text + "'";
}

} // namespace tetrarch
