// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/collection.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::format {
namespace {

/// "('one', 'two', ...)" with a blank in front; empty if nothing has a name.
std::string names_text(const std::vector<Element>& elements) {
  constexpr std::size_t listed = 3;
  if (std::all_of(elements.begin(), elements.end(), [](const Element& e) { return e.name.empty(); }))
    return {};
  std::string text;
  for (std::size_t k = 0; k < std::min(elements.size(), listed); ++k)
    text += (k == 0 ? " (" : ", ") + in_quotes(elements[k].name);
  return text + (elements.size() > listed ? ", ...)" : ")");
}

} // namespace

Document document_of(Element element, const Ledger& passed_over) {
  if (element.error) throw InputError(*element.error);
  element.document.passed_over.add(passed_over);
  return std::move(element.document);
}

Document the_only(Collection collection, const std::string& source) {
  std::vector<Element>& elements = collection.elements;
  if (elements.empty())
    throw InputError(Place{source, 0}, "found no triangulations of 3-manifolds, expected one");
  if (elements.size() > 1)
    throw InputError(Place{source, 0}, "found " + std::to_string(elements.size()) +
                                           " triangulations of 3-manifolds" + names_text(elements) +
                                           ", expected one: say which by FILE#1 or FILE#NAME, or FILE#*");
  return document_of(std::move(elements.front()), collection.passed_over);
}

} // namespace tetrarch::format
