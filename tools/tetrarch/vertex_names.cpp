// SPDX-License-Identifier: GPL-2.0-or-later
#include "vertex_names.hpp"

#include "tetrarch/format/text.hpp"

namespace tetrarch::program {

std::optional<long long> vertex_in(std::string_view word) {
  if (word.starts_with('v')) word.remove_prefix(1);
  const auto number = format::parse_integer(word);
  return number && *number >= 0 ? number : std::nullopt;
}

std::vector<long long> vertices_in(const char* option, const std::string& word) {
  std::vector<long long> vertices;
  std::string_view rest = word;
  while (true) {
    const std::size_t comma = rest.find(',');
    const auto vertex = vertex_in(rest.substr(0, comma));
    if (!vertex) throw refusal(option, word, "expected vertices, separated by commas, such as 3,17,20");
    vertices.push_back(*vertex);
    if (comma == std::string_view::npos) return vertices;
    rest.remove_prefix(comma + 1);
  }
}

InputError refusal(const char* option, const std::string& word, const std::string& why) {
  return InputError(std::string(option) + " " + in_quotes(word) + ": " + why);
}

} // namespace tetrarch::program
