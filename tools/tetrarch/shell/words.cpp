// SPDX-License-Identifier: GPL-2.0-or-later
#include "words.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::program {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

} // namespace

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while (true) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size() || line[at] == '#') return words;
    std::string& word = words.emplace_back();
    char quote = 0;
    for (; at < line.size() && (quote != 0 || !is_blank(line[at])); ++at) {
      const char c = line[at];
      if (c == quote)
        quote = 0;
      else if (quote == 0 && (c == '\'' || c == '"'))
        quote = c;
      else if (c == '\\' && quote != '\'' && at + 1 < line.size())
        word += line[++at];
      else
        word += c;
    }
    if (quote != 0) throw InputError(std::string("a quote ") + quote + " does not end");
  }
}

std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\r\n#'\"\\") == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

} // namespace tetrarch::program
