// SPDX-License-Identifier: GPL-2.0-or-later
#include "xml.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>

namespace tetrarch::format {

pugi::xml_document parse_xml(std::string_view text, const std::string& source, pugi::xml_encoding encoding) {
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, encoding);
  if (!result) {
    const auto offset = std::min(static_cast<std::size_t>(result.offset), text.size());
    throw InputError(Place{source, line_of(text, offset)},
                     std::string("the text is no XML: ") + result.description());
  }
  return document;
}

} // namespace tetrarch::format
