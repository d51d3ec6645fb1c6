// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/collection.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/names.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/signature_text.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/workshop/nearest.hpp"
#include "tetrarch/workshop/text.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace tetrarch::workshop {
namespace {

std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find_first_of(" \t"));
}

constexpr std::size_t longest_name = 100;

std::optional<format::Document> named(std::string_view name) {
  if (const std::optional<diagram::Diagram> link = diagram::named_diagram(std::string(name)))
    return format::document_of(diagram::exterior(*link), std::string(name));
  if (std::optional<identify::Named> found = identify::find_named(name))
    return format::document_of(std::move(found->triangulation), found->name);
  return std::nullopt;
}

/// The manifold whose name is the line, or stands first on it.
std::optional<format::Document> named_on(std::string_view line) {
  if (line.size() > longest_name) return std::nullopt;
  std::optional<format::Document> found = named(line);
  return found ? std::move(found) : named(first_word(line));
}

/// What is no signature may be a name.
void look_up(format::Element& element, const format::ListedLine& line, const std::string& source) {
  constexpr std::size_t shortest_signature = 7; // of two tetrahedra and no boundary: nine letters
  try {
    if (std::optional<format::Document> found = named_on(line.text)) {
      element = {found->name, *std::move(found), {}};
    } else if (const std::string word(first_word(line.text)); word.size() < shortest_signature) {
      throw InputError(in_quotes(word) + " is no name of a manifold and no isomorphism signature" +
                       near_names(word, identify::listed_names()));
    }
  } catch (const InputError& e) { // or a name of no one meaning: "L(6,2)"
    element.error = InputError(Place{source, line.number}, e.what());
  }
}

bool begins_with_name(const std::vector<format::ListedLine>& lines) {
  try {
    return !lines.empty() && !format::is_signature_text(first_word(lines.front().text)) &&
           named_on(lines.front().text);
  } catch (const InputError&) {
    return true;
  }
}

} // namespace

format::Collection collection_in(std::string_view text, const std::string& source) {
  // The first line tells a list; the rest of a large file need not be parted into lines.
  const bool is_list = begins_with_name(format::listed_lines(text.substr(0, text.find_first_of("\r\n")))) ||
                       format::recognise(text, source) == format::FileFormat::signature;
  if (!is_list) return format::read_all(text, source);
  format::Collection list = format::read_signatures(text, source);
  const std::vector<format::ListedLine> lines = format::listed_lines(text);
  for (std::size_t k = 0; k < list.elements.size(); ++k)
    if (list.elements[k].error) look_up(list.elements[k], lines[k], source);
  return list;
}

} // namespace tetrarch::workshop
