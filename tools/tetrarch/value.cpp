// SPDX-License-Identifier: GPL-2.0-or-later
#include "value.hpp"

#include <algorithm>

namespace tetrarch::program {

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto inner = [&letter](char c) { return letter(c) || (c >= '0' && c <= '9'); };
  return !text.empty() && letter(text.front()) && std::all_of(text.begin(), text.end(), inner);
}

} // namespace tetrarch::program
