// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"

namespace tetrarch {
namespace {

std::string placed(const Place& place, const std::string& message) {
  std::string text = place.source;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  return text + message;
}

} // namespace

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

InputError::InputError(const Place& place, const std::string& message)
    : std::runtime_error(placed(place, message)) {}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : token.substr(0, longest)) text += (c >= ' ' && c < 0x7f) ? c : '?';
  if (token.size() > longest) text += "...";
  return text + "'";
}

} // namespace tetrarch
