// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/signature_text.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <vector>

namespace tetrarch::format {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::string_view decoration_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-_";

/// "(1,2)" at the end of `word`: where it begins; npos if there is none.
std::size_t last_filling(std::string_view word) {
  const std::size_t open = word.empty() || word.back() != ')' ? std::string_view::npos : word.rfind('(');
  if (open == std::string_view::npos) return open;
  const std::string_view inside = word.substr(open + 1, word.size() - open - 2);
  const std::size_t comma = inside.find(',');
  const bool two_numbers = comma != std::string_view::npos &&
                           parse_double(trimmed(inside.substr(0, comma))) &&
                           parse_double(trimmed(inside.substr(comma + 1)));
  return two_numbers ? open : std::string_view::npos;
}

bool is_no_filling(std::string_view filling) {
  const std::string_view inside = filling.substr(1, filling.size() - 2);
  const std::size_t comma = inside.find(',');
  return *parse_double(trimmed(inside.substr(0, comma))) == 0 &&
         *parse_double(trimmed(inside.substr(comma + 1))) == 0;
}

/// Digits alone are a taut angle structure, and then there is one for each tetrahedron.
void require_decoration(std::string_view decoration, int tetrahedra) {
  if (decoration.empty() || decoration.find_first_not_of(decoration_letters) != std::string_view::npos)
    throw InputError("found the decoration " + in_quotes(decoration) + ", expected letters or digits");
  if (decoration.find_first_not_of(digits) != std::string_view::npos) return;
  if (decoration.find_first_not_of("012") != std::string_view::npos ||
      decoration.size() != static_cast<std::size_t>(tetrahedra))
    throw InputError("found the decoration " + in_quotes(decoration) + ", expected " +
                     std::to_string(tetrahedra) + " digits 0, 1, 2, one for each tetrahedron");
}

/// The element on a line that is not empty.
Element element_on(std::string_view line, const Place& place) {
  const auto end = std::find_if(line.begin(), line.end(), is_space);
  const std::string_view word = line.substr(0, static_cast<std::size_t>(end - line.begin()));
  const std::string_view rest = trimmed(line.substr(word.size()));
  Element element;
  try {
    const std::string_view next = rest.substr(0, rest.find_first_of(" \t"));
    // A name may be "a", which is how the signature of no tetrahedra begins.
    if (!next.starts_with('a') && is_signature_text(next))
      throw InputError(found_expected(rest, "one signature a line"));
    element.document = read_signature_text(word);
    element.name = clean_line(rest);
    element.document.name = element.name;
  } catch (const InputError& e) {
    element.error = InputError(place, e.what());
  }
  return element;
}

} // namespace

bool is_signature_text(std::string_view word) {
  try {
    read_signature_text(word);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string_view without_fillings(std::string_view word, Ledger& passed_over) {
  std::vector<std::string_view> fillings;
  for (std::size_t at = last_filling(word); at != std::string_view::npos; at = last_filling(word)) {
    fillings.push_back(word.substr(at));
    word = word.substr(0, at);
  }
  for (std::size_t cusp = 0; cusp < fillings.size(); ++cusp) {
    const std::string_view filling = fillings[fillings.size() - 1 - cusp];
    if (!is_no_filling(filling))
      passed_over.note("Dehn filling " + std::string(filling) + " of cusp " + std::to_string(cusp) +
                       ", which is open here");
  }
  return word;
}

Document read_signature_text(std::string_view word) {
  Document document;
  const std::string_view plain = without_fillings(trimmed(word), document.passed_over);
  const std::size_t bar = plain.find('_');
  document.triangulation = from_signature(plain.substr(0, bar));
  if (bar == std::string_view::npos) return document;
  require_decoration(plain.substr(bar + 1), document.triangulation.size());
  document.passed_over.note("decoration " + std::string(plain.substr(bar)));
  return document;
}

std::vector<ListedLine> listed_lines(std::string_view text) {
  std::vector<ListedLine> lines;
  int number = 1;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    if (!line.empty() && line.front() != '#') lines.push_back({number, line});
    at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

Collection read_signatures(std::string_view text, const std::string& source) {
  Collection list;
  for (const ListedLine& line : listed_lines(text))
    list.elements.push_back(element_on(line.text, {source, line.number}));
  return list;
}

} // namespace tetrarch::format
